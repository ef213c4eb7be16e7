// What `islet run` writes: a table for people, a JSON object for programs, a CSV line per step.
#pragma once

#include <string>

#include "runner.hpp"

namespace islet::tools {

std::string table_of(const RunResult& result);
std::string json_of(const RunResult& result);
std::string csv_header();
std::string csv_line(const StepRecord& record, const Run& run);

std::string catalogue_table();
std::string catalogue_json();

}  // namespace islet::tools
