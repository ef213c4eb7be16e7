// The answer that others are held against.
#pragma once

#include <string>
#include <vector>

#include "problem.hpp"

namespace islet::lab {

struct Reference {
    std::vector<double> x;
    std::string how;      // the methods that led to it, in words
    double residual = 0;  // its own, of the scaled problem

    bool exact() const { return residual <= good_enough; }
    /// Rounding leaves about 1e-14; what is looked at are residuals down to 1e-6.
    static constexpr double good_enough = 1e-10;
};

/// Tries Newton from the warm start and from zero, Lemke with Newton after it (both for at most `dense_rows` rows), and very long runs of nncg and pgs, with
/// Newton after each, until one is exact; else the best is taken. Everything is in double.
Reference find_reference(const Problem& scaled, std::size_t dense_rows);

/// How far the velocities of x are from the reference's: the root of the kinetic energy of the difference over that of what the reference's impulses do,
/// sqrt((x - x*) . M (x - x*)) / sqrt(x* . M x*). It is 0 also for another x that moves the bodies alike. Without the division if that is 0.
double velocity_error(const Problem& scaled, const std::vector<double>& x, const Reference& reference);

}  // namespace islet::lab
