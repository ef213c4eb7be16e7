// Islet: a 2D rigid-body physics engine in one fixed block of memory. This header includes all public headers except fleet.hpp, lcp.hpp, island.hpp
// and hash.hpp.
#pragma once

#include "islet/debug_draw.hpp"
#include "islet/fault.hpp"
#include "islet/format.hpp"
#include "islet/geometry.hpp"
#include "islet/joints.hpp"
#include "islet/layout.hpp"
#include "islet/math.hpp"
#include "islet/mover.hpp"
#include "islet/query.hpp"
#include "islet/ranges.hpp"
#include "islet/recording.hpp"
#include "islet/snapshot.hpp"
#include "islet/tasks.hpp"
#include "islet/types.hpp"
#include "islet/version.hpp"
#include "islet/world.hpp"
