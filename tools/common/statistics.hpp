// What is said of many measurements of one thing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace islet::tools {

/// The middle value, or the mean of the two middle ones; 0 of none.
inline double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// The smallest value that at least `percent` % of the values do not exceed (nearest rank); 0 of none.
inline double percentile(std::vector<double> values, double percent) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(percent / 100 * double(values.size())));
    return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

}  // namespace islet::tools
