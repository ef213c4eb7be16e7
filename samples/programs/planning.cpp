// Planning by forking worlds: an arm with two links and two motors follows a point that moves on a circle. For each decision 256 futures of 30 steps start
// as copies of the arm as it is now, each with speeds of its own for the motors; the best future says what the motors do next.
#include <cstdio>
#include <vector>

#include <islet/fleet.hpp>
#include <islet/islet.hpp>

using namespace islet;

static constexpr std::uint32_t futures = 256, horizon = 30, pieces = 3, rounds = 2, decision = 5;  // steps: a future has 3 pieces of 10; a decision lasts 5
static constexpr float dt = 1.0f / 60, link_length = 1;                                            // s, m

static StaticWorld<Capacity{.bodies = 3, .shapes = 3, .contacts = 8, .joints = 2}> real_storage;

/// Two links in a row, the first on the ground; their motors have 40 and 20 N m.
struct Arm {
    World& world = real_storage.create({});
    BodyId hand;
    JointId shoulder, elbow;

    BodyId link(float x) {
        const BodyId body = world.create_body({.type = BodyType::dynamic, .position = {x, 0}, .enable_sleep = false});
        world.create_shape(body, make_box(link_length / 2, 0.05f), {.density = 10, .filter = {.mask = 0}});
        return body;
    }
    JointId hinge(BodyId a, BodyId b, float at, float max_force) {
        RevoluteJointDef def{.base = {.body_a = a, .body_b = b, .frame_a = {{at, 0}}, .frame_b = {{-link_length / 2, 0}}}};
        def.motor = {.enable = true, .max_force = max_force};
        return world.create_joint(def);
    }
    Arm() {
        const BodyId ground = world.create_body({}), upper = link(link_length / 2);
        hand = link(1.5f * link_length);
        shoulder = hinge(ground, upper, 0, 40);
        elbow = hinge(upper, hand, link_length / 2, 20);
    }
};

/// The hand's tip, from the pose of the last link.
static Vec2 tip(const float* pose) { return {pose[0] + link_length / 2 * pose[2], pose[1] + link_length / 2 * pose[3]}; }

/// The point to follow: on a circle of 0.5 m about (1, 0.5), once in 4 s.
static Vec2 goal(float time) {
    const Rot turn = make_rot(2 * pi / 4 * time);
    return {1 + 0.5f * turn.c, 0.5f + 0.5f * turn.s};
}

/// Evenly spread over -1 to 1 (SplitMix64).
static float random_number(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return static_cast<float>((z ^ z >> 31) >> 40) * 0x1p-23f - 1;
}

/// What the motors do in each piece of a future, rad/s.
struct Plan {
    float speeds[pieces][2] = {};
};

class Planner {
public:
    Planner(const Arm& arm)
        : block_(Fleet::bytes(futures, arm.world.capacity()) / sizeof(Line) + 1),
          fleet_(*Fleet::create({reinterpret_cast<std::byte*>(block_.data()), block_.size() * sizeof(Line)}, arm.world, futures)),
          drives_{{.kind = DriveKind::motor_speed, .joint = arm.shoulder}, {.kind = DriveKind::motor_speed, .joint = arm.elbow}},
          senses_{{.kind = SenseKind::position, .body = arm.hand}, {.kind = SenseKind::rotation, .body = arm.hand}} {}

    /// The best of `rounds` times 256 plans around the last one, which its first piece has brought on by a decision. Future 0 keeps the plan.
    const Plan& decide(const World& now, float time) {
        image_.resize(now.snapshot_bytes());
        now.save(image_);
        float width = 3;  // rad/s
        for (std::uint32_t round = 0; round < rounds; ++round, width /= 3) {
            for (std::uint32_t k = 0; k < futures; ++k)
                for (std::uint32_t piece = 0; piece < pieces; ++piece)
                    for (int motor = 0; motor < 2; ++motor)
                        tried_[k].speeds[piece][motor] = best_.speeds[piece][motor] + (k == 0 ? 0 : width * random_number(random_));
            best_ = tried_[cheapest(time)];
        }
        return best_;
    }
    std::size_t bytes() const { return block_.size() * sizeof(Line); }

private:
    struct alignas(world_alignment) Line {
        std::byte bytes[world_alignment];
    };

    /// Tries the plans: the future whose tip stays nearest to the goal.
    std::uint32_t cheapest(float time) {
        fleet_.reset(0, image_);
        const std::vector<std::uint32_t> all_of_the_first(futures, 0);
        fleet_.fork(all_of_the_first);
        std::vector<float> actions(futures * 2), poses(futures * 4), costs(futures);
        for (std::uint32_t step = 0; step < horizon; ++step) {
            for (std::uint32_t k = 0; k < futures; ++k)
                for (std::uint32_t motor = 0; motor < 2; ++motor) actions[2 * k + motor] = tried_[k].speeds[step / (horizon / pieces)][motor];
            fleet_.step({.dt = dt, .drives = drives_, .actions = actions, .senses = senses_, .observations = poses});
            const Vec2 wanted = goal(time + dt * static_cast<float>(step + 1));
            for (std::uint32_t k = 0; k < futures; ++k) costs[k] += length_squared(tip(&poses[4 * k]) - wanted);
        }
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < futures; ++k)
            if (costs[k] < costs[best]) best = k;
        return best;
    }

    std::vector<Line> block_;
    Fleet& fleet_;
    Drive drives_[2];
    Sense senses_[2];
    std::vector<std::byte> image_;
    std::vector<Plan> tried_ = std::vector<Plan>(futures);
    Plan best_;
    std::uint64_t random_ = 1;
};

static void set_speed(World& world, JointId joint, float speed) {
    JointMotor motor = world.motor(joint);
    motor.speed = speed;
    world.set_motor(joint, motor);
}

int main() {
    Arm arm;
    Planner planner(arm);
    float time = 0, sum = 0, worst = 0;
    int counted = 0;
    for (int decided = 0; decided < 96; ++decided) {
        const Plan& plan = planner.decide(arm.world, time);
        set_speed(arm.world, arm.shoulder, plan.speeds[0][0]);
        set_speed(arm.world, arm.elbow, plan.speeds[0][1]);
        for (std::uint32_t step = 0; step < decision; ++step, time += dt) arm.world.step(dt);
        const float pose[] = {arm.world.position(arm.hand).x, arm.world.position(arm.hand).y, arm.world.transform(arm.hand).q.c,
                              arm.world.transform(arm.hand).q.s};
        const float off = distance(tip(pose), goal(time));
        if (decided % 12 == 11) std::printf("%4.1f s: the tip is %5.1f mm from its goal\n", static_cast<double>(time), 1000 * static_cast<double>(off));
        if (time < 2) continue;  // it has got there
        sum += off;
        worst = max(worst, off);
        ++counted;
    }
    std::printf("from 2 s on: %.1f mm on average, %.1f mm at most; %u futures take %.0f kB\n", 1000 * static_cast<double>(sum / static_cast<float>(counted)),
                1000 * static_cast<double>(worst), futures, static_cast<double>(planner.bytes()) / 1000);
    std::printf("state %016llx\n", static_cast<unsigned long long>(arm.world.hash()));
    return worst < 0.06f ? 0 : 1;
}
