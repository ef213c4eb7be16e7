// A finding made small, and printed as a program.
#pragma once

#include <string>

#include "play.hpp"

namespace islet::lockstep {

/// Calls made again in worlds as `setup` says, in a process of their own: what broke, empty if nothing did.
std::string attempt(const Setup& setup, const Deeds& deeds);

/// Leaves out of the calls, and makes simpler, what is not needed for `what` to break. Takes `seconds` at most.
void shrink(Setup& setup, Deeds& deeds, const std::string& what, double seconds);

/// The same calls, with the ids that they give and take now that others are left out.
Deeds renamed(const Setup& setup, const Deeds& deeds);

/// A program against the public API that makes the calls and shows what breaks.
std::string program(const Setup& setup, const Deeds& deeds, const std::string& what);

double seconds_now();

}  // namespace islet::lockstep
