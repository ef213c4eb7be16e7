// What the two engines must agree on, scene by scene, and whether they did.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace islet::compare {

inline constexpr double not_judged = -1;

/// Limits for one scene; a negative one is not judged. Each bounds the difference of the two engines unless said otherwise.
struct Tolerance {
    const char* scene = "";
    int steps = 0;    // how long both run
    int horizon = 0;  // steps over which the trajectory is judged; 0: only the settled state and the invariants are

    double rms_position = not_judged;        // m, over the horizon
    double max_position = not_judged;        // m, over the horizon
    double rms_angle = not_judged;           // rad, over the horizon
    double final_rms_position = not_judged;  // m, after the last step

    double mean_height = not_judged;  // m, after the last step
    double top_height = not_judged;   // m, after the last step
    double at_rest = not_judged;      // share of bodies, after the last step

    double energy_drift = not_judged;       // share of the scene's energy
    double energy_gain = not_judged;        // Islet alone: share of the scene's energy it may ever gain
    double known_energy_gain = not_judged;  // where Islet is known to exceed it, as for penetration
    double momentum_drift = not_judged;     // Islet alone: share of the momentum it may lose or gain
    double penetration = not_judged;        // m, Islet alone: deeper than the reference, what a user would accept
    double known_penetration = not_judged;  // m; where Islet is known to exceed `penetration`: a shortfall, up to which the comparison still passes

    const char* reason = "";
};

/// All comparable scenes, in the catalogue's order.
const std::vector<Tolerance>& tolerances();
/// The entry of that scene, or null.
const Tolerance* find_tolerance(const std::string& scene);

/// One thing that was judged.
struct Check {
    std::string name;                                               // the tolerance's field
    double value = 0;                                               // what must not exceed the limit
    double limit = 0;                                               // what a user would accept
    double known = not_judged;                                      // a shortfall that is known: how far beyond the limit it may go
    bool is_short() const { return !(value <= limit); }             // NaN is
    bool pass() const { return value <= limit || value <= known; }  // NaN fails
};

std::vector<Check> judge(const Run& run, const Tolerance& tolerance);

/// Everything known about one compared scene.
struct Comparison {
    std::string scene;
    std::string reference;  // its name and version
    std::string lacks;      // why the reference cannot run it; empty if it can, and only then is there a run
    Run run;
    std::vector<Check> checks;
    bool pass() const;
    bool is_short() const;  // some value exceeds what a user would accept
};

}  // namespace islet::compare
