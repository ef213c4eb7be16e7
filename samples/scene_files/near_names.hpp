// What a wrong name may have been meant for.
#pragma once

#include <string>
#include <vector>

namespace islet::samples {

/// Of the names that are known those close to a wrong one (edit distance, or one a part of the other), nearest first.
std::vector<std::string> near_names(const std::string& name, const std::vector<std::string>& known);

}  // namespace islet::samples
