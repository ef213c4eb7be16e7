// Islands as a world exports them, in memory of their own, and once more in double precision, put together anew from their rows.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "islet/island.hpp"
#include "islet/islet.hpp"

namespace islet::test {

inline constexpr float substep = 1.0f / 240;  // s, for which tests export islands

/// Empty, with the error on the world's account, if the body has none.
class ExportedIsland {
public:
    ExportedIsland(const World& w, BodyId body, float h) {
        IslandProblem nothing;
        memory_.resize(w.export_island(body, h, {}, nothing));
        if (!memory_.empty()) w.export_island(body, h, memory_, problem_);
    }
    const IslandProblem& operator*() const { return problem_; }
    const IslandProblem* operator->() const { return &problem_; }
    std::size_t bytes() const { return memory_.size(); }

    /// Place of a body in the island, or no_body.
    std::uint32_t place_of(BodyId body) const {
        for (std::uint32_t i = 0; i < problem_.bodies.size(); ++i)
            if (problem_.bodies[i].id == body) return i;
        return no_body;
    }
    /// Sum of x over the rows of a kind.
    template <class T>
    double sum_of(RowKind kind, const std::vector<T>& x) const {
        double sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += problem_.rows[i].kind == kind ? static_cast<double>(x[i]) : 0;
        return sum;
    }

private:
    std::vector<std::byte> memory_;
    IslandProblem problem_;
};

/// Null, or what is wrong with the form of the problem: whatever its numbers are, every index leads somewhere.
inline const char* fault_in(const IslandProblem& p) {
    const auto& [starts, columns, values] = p.lcp.sparse;
    const std::size_t n = p.rows.size();
    if (p.lcp.q.size() != n || p.lcp.lo.size() != n || p.lcp.hi.size() != n || p.lcp.friction.size() != n || p.impulses.size() != n)
        return "spans of different lengths";
    if (starts.size() != n + 1 || starts[0] != 0 || starts[n] != values.size() || columns.size() != values.size()) return "row starts";
    for (std::size_t i = 0; i < n; ++i) {
        bool diagonal = false;
        for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) {
            if (columns[k] >= n || (k > starts[i] && columns[k] <= columns[k - 1])) return "columns";
            diagonal = diagonal || columns[k] == i;
        }
        if (!diagonal) return "no diagonal";
        const IslandRow& r = p.rows[i];
        if (r.end_count < 1 || r.end_count > 4) return "ends";
        for (std::uint32_t e = 0; e < r.end_count; ++e)
            if (r.ends[e].body != no_body && r.ends[e].body >= p.bodies.size()) return "a body";
        if (p.lcp.lo[i] > p.lcp.hi[i]) return "bounds";
        const std::uint32_t normal = p.lcp.friction[i];
        if ((r.kind == RowKind::friction) != (normal != lcp::no_row)) return "friction of something else";
        if (normal == lcp::no_row) continue;
        if (normal >= n || p.rows[normal].kind != RowKind::normal || p.rows[normal].slot != r.slot || p.rows[normal].index != r.index)
            return "friction of another point";
    }
    return nullptr;
}

/// The matrix and q by the formulas of island.hpp, from rows and bodies alone.
struct WideProblem {
    std::size_t n = 0;
    std::vector<double> m, q, lo, hi;
    std::vector<std::uint32_t> friction;

    explicit WideProblem(const IslandProblem& p)
        : n(p.rows.size()),
          m(n * n),
          lo(p.lcp.lo.begin(), p.lcp.lo.end()),
          hi(p.lcp.hi.begin(), p.lcp.hi.end()),
          friction(p.lcp.friction.begin(), p.lcp.friction.end()) {
        for (std::size_t i = 0; i < n; ++i) {
            const IslandRow& r = p.rows[i];
            double w = static_cast<double>(r.bias);
            for (std::uint32_t a = 0; a < r.end_count; ++a) {
                const RowEnd& e = r.ends[a];
                if (e.body == no_body) continue;
                const IslandBody& b = p.bodies[e.body];
                w += wide_dot(e.linear, b.v_free) + static_cast<double>(e.angular) * static_cast<double>(b.w_free);
                for (std::size_t k = 0; k < n; ++k) {
                    for (std::uint32_t c = 0; c < p.rows[k].end_count; ++c) {
                        const RowEnd& f = p.rows[k].ends[c];
                        if (f.body == e.body)
                            m[i * n + k] +=
                                static_cast<double>(b.inv_mass) * wide_dot(e.linear, f.linear) +
                                static_cast<double>(b.inv_inertia) * static_cast<double>(e.angular) * static_cast<double>(f.angular);
                    }
                }
            }
            m[i * n + i] += static_cast<double>(r.softness);
            q.push_back(w);
        }
    }

    lcp::Problem<double> lcp() const { return {.dense = {m}, .sparse = {}, .q = q, .lo = lo, .hi = hi, .friction = friction}; }

    static double wide_dot(Vec2 a, Vec2 b) {
        return static_cast<double>(a.x) * static_cast<double>(b.x) + static_cast<double>(a.y) * static_cast<double>(b.y);
    }
};

struct WideSolution {
    lcp::Result<double> result;
    std::vector<double> x;
};

/// Starts from the stored impulses.
inline WideSolution solve(const ExportedIsland& island, lcp::Method method, double tolerance = 1e-10, std::uint32_t iterations = 100000) {
    const WideProblem wide(*island);
    WideSolution s;
    s.x.assign(island->impulses.begin(), island->impulses.end());
    std::vector<std::byte> memory(lcp::workspace_bytes<double>(method, wide.n));
    s.result = lcp::solve<double>(wide.lcp(), {.method = method, .max_iterations = iterations, .tolerance = tolerance}, s.x, memory);
    return s;
}

/// Velocities of the island's bodies after impulses x: v = v_free + M_b^-1 J^T x.
struct WideVelocity {
    double vx = 0, vy = 0, w = 0;
};
inline std::vector<WideVelocity> velocities_after(const IslandProblem& p, const std::vector<double>& x) {
    std::vector<WideVelocity> out;
    for (const IslandBody& b : p.bodies)
        out.push_back({static_cast<double>(b.v_free.x), static_cast<double>(b.v_free.y), static_cast<double>(b.w_free)});
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::uint32_t k = 0; k < p.rows[i].end_count; ++k) {
            const RowEnd& e = p.rows[i].ends[k];
            if (e.body == no_body) continue;
            const IslandBody& b = p.bodies[e.body];
            out[e.body].vx += static_cast<double>(b.inv_mass) * x[i] * static_cast<double>(e.linear.x);
            out[e.body].vy += static_cast<double>(b.inv_mass) * x[i] * static_cast<double>(e.linear.y);
            out[e.body].w += static_cast<double>(b.inv_inertia) * x[i] * static_cast<double>(e.angular);
        }
    }
    return out;
}

}  // namespace islet::test
