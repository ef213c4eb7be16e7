// Scenes that show whether contacts and joints hold: nothing passes, sinks, sways or gains energy. Each has several starts (offsets, angles, speeds or
// seeds), and lines in its check that say what is wanted of all of them (Wanted in harness/scene.hpp). `islet steady` runs them all and prints the table.
#pragma once

#include "harness/scene.hpp"

namespace islet::samples {

// contacts
Scene make_wedge_at_wall(int start);
Scene make_v_grooves(int start);
Scene make_crossing_walls(int start);
Scene make_landings(int start);
Scene make_plates_at_walls(int start);
Scene make_laid_segments(int start);
Scene make_tiled_floor(int start);
Scene make_flat_bounce(int start);
Scene make_free_cluster(int start);

// stacks and piles
Scene make_tall_columns(int start);
Scene make_crooked_columns(int start);
Scene make_loaded_columns(int start);
Scene make_resting_stacks(int start);
Scene make_weighed_stack(int start);
Scene make_tall_card_house(int start);
Scene make_mixed_pile(int start);
Scene make_settling_pile(int start);

// joints
Scene make_wild_pendulum(int start);
Scene make_rods_in_space(int start);
Scene make_long_bridges(int start);
Scene make_hung_net(int start);
Scene make_whirled_doll(int start);
Scene make_spun_rod(int start);

// Starts of scenes that the catalogue has for other reasons too.
Scene make_chain_ball_from(int start);
Scene make_joint_grid_from(int start);
Scene make_compounds_from(int start);
Scene make_junkyard_from(int start);
Scene make_washer_from(int start);

}  // namespace islet::samples
