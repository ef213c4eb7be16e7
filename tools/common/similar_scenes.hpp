// Scenes that a wrong name may have been meant for.
#pragma once

#include <string>
#include <vector>

namespace islet::tools {

/// Names close to a wrong one (edit distance), nearest first.
std::vector<std::string> similar_scenes(const std::string& name);

}  // namespace islet::tools
