// The fleet of fleets.c.
#ifndef ISLET_TESTS_C_FLEETS_H
#define ISLET_TESTS_C_FLEETS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { fleet_worlds = 19, fleet_drives = 3, fleet_columns = 11, fleet_rounds = 40 };

/// What a fleet came to: every world's hash and all observations after each round.
struct FleetStory {
    uint64_t hashes[fleet_rounds][fleet_worlds];
    float observations[fleet_rounds][fleet_worlds * fleet_columns];
    size_t bytes;  // of the fleet's block
};

/// Actions of a round, from -1 to 1.
void fleet_actions(unsigned round, float* actions);
/// Steps, observes, resets, copies and forks a fleet. False if something was refused.
bool tell_fleet_story(struct FleetStory* story);
/// Calls that must be refused: prints those that are not. 0 if all were.
int refuse_fleet_calls(void);

#ifdef __cplusplus
}
#endif

#endif
