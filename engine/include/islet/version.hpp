// The version of Islet. Versions are semantic (semver.org). While the first number is 0, the second goes up when programs or files must change.
//
//     #if ISLET_VERSION >= 300  // 0.3.0 or later
//
// CHANGELOG.md lists the changes of each version, and docs/versions.md the formats that each version reads.
#pragma once

#include "islet/standard.hpp"

#define ISLET_VERSION_MAJOR 0
#define ISLET_VERSION_MINOR 2
#define ISLET_VERSION_PATCH 0
/// The three as one number that can be compared: 203 is 0.2.3, 10203 is 1.2.3.
#define ISLET_VERSION (ISLET_VERSION_MAJOR * 10000 + ISLET_VERSION_MINOR * 100 + ISLET_VERSION_PATCH)
/// The version as text.
#define ISLET_VERSION_STRING "0.2.0"
