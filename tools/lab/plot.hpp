// Pictures of how the residuals fall, drawn by gnuplot.
#pragma once

#include <string>

#include "measure.hpp"

namespace islet::lab {

/// True if there is a gnuplot to be called.
bool can_plot();

/// Gnuplot's commands and data for one picture, that writes SVG to `path`: from zero above and from the warm start below, against iterations on the left
/// and time on the right. Residuals below a tenth of the last level are drawn there.
std::string plot_script(const IslandReport& report, const std::string& path);

/// Runs a script. False if gnuplot is not there, or complains (on standard error).
bool run_gnuplot(const std::string& script);

}  // namespace islet::lab
