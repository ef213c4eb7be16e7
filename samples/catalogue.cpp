// The list of scenes, how to find one by name, and how much room one needs.
#include <algorithm>
#include <cstring>
#include <set>
#include <type_traits>

#include "near_names.hpp"
#include "scenes/scenes.hpp"

namespace islet::samples {
namespace {

void append_floats(std::string& bytes, std::initializer_list<Vec2> points, float radius) {
    for (const Vec2 p : points) bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
    bytes.append(reinterpret_cast<const char*>(&radius), sizeof radius);
}

/// The geometry's numbers as bytes, headed by its kind: equal exactly for geometries that a world stores once. Chains are not asked.
std::string key_of(const SceneGeometry& geometry) {
    std::string bytes(1, static_cast<char>('0' + geometry.index()));
    if (const auto* circle = std::get_if<Circle>(&geometry)) append_floats(bytes, {circle->center}, circle->radius);
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) append_floats(bytes, {capsule->point1, capsule->point2}, capsule->radius);
    if (const auto* segment = std::get_if<Segment>(&geometry)) append_floats(bytes, {segment->point1, segment->point2}, 0);
    if (const auto* polygon = std::get_if<Polygon>(&geometry)) {
        for (std::uint32_t i = 0; i < polygon->count; ++i)
            append_floats(bytes, {polygon->vertices[i], polygon->normals[i]}, polygon->radius);
    }
    return bytes;
}

std::uint32_t chain_segments(const Chain& chain) {
    const auto points = static_cast<std::uint32_t>(chain.points.size());
    return chain.loop ? points : points - std::min(points, 1u);
}

}  // namespace

const std::vector<SceneInfo>& catalogue() {
    static const std::vector<SceneInfo> list = {
        {"hello", "basics", "a box falls, lands and goes to sleep", make_hello},
        {"projectile", "basics", "balls thrown at seven angles follow their parabolas", make_projectile},
        {"bounce", "basics", "balls of restitution 0 to 1 rebound to e^2 h", make_bounce},
        {"friction_ramp", "basics", "boxes of six roughnesses on a slope: three slide, three hold", make_friction_ramp},
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

std::vector<std::string> similar_scenes(const std::string& name) {
    std::vector<std::string> known;
    for (const SceneInfo& info : catalogue()) known.emplace_back(info.name);
    return near_names(name, known);
}

Capacity capacity_of(const Scene& scene) {
    std::uint64_t shapes = 0, moving_shapes = 0, chain_geometries = 0;
    std::set<std::string> geometries;
    for (const SceneBody& body : scene.bodies) {
        for (const SceneShape& shape : body.shapes) {
            std::uint32_t count = 1;
            if (const auto* chain = std::get_if<Chain>(&shape.geometry)) {
                count = chain_segments(*chain);
                chain_geometries += count;
            } else {
                geometries.insert(key_of(shape.geometry));
            }
            shapes += count;
            if (body.def.type != BodyType::static_body) moving_shapes += count;
        }
    }
    shapes += scene.extra_shapes;
    moving_shapes += scene.extra_shapes;
    // A dense pile has 3 to 5 pairs of overlapping fat boxes a shape; the rest is room for a pile being squeezed.
    constexpr std::uint32_t pairs_per_shape = 7, spare_pairs = 32;
    // A file may ask for more than can be: no world has such a capacity, and none is made.
    const auto room = [](std::uint64_t n) { return static_cast<std::uint32_t>(std::min<std::uint64_t>(n, 0xffffffffu)); };
    Capacity capacity;
    capacity.bodies = std::max(1u, room(scene.bodies.size() + std::uint64_t{scene.extra_bodies}));
    capacity.shapes = std::max(1u, room(shapes));
    capacity.contacts = room(pairs_per_shape * moving_shapes + spare_pairs + scene.extra_contacts);
    capacity.joints = room(scene.joints.size() + std::uint64_t{scene.extra_joints});
    capacity.geometries = std::max(1u, room(geometries.size() + chain_geometries + scene.extra_shapes));
    return capacity;
}

}  // namespace islet::samples
