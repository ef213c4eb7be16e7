#include "scene_files/near_names.hpp"

#include <algorithm>
#include <numeric>

namespace islet::samples {
namespace {

/// Insertions, deletions and replacements that turn a into b (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
        }
    }
    return row.back();
}

}  // namespace

std::vector<std::string> near_names(const std::string& name, const std::vector<std::string>& known) {
    struct Candidate {
        std::size_t distance;
        std::string name;
    };
    std::vector<Candidate> candidates;
    for (const std::string& other : known) {
        const bool part = name.size() >= 3 && (other.find(name) != std::string::npos || name.find(other) != std::string::npos);
        const std::size_t distance = part ? 1 : edit_distance(name, other);
        if (distance <= std::max<std::size_t>(2, other.size() / 3)) candidates.push_back({distance, other});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    std::vector<std::string> names;
    names.reserve(candidates.size());
    for (const Candidate& candidate : candidates) names.push_back(candidate.name);
    return names;
}

}  // namespace islet::samples
