#include "catalogue.hpp"

#include "scenes.hpp"

namespace islet::samples {

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
        {"chain_ball", "joints", "a ball a thousand times heavier than a link swings on a chain of thirty", make_chain_ball},
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
        {"large_pyramid", "benchmark", "one pyramid with 100 boxes at its base", make_large_pyramid},
        {"many_pyramids", "benchmark", "400 pyramids of 55 boxes, in 20 rows", make_many_pyramids},
        {"joint_grid", "benchmark", "a net of 10000 discs, hinged to their neighbours, hangs from seven of them", make_joint_grid},
        {"tumbler", "benchmark", "2000 boxes in a square drum on a motor", make_tumbler},
        {"washer", "benchmark", "8100 boxes tumble in a turning drum with paddles", make_washer},
        {"spinner", "benchmark", "a long paddle on a motor stirs 6000 bodies in a ring", make_spinner},
        {"rain", "benchmark", "a thousand ragdolls, made and destroyed, rain on five floors", make_rain},
        {"smash", "benchmark", "a heavy box at 40 m/s hits a sleeping wall of 9600 bricks", make_smash},
        {"compounds", "benchmark", "3000 bodies of two triangles each fall into a trough", make_compounds},
        {"junkyard", "benchmark", "a pusher sweeps through 8000 irregular pentagons", make_junkyard},
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
