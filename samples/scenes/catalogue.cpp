#include "catalogue.hpp"

#include "scenes.hpp"
#include "steady.hpp"

namespace islet::samples {
namespace {

/// A scene of several starts, as the catalogue has it.
template <Scene (*make_start)(int)>
Scene first_start() {
    return make_start(0);
}

template <Scene (*make_start)(int)>
constexpr SceneInfo steady(const char* name, const char* description, int starts = 10) {
    return {name, "steady", description, first_start<make_start>, make_start, starts};
}

}  // namespace

const std::vector<SceneInfo>& catalogue() {
    static const std::vector<SceneInfo> list = {
        {"hello", "basics", "a box falls, lands and goes to sleep", make_hello},
        {"projectile", "basics", "balls thrown at seven angles follow their parabolas", make_projectile},
        {"bounce", "basics", "balls of restitution 0 to 1 rebound to e^2 h", make_bounce},
        {"friction_ramp", "basics", "boxes of six roughnesses on a slope: three slide, three hold", make_friction_ramp},
        {"endless_slope", "basics", "on a slope without end a disc rolls, a smooth box slides and a rough one stays", make_endless_slope},
        {"rolling", "basics", "a sliding disc, a rolling disc and a ring race down a slope", make_rolling},
        {"newtons_cradle", "basics", "a ball strikes a row of seven, and only the last one leaves", make_newtons_cradle},
        {"pendulum", "basics", "pendulums swing as slowly as the elliptic integral says", make_pendulum},
        {"double_pendulum", "basics", "two rods swing wildly and keep their energy", make_double_pendulum},
        {"far_from_origin", "basics", "a pyramid stands 10 km out, where a float steps by a millimetre", make_far_from_origin},
        {"pyramid", "stacks", "ten rows of boxes stand for a minute", make_pyramid},
        {"vertical_stack", "stacks", "thirty boxes, one on another, stand for a minute", make_vertical_stack},
        {"dominoes", "stacks", "thirty dominoes fall, each by the one behind it", make_dominoes},
        {"card_house", "stacks", "a house of cards, five storeys high, stands for a minute", make_card_house},
        {"arch", "stacks", "seventeen wedges make an arch that stands by friction alone", make_arch},
        {"mass_ratio", "stacks", "boxes carry a load three hundred times their weight", make_mass_ratio},
        {"confined", "stacks", "circles squeezed into a closed box come to rest", make_confined},
        {"cairn", "stacks", "irregular stones, piled one on another, stay piled", make_cairn},
        {"rope", "joints", "balls fall freely until their ropes catch them", make_rope},
        {"chain_ball", "joints", "a ball a thousand times heavier than a link swings on a chain of thirty", make_chain_ball, make_chain_ball_from, 10},
        {"bridge", "joints", "a bridge of planks hangs as a chain does, and bears five boxes", make_bridge},
        {"breakable_bridge", "joints", "a bridge bears three boxes and breaks under a heavy ball", make_breakable_bridge},
        {"door", "joints", "three doors: one is struck, one coasts, one closes itself", make_door},
        {"seesaw", "joints", "a plank balances by the law of the lever, then tips to its limit", make_seesaw},
        {"elevator", "joints", "a cabin with riders goes up and down on a slider with a motor", make_elevator},
        {"pulley", "joints", "weights on pulleys, one of them a tackle of two, rise and fall", make_pulley},
        {"gears", "joints", "three toothed wheels on a motor lift a toothed bar", make_gears},
        {"ratchet", "joints", "four discs tied by angle joints: two ratchets, a spring and a brake", make_ratchet},
        {"scissor_lift", "joints", "crossed bars lift a platform as a carriage pulls their feet together", make_scissor_lift},
        {"car", "joints", "a car on sprung struts drives over waves", make_car},
        {"ragdoll", "joints", "three ragdolls tumble down a stair and come to rest", make_ragdoll},
        {"ragdoll_pile", "joints", "twelve ragdolls fall into a pen and come to rest in a heap", make_ragdoll_pile},
        {"mouse_drag", "joints", "a hand pulls a box out of a pile and holds it up", make_mouse_drag},
        {"cloth", "soft", "a cloth hung up by two corners loses one of its nails", make_cloth_scene},
        {"flag", "soft", "pennants in a wind that grows with the height stream out at four angles", make_flag},
        {"blob", "soft", "three rings full of gas fall, and rest the flatter the less they hold", make_blob},
        {"soft_stack", "soft", "soft bodies carry crates, and crates carry soft bodies", make_soft_stack},
        {"cable_bridge", "soft", "a deck hangs from a cable between two towers, and a car crosses it", make_cable_bridge},
        {"gripper", "robots", "a gripper lifts a box by friction, carries it 2 m and puts it down", make_gripper_scene},
        {"walker", "robots", "six legs of Theo Jansen's linkage on one crank walk more than 5 m", make_walker},
        {"arm", "robots", "an arm of three bars, its joints driven by motors, draws circles", make_arm},
        {"quadruped", "robots", "a four-legged robot lies on its belly and stands up", make_quadruped},
        {"hourglass", "granular", "grains run through an hourglass, to the last one", make_hourglass},
        {"silo", "granular", "a silo empties at a steady rate, however full it is", make_silo},
        {"avalanche", "granular", "smooth and rough pebbles slide off a ledge and leave two slopes", make_avalanche},
        {"mixer", "granular", "a stirrer mixes discs with hexagons", make_mixer},
        {"sensors", "play", "balls fall through three gates, which count them, into a tray", make_sensors},
        {"explosion", "play", "a charge among sixteen crates goes off", make_explosion},
        {"wind", "play", "discs fall until the air bears them, and a wind holds one up", make_wind},
        {"conveyor", "play", "boxes set down on four belts take on their speeds", make_conveyor},
        {"platformer", "play", "a character walks, climbs, rides, pushes and jumps through a course", make_platformer},
        {"bullets", "play", "shots at up to 900 m/s find no way through a wall of 2 cm", make_bullets},
        {"pinball", "play", "a ball is shot, bumped and flipped, and stays on the table", make_pinball},
        {"merge", "play", "two pieces of a puzzle interlock, hold while they are pulled, and part the open way", make_merge},
        steady<make_wedge_at_wall>("wedge_at_wall", "a wedge slides along a floor into a wall and stays out of both", 24),
        steady<make_v_grooves>("v_grooves", "squares come to rest in six grooves of two planks"),
        steady<make_crossing_walls>("crossing_walls", "eight triangles stay in a room of thin walls that cross", 60),
        steady<make_landings>("landings", "what falls from up to 20 m stops at the surface", 24),
        steady<make_plates_at_walls>("plates_at_walls", "plates at 120 and 300 m/s stop at the face of a wall", 16),
        steady<make_laid_segments>("laid_segments", "a ball rolls over segments laid end to end and keeps its speed"),
        steady<make_tiled_floor>("tiled_floor", "a box slides over tiles at 50 m/s and meets no bump"),
        steady<make_flat_bounce>("flat_bounce", "boxes that land flat bounce flat"),
        steady<make_free_cluster>("free_cluster", "36 bodies collide in space and keep their momentum"),
        steady<make_tall_columns>("tall_columns", "columns of 30, 60 and 100 boxes stand for a minute"),
        steady<make_crooked_columns>("crooked_columns", "columns of 60 boxes, laid carelessly, stand"),
        steady<make_loaded_columns>("loaded_columns", "light boxes carry 100 and 300 times their weight for a minute"),
        steady<make_resting_stacks>("resting_stacks", "columns and a wall of bricks fall asleep and have not sunk"),
        steady<make_weighed_stack>("weighed_stack", "the ground feels the weight of a stack", 20),
        steady<make_tall_card_house>("tall_card_house", "a house of cards, seven storeys high, stands for a minute"),
        steady<make_mixed_pile>("mixed_pile", "polygons of three to eight corners settle in a bin"),
        steady<make_settling_pile>("settling_pile", "500 boxes fall into a bin and fall asleep"),
        steady<make_wild_pendulum>("wild_pendulum", "a double pendulum swings over for ten minutes"),
        steady<make_rods_in_space>("rods_in_space", "three hinged rods turn in space for ten minutes"),
        steady<make_spun_rod>("spun_rod", "a hinged rod turns ten times a second"),
        steady<make_long_bridges>("long_bridges", "bridges of sixty planks bear crates of 100 and 1000 kg"),
        steady<make_hung_net>("hung_net", "a net of 1600 discs hangs from two of its corners"),
        steady<make_whirled_doll>("whirled_doll", "a ragdoll is whirled around by fifty times its weight"),
        {"large_pyramid", "benchmark", "one pyramid with 100 boxes at its base", make_large_pyramid},
        {"many_pyramids", "benchmark", "400 pyramids of 55 boxes, in 20 rows", make_many_pyramids},
        {"joint_grid", "benchmark", "a net of 10000 discs, hinged to their neighbours, hangs from seven of them", make_joint_grid, make_joint_grid_from, 10},
        {"tumbler", "benchmark", "2000 boxes in a square drum on a motor", make_tumbler},
        {"washer", "benchmark", "8100 boxes tumble in a turning drum with paddles", make_washer, make_washer_from, 10},
        {"spinner", "benchmark", "a long paddle on a motor stirs 6000 bodies in a ring", make_spinner},
        {"rain", "benchmark", "a thousand ragdolls, made and destroyed, rain on five floors", make_rain},
        {"smash", "benchmark", "a heavy box at 40 m/s hits a sleeping wall of 9600 bricks", make_smash},
        {"compounds", "benchmark", "3000 bodies of two triangles each fall into a trough", make_compounds, make_compounds_from, 10},
        {"junkyard", "benchmark", "a pusher sweeps through 8000 irregular pentagons", make_junkyard, make_junkyard_from, 10},
    };
    return list;
}

const SceneInfo* find_scene(const std::string& name) {
    for (const SceneInfo& info : catalogue()) {
        if (name == info.name) return &info;
    }
    return nullptr;
}

}  // namespace islet::samples
