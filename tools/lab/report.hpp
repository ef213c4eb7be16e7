// What islet-lab prints: a table for each island, JSON, and CSV.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace islet::lab {

/// "psor 1.3": the method, and its relaxation where that is not 1.
std::string label_of(const Measurement& measurement);

std::string table_of(const IslandReport& report);
/// A list with an object for each island, method and start; README.md names the keys.
std::string json_of(const std::vector<IslandReport>& reports);
/// A line for each point of thinned(), and a header.
std::string csv_of(const std::vector<IslandReport>& reports);

}  // namespace islet::lab
