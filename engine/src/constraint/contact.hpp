// The projected Gauss-Seidel kernel for contacts, written once over lanes.
//
// Solving a row: residual -> delta -> clamp the accumulated impulse -> apply. For the normal row of a point, with relative velocity vn,
//     delta  = -m (mass_scale vn + bias) - impulse_scale lambda,     lambda' = max(lambda + delta, 0)
// and for its tangent row, with the normal impulse just found,
//     delta  = -m (vt - surface speed),                              lambda' = clamp(lambda + delta, -mu lambda_n, mu lambda_n).
// mass_scale and impulse_scale make the contact soft: a spring and damper integrated implicitly (Catto, "Soft Constraints", GDC 2011; the
// substeps with a relaxing sweep follow Catto, "Solver2D", 2024, and Macklin and others, "Small Steps in Physics Simulation", 2019).
//
// The relative velocity of the two bodies is projected onto the contact's frame once, and each row updates it there. The bodies get the summed impulse.
#pragma once

#include "../constraint/contact_prepare.hpp"
#include "../constraint/kernels.hpp"
#include "../constraint/lane_vectors.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

inline constexpr std::uint32_t restitution_passes = 6;  // over a contact's two points
inline constexpr float settled_share = 0.003f;          // of a contact's impulses: a pass over what lands that changes less is the last

/// Softness lets the impulses of a contact decay a little in each biased sweep, so that a point sinks by its impulse over its effective mass. The sum of two
/// points' impulses decays at the full rate, and what they sink apart by at 1 - 2 lean_share of it: a contact is stiffer against leaning than against weight.
/// Equally soft contacts let columns buckle as Euler's do: 300 kg brings down five boxes of 1 kg. The weight needs its softness: with 0.6 of it pyramids of 30
/// rows never rest, since one sweep a substep is too few to damp the slow motions of a large pile. So a point that bears all keeps 1 - lean_share of it,
/// whatever the masses. (Without that bound piles of 500 boxes never rest either.) Leaning bears less: columns of 60 stand down to a fifth of it, and at a
/// seventh they swing. (If impulses are mixed instead of sinks, columns whose faces are not centred under the load fall: the point that bears less is pressed
/// in too far.)
inline constexpr float lean_share = 0.35f;

/// How one sweep treats contacts, in all lanes.
template <class L>
struct SweepLanes {
    using F = typename L::F;
    F inv_h, bias_rate, mass_scale, impulse_scale, push, slop;

    ISLET_LANE explicit SweepLanes(const SweepNumbers& n)
        : inv_h(L::splat(n.inv_h)),
          bias_rate(L::splat(n.bias_rate)),
          mass_scale(L::splat(n.mass_scale)),
          impulse_scale(L::splat(n.impulse_scale)),
          push(L::splat(-n.push_speed)),
          slop(L::splat(n.slop)) {}

    /// Makes the numbers those of a block whose contacts share their load with others.
    ///
    /// Two moving bodies of several shapes may touch in several contacts. Springs along the same normal are too stiff together for the few sweeps of a step:
    /// columns of such bodies swing, and fall. So each of n such contacts is n times as soft, and together they are as stiff as one: where one has
    /// mass_scale = 1 / (1 + x) and impulse_scale = x / (1 + x), each of n has n x for x.
    ISLET_PART void share(const ContactRows<L::width>& r) {
        if (r.sharing() == 0) return;
        const F one = L::splat(1.0f), sharers = sharers_of<L>(r);
        const F less = one / (one + (sharers - one) * impulse_scale);
        bias_rate = less * bias_rate;
        mass_scale = less * mass_scale;
        impulse_scale = less * (sharers * impulse_scale);
        push = less * push;
    }
};

/// Which lanes of a block a pass solves: all of them,
struct AllLanes {
    template <class F>
    ISLET_LANE F pick(F solved, F) const {
        return solved;
    }
};
/// or those that a mask names. In the others nothing changes, even where numbers have overflowed.
template <class Mask>
struct MaskedLanes {
    Mask mask;
    template <class F>
    ISLET_LANE F pick(F solved, F other) const {
        return select(mask, solved, other);
    }
};

/// A block of contacts while it is solved. An impulse along n does not change the centres' velocities along t, nor the other way round. So the impulses are
/// summed along each, and the centres get the sums at the end.
template <class L>
struct ContactBlock : BodyPair<L> {
    using F = typename L::F;
    using BodyPair<L>::va, BodyPair<L>::vb, BodyPair<L>::wa, BodyPair<L>::wb, BodyPair<L>::ma, BodyPair<L>::mb, BodyPair<L>::ia, BodyPair<L>::ib;
    LaneVec<F> n;
    F rn_ab, rt_ab;
    F sum_n, sum_t;  // N s, of this sweep

    ISLET_PART ContactBlock(const SolverBody* bodies, const ContactRows<L::width>& r) {
        this->template gather<words_counted<L::width>>(bodies, r.body_a, r.body_b);
        n = {L::load(normal_x(r)), L::load(normal_y(r))};
        rn_ab = L::load(r.rn_ab);
        rt_ab = L::load(r.rt_ab);
        sum_n = sum_t = L::splat(0.0f);
    }
    /// Writes the velocities back.
    ISLET_PART void scatter(SolverBody* bodies, const ContactRows<L::width>& r) const {
        BodyPair<L>::template scatter<words_counted<L::width>>(bodies, r.body_a, r.body_b);
    }
    ISLET_PART void spin_by_normal(F rna, F rnb, F impulse) {
        wa = wa - ia * (rna * impulse);
        wb = wb + ib * (rnb * impulse);
    }
    ISLET_PART void spin_by_tangent(F rta, F rtb, F impulse) {
        wa = wa + ia * (rta * impulse);
        wb = wb - ib * (rtb * impulse);
    }
    ISLET_PART void push_centres(LaneVec<F> impulse) {
        va = va - ma * impulse;
        vb = vb + mb * impulse;
    }
};

/// By how much a normal impulse, of which `held` counts as such, is too large, N s. Shapes that are apart may close the gap within the substep, but no faster.
/// In a sweep with bias, shapes that overlap are pushed apart softly.
template <class L, class F = typename L::F>
ISLET_PART F excess_of(const SweepLanes<L>& sweep, bool biased, F normal_mass, F speed, F separation, F held) {
    const F zero = L::splat(0.0f);
    if constexpr (L::width == 1) {
        if (separation > 0) return normal_mass * (speed + separation * sweep.inv_h);
        if (!biased) return normal_mass * speed;
        const F bias = max(sweep.bias_rate * min(separation + sweep.slop, zero), sweep.push);
        return normal_mass * (sweep.mass_scale * speed + bias) + sweep.impulse_scale * held;
    } else {
        if (!biased) return normal_mass * (speed + max(separation, zero) * sweep.inv_h);
        const auto apart = separation > zero;
        const F bias = select(apart, separation * sweep.inv_h, max(sweep.bias_rate * min(separation + sweep.slop, zero), sweep.push));
        const F mass_scale = select(apart, L::splat(1.0f), sweep.mass_scale);
        return normal_mass * (mass_scale * speed + bias) + select(apart, zero, sweep.impulse_scale * held);
    }
}

/// max(min(a, bound), -bound). Most contacts of a pile stick.
template <class L, class F = typename L::F>
ISLET_PART F bounded(F a, F bound) {
    if constexpr (L::width == 1 && !short_loops)
        if (L::abs(a) < bound) return a;
    return max(min(a, bound), L::splat(0.0f) - bound);
}

/// One pass over all rows of a block, in parts.
template <class L, class Lanes>
struct BlockPass {
    using F = typename L::F;
    ContactBlock<L>& s;
    ContactRows<L::width>& r;
    const SweepLanes<L>& sweep;
    Lanes lanes;
    bool biased;
    F mass, vn, vt;   // 1/kg; m/s along the normal and the tangent
    F turned, moved;  // since the step began: rad; m along the normal, of which both points have the same part
    F lean;           // N s, of what the points sink apart by; none in lanes of one point
    F mu;

    ISLET_PART BlockPass(ContactBlock<L>& block, ContactRows<L::width>& rows, const SweepLanes<L>& numbers, bool is_biased, Lanes of)
        : s(block), r(rows), sweep(numbers), lanes(of), biased(is_biased) {}

    ISLET_PART void begin_normals(std::uint32_t points, std::uint32_t first) {
        const F zero = L::splat(0.0f);
        s.sum_n = s.sum_t = zero;
        mass = s.ma + s.mb;
        vn = dot(s.n, s.vb - s.va);
        // How far the two surfaces moved apart along n is the row's Jacobian times the bodies' motion.
        turned = s.dqb - s.dqa;
        moved = dot(s.n, s.dpb - s.dpa) + s.dqb * s.rn_ab;
        lean = zero;
        if (biased && points != 0) {
            const F one = L::load(normal_impulse_of(r, first)), other = L::load(normal_impulse_of(r, 1 - first));
            bool pressed = true;
            if constexpr (L::width == 1) pressed = bits_of(one + other) != 0;
            if (pressed) {
                const F mass_1 = L::load(r.points[first].normal_mass), mass_2 = L::load(r.points[1 - first].normal_mass);
                const F alike = mass_1 * ((one + other) / (mass_1 + mass_2));  // the first point's share if both sink by the same
                const F share = L::splat(lean_share), least = zero - share * one, most = share * other;
                lean = min(max(L::splat(2.0f * lean_share) * (alike - one), least), most);
                if constexpr (L::width > 1) lean = select(L::load(r.points[1].normal_mass) > zero, lean, zero);
            }
        }
    }
    template <class IsFirst>
    ISLET_PART void solve_normal(std::uint32_t i, IsFirst is_first) {
        const F zero = L::splat(0.0f);
        const typename ContactRows<L::width>::Point& p = r.points[i];
        const F rna = L::load(p.rna), rnb = rna + s.rn_ab;
        const F separation = L::load(p.separation) + moved + rna * turned;
        const F normal_mass = L::load(p.normal_mass);
        const F old = L::load(normal_impulse_of(r, i));
        const F speed = vn + (s.wb * rnb - s.wa * rna);
        const F less = excess_of<L>(sweep, biased, normal_mass, speed, separation, old + lean);
        const F lambda = lanes.pick(max(old - less, zero), old);
        const F delta = lanes.pick(lambda - old, zero);
        L::store(normal_impulse_of(r, i), lambda);
        s.sum_n = is_first ? delta : s.sum_n + delta;
        vn = vn + mass * delta;
        s.spin_by_normal(rna, rnb, delta);
        lean = zero - lean;
    }
    ISLET_PART void note_normals(std::uint32_t points) {
        if (!r.is_bouncy()) return;
        for (std::uint32_t i = 0; i < 2; ++i)
            if (i == 0 || points != 0) note_impulse<L>(r, i, L::load(normal_impulse_of(r, i)));
    }

    /// Friction, with the normal impulses just found.
    ISLET_PART void begin_friction() {
        mu = L::load(friction_of(r));
        vt = cross(s.vb - s.va, s.n);
        if (r.is_special()) vt = vt - L::load(r.tangent_speed);
    }
    template <class IsFirst>
    ISLET_PART void solve_friction(std::uint32_t i, IsFirst is_first) {
        const typename ContactRows<L::width>::Point& p = r.points[i];
        if constexpr (L::width == 1)
            if ((bits_of(*normal_impulse_of(r, i)) | bits_of(*tangent_impulse_of(r, i))) == 0) return;  // as between most shapes that stand side by side
        const F rta = L::load(p.rta), rtb = rta + s.rt_ab;
        const F old = L::load(tangent_impulse_of(r, i));
        const F bound = mu * L::load(normal_impulse_of(r, i));
        const F speed = vt - (s.wb * rtb - s.wa * rta);
        const F lambda = lanes.pick(bounded<L>(old - L::load(p.tangent_mass) * speed, bound), old);
        const F delta = lanes.pick(lambda - old, L::splat(0.0f));
        L::store(tangent_impulse_of(r, i), lambda);
        s.sum_t = is_first ? delta : s.sum_t + delta;
        vt = vt + mass * delta;
        s.spin_by_tangent(rta, rtb, delta);
    }

    /// The rolling row: wb - wa = 0, bounded by the sum of the normal impulses.
    ISLET_PART void solve_rolling() {
        if (!r.is_special()) return;
        const F zero = L::splat(0.0f);
        const F old = L::load(rolling_impulse_of(r));
        const F resistance = L::load(r.rolling_resistance);
        const F bound = select(resistance > zero, resistance * normal_impulses_of<L>(r), zero);  // 0 * inf would be NaN if a normal impulse has overflowed
        const F lambda = lanes.pick(max(min(old - L::load(r.rolling_mass) * (s.wb - s.wa), bound), zero - bound), old);
        const F delta = lanes.pick(lambda - old, zero);
        L::store(rolling_impulse_of(r), lambda);
        s.wa = s.wa - s.ia * delta;
        s.wb = s.wb + s.ib * delta;
    }
    ISLET_PART void push_centres() { s.push_centres(in_world(s.n, s.sum_n, s.sum_t)); }
};

/// One pass over all rows of a block; or of two that have as many points, part by part in turns. `r` is the first one's rows.
///
/// Each row waits for the row before it, and the processor's arithmetic units wait, too. A second block that pushes none of the same bodies fills the gaps:
/// two together take three quarters of the time.
template <class L, class... Pass>
ISLET_PART void solve_rows(const ContactRows<L::width>& r, Pass... pass) {
    const std::uint32_t points = r.two_points, first = points >> 1;
    (pass.begin_normals(points, first), ...);
    for_points(points != 0, first, [&](std::uint32_t i, auto is_first) ISLET_INLINED_LAMBDA { (pass.solve_normal(i, is_first), ...); });
    (pass.note_normals(points), ...);
    (pass.begin_friction(), ...);
    for_points(points != 0, 0, [&](std::uint32_t i, auto is_first) ISLET_INLINED_LAMBDA { (pass.solve_friction(i, is_first), ...); });
    (pass.solve_rolling(), ...);
    (pass.push_centres(), ...);
}

/// One pass over all rows of a block.
template <class L, class Lanes>
ISLET_PART void solve_block(ContactBlock<L>& s, ContactRows<L::width>& r, const SweepLanes<L>& sweep, bool biased, const Lanes& lanes) {
    solve_rows<L>(r, BlockPass<L, Lanes>(s, r, sweep, biased, lanes));
}

/// The lanes whose impulses the last pass changed by more than a little.
template <class L>
ISLET_PART auto has_changed(const ContactBlock<L>& s, const ContactRows<L::width>& r) {
    const auto small = L::splat(settled_share) * normal_impulses_of<L>(r);
    return s.sum_n * s.sum_n + s.sum_t * s.sum_t > small * small;
}

/// One sweep over a run of blocks, with bias or without. `shares`: over one block, if its contacts may share their load. (The numbers of a single row are
/// already those that it needs.)
template <std::uint32_t W, bool shares = false>
ISLET_COPIED void sweep_blocks(SolverBody* bodies, ContactRows<W>* rows, std::uint32_t count, const SweepNumbers& numbers, bool biased) {
    using L = LaneOf<W>;
    SweepLanes<L> sweep(numbers);
    if constexpr (shares && W > 1)
        if (numbers.shares) sweep.share(rows[0]);
    for (std::uint32_t block = 0; block < count; ++block) {
        ContactRows<W>& r = rows[block];
        // A contact that lands is solved again at once, alone, until a pass changes little.
        if constexpr (W == 1) {
            std::uint32_t passes = 1 + r.extra_passes[0];
            for (bool again = true; again;) {
                ContactBlock<L> s(bodies, r);
                solve_block<L>(s, r, sweep, biased, AllLanes{});
                s.scatter(bodies, r);
                again = --passes != 0 && has_changed<L>(s, r);
            }
        } else {
            ContactBlock<L> s(bodies, r);
            solve_block<L>(s, r, sweep, biased, AllLanes{});
            s.scatter(bodies, r);
            if (any_lands(r)) ContactKernel<W>::land(bodies, r, L::bits(has_changed<L>(s, r)), numbers);
        }
        if (!biased && r.two_points) r.two_points ^= 3;  // the next substep begins with the other point
    }
}

/// The same over blocks of one colour, which push no body in common: two at a time where both have as many points. `shares`: their contacts may share loads.
template <std::uint32_t W, bool shares = false>
ISLET_PART void sweep_in_twos(SolverBody* bodies, ContactRows<W>* rows, std::uint32_t count, const SweepNumbers& numbers, bool biased) {
    using L = LaneOf<W>;
    const SweepLanes<L> sweep(numbers);
    const auto sweep_of = [&]([[maybe_unused]] const ContactRows<W>& r) ISLET_INLINED_LAMBDA {
        SweepLanes<L> own = sweep;
        if constexpr (shares)
            if (numbers.shares) own.share(r);
        return own;
    };
    for (std::uint32_t block = 0; block < count;) {
        ContactRows<W>& a = rows[block];
        if (block + 1 == count || a.two_points != rows[block + 1].two_points) {
            ContactKernel<W>::solve(bodies, &a, 1, numbers);
            ++block;
            continue;
        }
        ContactRows<W>& b = rows[block + 1];
        ContactBlock<L> of_a(bodies, a), of_b(bodies, b);
        const SweepLanes<L> sweep_a = sweep_of(a), sweep_b = sweep_of(b);
        solve_rows<L>(a, BlockPass<L, AllLanes>(of_a, a, sweep_a, biased, {}), BlockPass<L, AllLanes>(of_b, b, sweep_b, biased, {}));
        of_a.scatter(bodies, a);
        of_b.scatter(bodies, b);
        if (any_lands(a)) ContactKernel<W>::land(bodies, a, L::bits(has_changed<L>(of_a, a)), numbers);
        if (any_lands(b)) ContactKernel<W>::land(bodies, b, L::bits(has_changed<L>(of_b, b)), numbers);
        if (!biased && a.two_points) {  // the next substep begins with the other point
            a.two_points ^= 3;
            b.two_points ^= 3;
        }
        block += 2;
    }
}

/// The numbers of a sweep for one contact that shares its load with others, as SweepLanes::share makes them.
ISLET_SHARED SweepNumbers shared_numbers(SweepNumbers n, const ContactRows<1>& r) {
    SweepLanes<Lane1> lane(n);
    lane.share(r);
    n.bias_rate = lane.bias_rate;
    n.mass_scale = lane.mass_scale;
    n.impulse_scale = lane.impulse_scale;
    n.push_speed = -lane.push;
    return n;
}

/// ContactKernel::solve, to be compiled with the caller's instructions.
template <std::uint32_t W>
ISLET_PART void solve_blocks(SolverBody* bodies, ContactRows<W>* rows, std::uint32_t count, const SweepNumbers& numbers) {
    const bool biased = is_positive(numbers.bias_rate);
#if defined(__OPTIMIZE_SIZE__) || defined(__wasm__)
    const std::uint32_t run = numbers.shares ? 1 : count;  // each block may need other numbers
    for (std::uint32_t first = 0; first < count; first += run) {
        [[maybe_unused]] SweepNumbers of_one;
        const SweepNumbers* own = &numbers;
        if constexpr (W == 1)
            if (numbers.shares) own = &(of_one = shared_numbers(numbers, rows[first]));
        sweep_blocks<W, (W > 1)>(bodies, rows + first, run, *own, biased);
    }
#else
    // Each kind of sweep has a loop of its own, which asks for the kind no more. Only sweeps with bias know of shared loads.
    if (numbers.shares) {
        for (std::uint32_t i = 0; i < count; ++i) {
            if constexpr (W == 1)
                sweep_blocks<W>(bodies, rows + i, 1, shared_numbers(numbers, rows[i]), true);
            else
                sweep_blocks<W, true>(bodies, rows + i, 1, numbers, true);
        }
    } else if (biased) {
        sweep_blocks<W>(bodies, rows, count, numbers, true);
    } else {
        sweep_blocks<W>(bodies, rows, count, numbers, false);
    }
#endif
}

template <std::uint32_t W>
void ContactKernel<W>::solve(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers) {
    solve_blocks<W>(bodies, rows, count, numbers);
}

template <std::uint32_t W>
void ContactKernel<W>::solve_in_twos([[maybe_unused]] SolverBody* bodies, [[maybe_unused]] Rows* rows, [[maybe_unused]] std::uint32_t count,
                                     [[maybe_unused]] const SweepNumbers& numbers) {
    if constexpr (W > 1) {
        const bool biased = is_positive(numbers.bias_rate);
        if (short_loops || numbers.shares) {
            sweep_in_twos<W, true>(bodies, rows, count, numbers, biased || !short_loops);
        } else if (biased) {
            sweep_in_twos<W>(bodies, rows, count, numbers, true);
        } else {
            sweep_in_twos<W>(bodies, rows, count, numbers, false);
        }
    }
}

template <std::uint32_t W>
void ContactKernel<W>::land(SolverBody* bodies, Rows& r, std::uint32_t changed, const SweepNumbers& numbers) {
    using L = LaneOf<W>;
    if constexpr (W > 1) {
        float lands[W];
        std::uint32_t most = 0;
        for (std::uint32_t i = 0; i < W; ++i) {
            const bool again = r.extra_passes[i] != 0 && (changed >> i & 1u) != 0;
            lands[i] = again ? 1.0f : 0.0f;
            most = again ? landing_passes : most;
        }
        if (most == 0) return;
        SweepLanes<L> sweep(numbers);
        if (numbers.shares) sweep.share(r);
        const bool biased = is_positive(numbers.bias_rate);
        auto mask = L::load(lands) > L::splat(0.0f);
        ContactBlock<L> s(bodies, r);
        const BodyPair<L> before = s;
        const bool all_pushed = L::positive(min(s.ma, s.mb)) == (1u << W) - 1;
        for (std::uint32_t pass = 0; pass < most && L::bits(mask) != 0; ++pass) {
            solve_block<L>(s, r, sweep, biased, MaskedLanes<decltype(mask)>{mask});
            if (!all_pushed) s.keep_unpushed(before);
            mask = mask & has_changed<L>(s, r);
        }
        s.scatter(bodies, r);
    }
}

template <std::uint32_t W>
void ContactKernel<W>::land_again(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers) {
    for (std::uint32_t block = 0; block < count; ++block) {
        Rows& r = rows[block];
        if (!any_lands(r)) continue;
        if constexpr (W == 1) {
            --r.extra_passes[0];  // solve makes one pass more than `land`
            solve(bodies, &r, 1, numbers);
            ++r.extra_passes[0];
        } else {
            land(bodies, r, (1u << W) - 1, numbers);
            if (!is_positive(numbers.bias_rate) && r.two_points) r.two_points ^= 3;
        }
    }
}

/// Which points of a block bounce: those where the surfaces met (an impulse was needed) faster than the threshold, and whose material bounces. These stay the
/// same while the rebounds are solved.
template <class L>
struct Rebounds {
    using Mask = decltype(typename L::F{} < typename L::F{});
    Mask first, second;

    ISLET_PART Rebounds(const ContactRows<L::width>& r, typename L::F threshold) : first(will_bounce<L>(r, 0, threshold)), second{} {
        if (r.two_points) second = will_bounce<L>(r, 1, threshold);
    }
    ISLET_PART bool any() const { return L::bits(first | second) != 0; }
};

/// Solves the normal rows once more, for the rebound speed -e approach. Two points that bounce share the blow: a few passes over both solve their 2 x 2
/// problem, so a box that lands flat bounces flat.
template <class L>
ISLET_PART void solve_restitution(ContactBlock<L>& s, ContactRows<L::width>& r, const Rebounds<L>& rebounds) {
    using F = typename L::F;
    const F zero = L::splat(0.0f);
    F vn = dot(s.n, s.vb - s.va);
    const auto both = rebounds.first & rebounds.second;
    const std::uint32_t rows_to_solve = L::bits(both) != 0 ? 2 * restitution_passes : 2;
    for (std::uint32_t k = 0; k < rows_to_solve; ++k) {
        const std::uint32_t i = k & 1u;
        const auto bounces = k >= 2 ? both : i == 0 ? rebounds.first : rebounds.second;
        if (L::bits(bounces) == 0) continue;
        typename ContactRows<L::width>::Point& p = r.points[i];
        const F rna = L::load(p.rna), rnb = rna + s.rn_ab;
        const F old = L::load(normal_impulse_of(r, i));
        const F speed = vn + (s.wb * rnb - s.wa * rna);
        const F lambda = select(bounces, max(old - L::load(p.normal_mass) * (speed + rebound_of<L>(r, i)), zero), old);
        const F delta = select(bounces, lambda - old, zero);  // an overflowed impulse less itself would be NaN
        L::store(normal_impulse_of(r, i), lambda);
        s.sum_n = s.sum_n + delta;
        vn = vn + (s.ma + s.mb) * delta;
        s.spin_by_normal(rna, rnb, delta);
    }
}

template <std::uint32_t W>
bool ContactKernel<W>::restitute(SolverBody* bodies, Rows* rows, std::uint32_t count, float threshold) {
    using L = LaneOf<W>;
    bool any = false;
    for (std::uint32_t block = 0; block < count; ++block) {
        Rows& r = rows[block];
        if constexpr (W > 1)
            if (!r.rebounds) continue;
        if (!r.is_bouncy()) continue;
        const Rebounds<L> rebounds(r, L::splat(-threshold));
        if (!rebounds.any()) {
            if constexpr (W > 1) r.rebounds = false;
            continue;
        }
        any = true;
        ContactBlock<L> s(bodies, r);
        solve_restitution<L>(s, r, rebounds);
        s.push_centres(s.sum_n * s.n);
        s.scatter(bodies, r);
    }
    return any;
}

/// The absolute value of the sum of a contact's impulses. It is not finite if any of them is not.
template <class L>
ISLET_PART typename L::F size_of(const ContactRows<L::width>& r) {
    using F = typename L::F;
    F sum = L::load(normal_impulse_of(r, 0)) + L::load(tangent_impulse_of(r, 0));
    if (r.two_points) sum = sum + L::load(normal_impulse_of(r, 1)) + L::load(tangent_impulse_of(r, 1));
    if (r.is_special()) sum = sum + L::load(rolling_impulse_of(r));
    return L::abs(sum);
}

template <std::uint32_t W>
void ContactKernel<W>::store(ContactManifold* manifolds, const Rows* rows, std::uint32_t count) {
    using L = LaneOf<W>;
    for (std::uint32_t block = 0; block < count; ++block) {
        const Rows& r = rows[block];
        for (std::uint32_t i = 0; W > 1 && i < W; ++i) {
            if (contact_of(r, i, manifolds) == null_index) continue;
            ContactManifold& m = manifolds[contact_of(r, i, manifolds)];
            m.normal_impulse[0] = normal_impulse_of(r, 0)[i];
            m.tangent_impulse[0] = tangent_impulse_of(r, 0)[i];
            if (m.count() == 2) {
                m.normal_impulse[1] = normal_impulse_of(r, 1)[i];
                m.tangent_impulse[1] = tangent_impulse_of(r, 1)[i];
            }
            if ((m.flags & contact_special) != 0) m.rolling_impulse = rolling_impulse_of(r)[i];
        }
        const std::uint32_t sound = L::bits(size_of<L>(r) < L::splat(unsound_impulse));
        if (sound == (1u << W) - 1) continue;
        for (std::uint32_t i = 0; i < W; ++i)
            if ((sound >> i & 1u) == 0 && (W == 1 || contact_of(r, i, manifolds) != null_index)) manifolds[contact_of(r, i, manifolds)].forget_impulses();
    }
}

}  // namespace islet::detail
