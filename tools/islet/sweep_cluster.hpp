// A sweep on a cluster: the package for Python knows those.
#pragma once

#include <string>

namespace islet::tools {

/// Becomes `python3 -m islet.sweep` with all words of the command line but `islet sweep`. Comes back only if that cannot be started, and says why.
std::string sweep_on_cluster(int argc, char** argv);

}  // namespace islet::tools
