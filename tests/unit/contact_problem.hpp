// Random contact problems for the solver's kernel, and a plain projected Gauss-Seidel solver in double precision to compare it with.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "constraint/kernels.hpp"
#include "math/lanes.hpp"
#include "support/random.hpp"

namespace islet::test {

struct Material {
    float restitution = 0, rolling_resistance = 0, tangent_speed = 0;
};

/// Bodies and the contacts between them, grouped so that contacts of a group share no body but body 0, which stands for all static ones.
struct ContactProblem {
    std::vector<detail::Pose> poses;
    std::vector<detail::SolverBody> bodies;
    std::vector<detail::SolverMotion> motions;
    std::vector<detail::ContactManifold> manifolds;
    std::vector<Material> materials;
    std::vector<std::uint32_t> slot_of;
    std::vector<std::vector<std::uint32_t>> groups;
    detail::StepNumbers numbers{.max_speed = 400};  // m/s

    std::uint32_t add_body(Vec2 center, float mass, float inertia, Vec2 v = {}, float w = 0) {
        const auto index = static_cast<std::uint32_t>(bodies.size());
        detail::Pose pose;
        pose.center = center;
        pose.inv_mass = mass > 0 ? 1 / mass : 0;
        pose.inv_inertia = inertia > 0 ? 1 / inertia : 0;
        poses.push_back(pose);
        detail::SolverBody body;
        body.v = v;
        body.w = w;
        body.inv_mass = pose.inv_mass;
        body.inv_inertia = pose.inv_inertia;
        bodies.push_back(body);
        motions.push_back({});
        slot_of.push_back(index);
        return index;
    }

    /// A contact whose manifold was made at the bodies' present poses; anchors are relative to A's centre.
    detail::ContactManifold& add_contact(std::size_t group, std::uint32_t a, std::uint32_t b, Vec2 normal,
                                         std::initializer_list<Vec2> anchors, float friction, const Material& material = {}) {
        detail::ContactManifold m;
        m.body_a = a;
        m.body_b = b;
        m.normal = normal;
        m.offset = poses[b].center - poses[a].center;
        m.rotation_a = poses[a].q;
        m.rotation_b = poses[b].q;
        std::uint32_t count = 0;
        for (const Vec2 anchor : anchors) m.anchors[count++] = anchor;
        m.friction = friction;
        m.flags = detail::contact_touching | count << detail::contact_count_shift;
        if (material.restitution > 0) m.flags |= detail::contact_bouncy;
        if (material.rolling_resistance > 0 || material.tangent_speed != 0) m.flags |= detail::contact_special;
        if (groups.size() <= group) groups.resize(group + 1);
        groups[group].push_back(static_cast<std::uint32_t>(manifolds.size()));
        materials.push_back(material);
        return manifolds.emplace_back(m);
    }
};

/// `per_group` contacts in each of `groups` groups, over bodies of all masses, some turned and moved since their manifolds were made.
inline ContactProblem random_problem(std::uint64_t seed, std::uint32_t groups, std::uint32_t per_group, bool materials) {
    Random random(seed);
    const auto vector = [&](float reach) { return Vec2{random.between(-reach, reach), random.between(-reach, reach)}; };
    ContactProblem p;
    p.numbers.dt = 1.0f / 60;
    p.numbers.h = 1.0f / 240;
    p.numbers.inv_h = 240;
    p.add_body({}, 0, 0);
    const std::uint32_t count = 2 * per_group;
    for (std::uint32_t i = 0; i < count; ++i)
        p.add_body(vector(3), random.between(0.2f, 5), random.one_in(8) ? 0.0f : random.between(0.1f, 2), vector(3), random.between(-3, 3));
    for (detail::SolverBody& b : p.bodies) {
        if (&b == &p.bodies[0]) continue;
        b.dp = {};
        b.dq = 0;
    }
    for (std::uint32_t g = 0; g < groups; ++g) {
        // A random pairing of the bodies.
        std::vector<std::uint32_t> order(count);
        for (std::uint32_t i = 0; i < count; ++i) order[i] = i + 1;
        for (std::uint32_t i = count - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
        for (std::uint32_t i = 0; i < per_group; ++i) {
            const Rot q = make_rot(random.between(-3, 3));
            Material material;
            if (materials && random.one_in(3)) material.restitution = random.between(0.1f, 1);
            if (materials && random.one_in(3)) material.rolling_resistance = random.between(0, 0.3f);
            if (materials && random.one_in(3)) material.tangent_speed = random.between(-2, 2);
            const std::uint32_t a = random.one_in(5) ? 0 : order[2 * i];
            detail::ContactManifold& m =
                random.one_in(2)
                    ? p.add_contact(g, a, order[2 * i + 1], {q.c, q.s}, {vector(0.7f)}, random.between(0, 1), material)
                    : p.add_contact(g, a, order[2 * i + 1], {q.c, q.s}, {vector(0.7f), vector(0.7f)}, random.between(0, 1), material);
            for (std::uint32_t k = 0; k < m.count(); ++k) {
                m.separation[k] = random.between(-0.02f, 0.01f);
                m.normal_impulse[k] = random.one_in(3) ? 0 : random.between(0, 0.5f);
                m.tangent_impulse[k] = m.friction * m.normal_impulse[k] * random.between(-1, 1);
            }
        }
    }
    // Since then the bodies have moved a little.
    for (std::uint32_t i = 1; i <= count; ++i) {
        p.poses[i].center += vector(0.005f);
        p.poses[i].q = make_rot(random.between(-0.05f, 0.05f));
    }
    return p;
}

/// What a run of the kernel leaves.
struct Solved {
    std::vector<detail::SolverBody> bodies;
    std::vector<detail::ContactManifold> manifolds;
};

/// Runs the kernel of the engine: prepare, warm start, then for each pair of sweeps one of each kind with an integration of positions between.
/// `in_twos`: the blocks of a group are solved as those of a colour are.
template <class Lane>
Solved run_kernel(const ContactProblem& problem, const detail::SweepNumbers& biased, const detail::SweepNumbers& relaxed, int sweeps,
                  bool restitution, bool in_twos = false) {
    using namespace detail;
    using Kernel = ContactKernel<Lane::width>;
    constexpr std::uint32_t W = Lane::width;
    Solved out{problem.bodies, problem.manifolds};
    std::vector<std::vector<typename Kernel::Rows>> rows;
    PrepareInput in{};
    in.manifolds = out.manifolds.data();
    in.poses = problem.poses.data();
    in.slot_of = problem.slot_of.data();
    in.bodies = out.bodies.data();
    in.motions = problem.motions.data();
    in.numbers = problem.numbers;
    const auto count = [](const auto& blocks) { return static_cast<std::uint32_t>(blocks.size()); };
    for (const std::vector<std::uint32_t>& group : problem.groups) {
        auto& blocks = rows.emplace_back((group.size() + W - 1) / W);
        for (std::size_t i = 0; i < blocks.size() * W; ++i) {
            auto& block = blocks[i / W];
            set_contact(block, i % W, i < group.size() ? group[i] : null_index, out.manifolds.data());
            const Material m = i < group.size() ? problem.materials[group[i]] : Material{};
            block.restitution[i % W] = m.restitution;
            block.rolling_resistance[i % W] = m.rolling_resistance;
            block.tangent_speed[i % W] = m.tangent_speed;
        }
        Kernel::prepare(in, blocks.data(), count(blocks));
    }
    for (SolverBody& b : out.bodies) {
        b.v += b.dp;
        b.w += b.dq;
        b.dp = {};
        b.dq = 0;
    }
    const auto sweep = [&](const SweepNumbers& numbers) {
        for (auto& blocks : rows) {
            if (in_twos) {
                solve_color<Kernel>(out.bodies.data(), blocks.data(), count(blocks), numbers);
            } else {
                Kernel::solve(out.bodies.data(), blocks.data(), count(blocks), numbers);
            }
        }
    };
    for (int i = 0; i < sweeps; ++i) {
        sweep(biased);
        for (SolverBody& b : out.bodies) {
            b.dp += problem.numbers.h * b.v;
            b.dq += problem.numbers.h * b.w;
        }
        sweep(relaxed);
    }
    for (std::uint32_t i = 0; restitution && i < restitution_sweeps; ++i)
        for (auto& blocks : rows) Kernel::restitute(out.bodies.data(), blocks.data(), count(blocks), 1.0f);
    for (auto& blocks : rows) Kernel::store(out.manifolds.data(), blocks.data(), count(blocks));
    return out;
}

// -- the same in double precision, row by row ------------------------------------------------------------------------------------------------

struct Vec2d {
    double x = 0, y = 0;
};
inline Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2d operator*(double s, Vec2d a) { return {s * a.x, s * a.y}; }
inline double dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }
inline double wide(float a) { return static_cast<double>(a); }
inline Vec2d wide(Vec2 a) { return {wide(a.x), wide(a.y)}; }
inline Vec2d turned(Vec2d v, double angle) {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
}

/// A textbook solver: one row at a time, J v = -u.(v_a + w_a x r_a) + u.(v_b + w_b x r_b) for a direction u.
class PlainSolver {
public:
    struct Body {
        Vec2d v, dp;
        double w = 0, dq = 0, inv_mass = 0, inv_inertia = 0;
    };

    explicit PlainSolver(const ContactProblem& p) : p_(p) {
        for (const detail::SolverBody& b : p.bodies) bodies.push_back({wide(b.v), {}, wide(b.w), 0, wide(b.inv_mass), wide(b.inv_inertia)});
        impulses.resize(p.manifolds.size());
        for (std::size_t c = 0; c < p.manifolds.size(); ++c) {
            const detail::ContactManifold& m = p.manifolds[c];
            for (std::uint32_t i = 0; i < m.count(); ++i) {
                impulses[c].n[i] = wide(m.normal_impulse[i]);
                impulses[c].t[i] = wide(m.tangent_impulse[i]);
                push(c, i, normal(c), impulses[c].n[i]);
                push(c, i, tangent(c), impulses[c].t[i]);
            }
        }
    }

    void sweep(const detail::SweepNumbers& n) {
        for (const auto& group : p_.groups)
            for (const std::uint32_t c : group) solve(c, n);
        if (!(n.bias_rate > 0)) ++relaxed_;
    }

    void integrate() {
        for (Body& b : bodies) {
            b.dp = b.dp + wide(p_.numbers.h) * b.v;
            b.dq += wide(p_.numbers.h) * b.w;
        }
    }

    Vec2d normal(std::size_t c) const { return wide(p_.manifolds[c].normal); }
    Vec2d tangent(std::size_t c) const { return {normal(c).y, -normal(c).x}; }
    /// Velocity of B's point from A's, along u.
    double speed(std::size_t c, std::uint32_t i, Vec2d u) const {
        const detail::ContactManifold& m = p_.manifolds[c];
        const Body &a = bodies[m.body_a], &b = bodies[m.body_b];
        return dot(u, b.v - a.v) + b.w * cross(arm(c, i, true), u) - a.w * cross(arm(c, i, false), u);
    }

    struct Impulse {
        double n[2] = {0, 0}, t[2] = {0, 0};
    };
    std::vector<Body> bodies;
    std::vector<Impulse> impulses;
    /// A soft sweep met a contact that is exactly closed, as a speculative one is after a substep: whether it counts as apart, and so rigid, or as
    /// overlapping, and so soft, is then a matter of rounding.
    bool on_edge = false;

private:
    Vec2d arm(std::size_t c, std::uint32_t i, bool of_b) const {
        const detail::ContactManifold& m = p_.manifolds[c];
        const Vec2d ra = wide(m.anchors[i]);
        return of_b ? ra - wide(m.offset) : ra;
    }
    // Since the manifold was made the bodies have turned by a finite angle; within the step the separation changes by the Jacobian times their way.
    double separation(std::size_t c, std::uint32_t i) const {
        const detail::ContactManifold& m = p_.manifolds[c];
        const auto moved = [&](std::uint32_t body, Rot then, bool of_b) {
            const detail::Pose& pose = p_.poses[body];
            const double turn = std::atan2(wide(pose.q.s), wide(pose.q.c)) - std::atan2(wide(then.s), wide(then.c));
            const Vec2d r = arm(c, i, of_b);
            return wide(pose.center) + bodies[body].dp + turned(r, turn) + bodies[body].dq * Vec2d{-r.y, r.x};
        };
        return wide(m.separation[i]) + dot(normal(c), moved(m.body_b, m.rotation_b, true) - moved(m.body_a, m.rotation_a, false));
    }
    double mass(std::size_t c, std::uint32_t i, Vec2d u) const {
        const detail::ContactManifold& m = p_.manifolds[c];
        const Body &a = bodies[m.body_a], &b = bodies[m.body_b];
        const double ja = cross(arm(c, i, false), u), jb = cross(arm(c, i, true), u);
        const double k = a.inv_mass + b.inv_mass + a.inv_inertia * ja * ja + b.inv_inertia * jb * jb;
        return k > 0 ? 1 / k : 0;
    }
    void push(std::size_t c, std::uint32_t i, Vec2d u, double impulse) {
        const detail::ContactManifold& m = p_.manifolds[c];
        Body &a = bodies[m.body_a], &b = bodies[m.body_b];
        a.v = a.v - (impulse * a.inv_mass) * u;
        b.v = b.v + (impulse * b.inv_mass) * u;
        a.w -= a.inv_inertia * impulse * cross(arm(c, i, false), u);
        b.w += b.inv_inertia * impulse * cross(arm(c, i, true), u);
    }
    void solve(std::size_t c, const detail::SweepNumbers& n) {
        const detail::ContactManifold& m = p_.manifolds[c];
        Impulse& lambda = impulses[c];
        double s[2];
        for (std::uint32_t i = 0; i < m.count(); ++i) {
            s[i] = separation(c, i);
            on_edge = on_edge || (n.mass_scale < 1 && std::abs(s[i]) < 1e-6);
        }
        // A contact's two points take turns in being first, from one unbiased sweep to the next. The sum of their impulses decays, and of what they sink apart,
        // impulse over mass, three tenths; but a point that bears all keeps 0.35 of it at most.
        double decaying[2] = {lambda.n[0], lambda.n[1]};
        if (m.count() == 2) {
            const double m0 = mass(c, 0, normal(c)), m1 = mass(c, 1, normal(c)), alike = m0 * (lambda.n[0] + lambda.n[1]) / (m0 + m1);
            const double lean = std::clamp(0.7 * (alike - lambda.n[0]), -0.35 * lambda.n[0], 0.35 * lambda.n[1]);
            decaying[0] += lean;
            decaying[1] -= lean;
        }
        for (std::uint32_t k = 0; k < m.count(); ++k) {
            const std::uint32_t i = m.count() == 2 ? (k + relaxed_) % 2 : k;
            double bias = s[i] * wide(n.inv_h), mass_scale = 1, impulse_scale = 0;
            if (s[i] <= 0) {
                bias = n.bias_rate > 0 ? std::max(wide(n.bias_rate) * std::min(s[i] + wide(n.slop), 0.0), -wide(n.push_speed)) : 0;
                if (n.bias_rate > 0) mass_scale = wide(n.mass_scale), impulse_scale = wide(n.impulse_scale);
            }
            const double delta = -mass(c, i, normal(c)) * (mass_scale * speed(c, i, normal(c)) + bias) - impulse_scale * decaying[i];
            apply(c, i, normal(c), lambda.n[i], delta, 0, 1e300);
        }
        for (std::uint32_t i = 0; i < m.count(); ++i) {
            const double bound = wide(m.friction) * lambda.n[i];
            const double slip = speed(c, i, tangent(c)) - wide(p_.materials[c].tangent_speed);
            apply(c, i, tangent(c), lambda.t[i], -mass(c, i, tangent(c)) * slip, -bound, bound);
        }
    }
    void apply(std::size_t c, std::uint32_t i, Vec2d u, double& lambda, double delta, double lo, double hi) {
        const double next = std::clamp(lambda + delta, lo, hi);
        push(c, i, u, next - lambda);
        lambda = next;
    }

    const ContactProblem& p_;
    std::uint32_t relaxed_ = 0;  // unbiased sweeps so far
};

}  // namespace islet::test
