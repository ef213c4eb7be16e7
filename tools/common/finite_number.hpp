// A check of the command line's numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace islet::tools {

/// A range lets NaN through, since NaN is neither below nor above anything.
inline std::string finite_number(const std::string& text) {
    double value = 0;
    return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? std::string() : "must be a finite number: " + text;
}

}  // namespace islet::tools
