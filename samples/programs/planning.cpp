// Planning by forking worlds. For each decision 256 futures of 30 steps start as copies of the world as it is now, each with speeds of its own for the motors;
// the best future says what the motors do next.
//
//     planning [arm]     an arm with two links and two motors follows a point that moves on a circle
//     planning walker    a hull on two legs with four motors walks, and does not fall
#include <cstdio>
#include <cstring>
#include <vector>

#include <islet/fleet.hpp>
#include <islet/islet.hpp>

using namespace islet;

static constexpr std::uint32_t futures = 256, horizon = 30;  // steps
static constexpr std::uint32_t most_motors = 4, most_pieces = 6;

/// What is planned for.
struct Machine {
    World& world;
    float dt;                // s
    std::uint32_t pieces;    // of a future, each with its own speeds
    std::uint32_t decision;  // steps that a decision lasts
    std::uint32_t rounds;    // of 256 futures for each decision
    float width;             // rad/s, by which the first round changes the plan at most; a third of it in each next one
    bool mostly_little;      // whether most changes are small
    std::vector<JointId> motors;
    std::vector<Sense> senses;
    float (*cost)(const float* seen, float time);  // of a moment, of which the senses have told
};

static JointId add_motor(World& world, BodyId a, BodyId b, Vec2 at_a, Vec2 at_b, float max_force, JointLimit limit = {}) {
    RevoluteJointDef def{.base = {.body_a = a, .body_b = b, .frame_a = {at_a}, .frame_b = {at_b}}};
    def.limit = limit;
    def.motor = {.enable = true, .max_force = max_force};
    return world.create_joint(def);
}

// -- the arm ---------------------------------------------------------------------------------------------------------------------------------------

static constexpr float link_length = 1;  // m
static StaticWorld<Capacity{.bodies = 3, .shapes = 3, .contacts = 8, .joints = 2}> arm_storage;

static BodyId make_link(World& world, float x) {
    const BodyId body = world.create_body({.type = BodyType::dynamic, .position = {x, 0}, .enable_sleep = false});
    world.create_shape(body, make_box(link_length / 2, 0.05f), {.density = 10, .filter = {.mask = 0}});
    return body;
}

/// The hand's tip, from the pose of the last link.
static Vec2 tip(const float* pose) { return {pose[0] + link_length / 2 * pose[2], pose[1] + link_length / 2 * pose[3]}; }

/// The point to follow: on a circle of 0.5 m about (1, 0.5), once in 4 s.
static Vec2 goal(float time) {
    const Rot turn = make_rot(2 * pi / 4 * time);
    return {1 + 0.5f * turn.c, 0.5f + 0.5f * turn.s};
}

/// Two links in a row, the first on the ground; their motors have 40 and 20 N m. What it costs is how far the tip is from the goal.
static Machine make_arm() {
    World& world = arm_storage.create({});
    const BodyId ground = world.create_body({}), upper = make_link(world, link_length / 2), hand = make_link(world, 1.5f * link_length);
    const JointId shoulder = add_motor(world, ground, upper, {0, 0}, {-link_length / 2, 0}, 40);
    const JointId elbow = add_motor(world, upper, hand, {link_length / 2, 0}, {-link_length / 2, 0}, 20);
    return {.world = world,
            .dt = 1.0f / 60,
            .pieces = 3,
            .decision = 5,
            .rounds = 2,
            .width = 3,
            .mostly_little = false,
            .motors = {shoulder, elbow},
            .senses = {{.kind = SenseKind::position, .body = hand}, {.kind = SenseKind::rotation, .body = hand}},
            .cost = [](const float* seen, float time) { return length_squared(tip(seen) - goal(time)); }};
}

// -- the walker ------------------------------------------------------------------------------------------------------------------------------------

static constexpr float leg_half = 0.25f;  // m, half a part of a leg
static StaticWorld<Capacity{.bodies = 6, .shapes = 6, .contacts = 32, .joints = 4}> walker_storage;

/// Faster or slower than 1 m/s, low, leaning, spinning, and most of all fallen.
static float walker_cost(const float* seen, float) {
    const float slow = seen[4] - 1, low = min(seen[1] - 1, 0.0f), lean = seen[3], spin = seen[6];
    const float cost = slow * slow + 300 * low * low + 8 * lean * lean + 0.05f * spin * spin;
    return seen[1] < 0.75f ? cost + 20 : cost;
}

/// A hull of 1.15 m height on two legs, whose hips and knees have motors of 100 N m. It stands with bent knees, one foot before the other.
static Machine make_walker() {
    World& world = walker_storage.create({.enable_sleep = false});
    const BodyId ground = world.create_body({});
    world.create_shape(ground, make_offset_box(50, 1, {{40, -1}, {}}), {.friction = 1});
    const Filter own = {.group = -1};
    const BodyId hull = world.create_body({.type = BodyType::dynamic, .position = {0, 1.15f}});
    world.create_shape(hull, make_box(0.4f, 0.15f), {.density = 20, .filter = own});
    std::vector<JointId> motors;
    for (const float thigh_angle : {-0.2f, 0.4f}) {
        BodyId above = hull;
        Vec2 hip = {0, -0.1f}, at = {0, 1.05f};
        for (const float angle : {thigh_angle, thigh_angle - 0.3f}) {
            const Rot turn = make_rot(angle);
            const BodyId leg = world.create_body({.type = BodyType::dynamic, .position = {at.x + leg_half * turn.s, at.y - leg_half * turn.c}, .angle = angle});
            world.create_shape(leg, make_box(0.06f, leg_half), {.friction = 1, .density = 10, .filter = own});
            const bool is_thigh = above == hull;
            motors.push_back(
                add_motor(world, above, leg, hip, {0, leg_half}, 100, {.enable = true, .lower = is_thigh ? -0.8f : -1.6f, .upper = is_thigh ? 1.1f : -0.1f}));
            at = {at.x + 2 * leg_half * turn.s, at.y - 2 * leg_half * turn.c};
            above = leg;
            hip = {0, -leg_half};
        }
    }
    return {.world = world,
            .dt = 1.0f / 40,
            .pieces = 6,
            .decision = 5,
            .rounds = 2,
            .width = 6,
            .mostly_little = true,
            .motors = motors,
            .senses = {{.kind = SenseKind::position, .body = hull},
                       {.kind = SenseKind::rotation, .body = hull},
                       {.kind = SenseKind::velocity, .body = hull},
                       {.kind = SenseKind::angular_velocity, .body = hull}},
            .cost = walker_cost};
}

// -- planning --------------------------------------------------------------------------------------------------------------------------------------

/// Evenly spread over -1 to 1 (SplitMix64).
static float random_number(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return static_cast<float>((z ^ z >> 31) >> 40) * 0x1p-23f - 1;
}

/// What the motors do in each piece of a future, rad/s.
struct Plan {
    float speeds[most_pieces][most_motors] = {};
};

class Planner {
public:
    explicit Planner(const Machine& machine)
        : machine_(machine),
          block_(Fleet::bytes(futures, machine.world.capacity()) / sizeof(Line) + 1),
          fleet_(*Fleet::create({reinterpret_cast<std::byte*>(block_.data()), block_.size() * sizeof(Line)}, machine.world, futures)) {
        for (const JointId motor : machine.motors) drives_.push_back({.kind = DriveKind::motor_speed, .joint = motor});
    }

    /// Does for the time of a decision what the first piece of the best plan says: the best of 256 plans around the last one, of which future 0 keeps that.
    void act() {
        World& world = machine_.world;
        image_.resize(world.snapshot_bytes());
        world.save(image_);
        float width = machine_.width;
        for (std::uint32_t round = 0; round < machine_.rounds; ++round, width /= 3) {
            for (std::uint32_t k = 0; k < futures; ++k)
                for (std::uint32_t piece = 0; piece < machine_.pieces; ++piece)
                    for (std::uint32_t motor = 0; motor < drives_.size(); ++motor)
                        tried_[k].speeds[piece][motor] = best_.speeds[piece][motor] + (k == 0 ? 0 : width * change());
            best_ = tried_[cheapest()];
        }
        for (std::uint32_t i = 0; i < machine_.motors.size(); ++i) {
            JointMotor motor = world.motor(machine_.motors[i]);
            motor.speed = best_.speeds[0][i];
            world.set_motor(machine_.motors[i], motor);
        }
        if (machine_.decision == horizon / machine_.pieces)  // the first piece is done
            for (std::uint32_t piece = 1; piece < machine_.pieces; ++piece)
                std::memcpy(best_.speeds[piece - 1], best_.speeds[piece], sizeof best_.speeds[piece]);
        for (std::uint32_t step = 0; step < machine_.decision; ++step, time_ += machine_.dt) world.step(machine_.dt);
    }
    float time() const { return time_; }  // s, of the machine's world
    std::size_t bytes() const { return block_.size() * sizeof(Line); }

private:
    struct alignas(world_alignment) Line {
        std::byte bytes[world_alignment];
    };

    float change() {
        const float even = random_number(random_);
        return machine_.mostly_little ? even * even * even : even;
    }

    /// Tries the plans.
    std::uint32_t cheapest() {
        fleet_.reset(0, image_);
        const std::vector<std::uint32_t> all_of_the_first(futures, 0);
        fleet_.fork(all_of_the_first);
        const std::size_t motors = drives_.size(), seen = columns(machine_.senses);
        std::vector<float> actions(futures * motors), observations(futures * seen), costs(futures);
        for (std::uint32_t step = 0; step < horizon; ++step) {
            for (std::uint32_t k = 0; k < futures; ++k)
                std::memcpy(&actions[k * motors], tried_[k].speeds[step / (horizon / machine_.pieces)], motors * sizeof(float));
            fleet_.step({.dt = machine_.dt, .drives = drives_, .actions = actions, .senses = machine_.senses, .observations = observations});
            const float then = time_ + machine_.dt * static_cast<float>(step + 1);
            for (std::uint32_t k = 0; k < futures; ++k) costs[k] += machine_.cost(&observations[k * seen], then);
        }
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < futures; ++k)
            if (costs[k] < costs[best]) best = k;
        return best;
    }

    const Machine& machine_;
    std::vector<Line> block_;
    Fleet& fleet_;
    std::vector<Drive> drives_;
    std::vector<std::byte> image_;
    std::vector<Plan> tried_ = std::vector<Plan>(futures);
    Plan best_;
    float time_ = 0;
    std::uint64_t random_ = 1;
};

static bool follow() {
    const Machine arm = make_arm();
    const BodyId hand = arm.senses[0].body;
    Planner planner(arm);
    float sum = 0, worst = 0;
    int counted = 0;
    for (int decided = 0; decided < 96; ++decided) {
        planner.act();
        const Transform at = arm.world.transform(hand);
        const float pose[] = {at.p.x, at.p.y, at.q.c, at.q.s};
        const float off = distance(tip(pose), goal(planner.time()));
        if (decided % 12 == 11)
            std::printf("%4.1f s: the tip is %5.1f mm from its goal\n", static_cast<double>(planner.time()), 1000 * static_cast<double>(off));
        if (planner.time() < 2) continue;  // it has got there
        sum += off;
        worst = max(worst, off);
        ++counted;
    }
    std::printf("from 2 s on: %.1f mm on average, %.1f mm at most; %u futures take %.0f kB\n", 1000 * static_cast<double>(sum / static_cast<float>(counted)),
                1000 * static_cast<double>(worst), futures, static_cast<double>(planner.bytes()) / 1000);
    std::printf("state %016llx\n", static_cast<unsigned long long>(arm.world.hash()));
    return worst < 0.06f;
}

static bool walk() {
    const Machine walker = make_walker();
    const BodyId hull = walker.senses[0].body;
    Planner planner(walker);
    float lowest = 10;
    for (int decided = 0; decided < 40; ++decided) {
        planner.act();
        const Vec2 at = walker.world.position(hull);
        lowest = min(lowest, at.y);
        if (decided % 8 == 7)
            std::printf("%4.1f s: the hull is at (%.2f, %.2f) m\n", static_cast<double>(planner.time()), static_cast<double>(at.x), static_cast<double>(at.y));
    }
    const float far = walker.world.position(hull).x;
    std::printf("it walked %.2f m, its hull never lower than %.2f m; %u futures take %.0f kB\n", static_cast<double>(far), static_cast<double>(lowest), futures,
                static_cast<double>(planner.bytes()) / 1000);
    std::printf("state %016llx\n", static_cast<unsigned long long>(walker.world.hash()));
    return far > 2 && lowest > 0.9f;
}

int main(int argc, char** argv) {
    const char* const name = argc > 1 ? argv[1] : "arm";
    if (argc > 2 || (std::strcmp(name, "arm") != 0 && std::strcmp(name, "walker") != 0)) {
        std::fputs("usage: planning [arm|walker]\n", stderr);
        return 2;
    }
    return (std::strcmp(name, "arm") == 0 ? follow() : walk()) ? 0 : 1;
}
