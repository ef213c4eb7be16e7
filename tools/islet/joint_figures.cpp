#include "joint_figures.hpp"

#include <algorithm>
#include <cmath>

namespace islet::tools {
namespace {

constexpr double rounding = 2;          // quanta: two figures that differ by no more are one
constexpr double shortest = 16;         // quanta: of a way from end to end
constexpr std::size_t most_tried = 32;  // figures alike that are compared, the latest first

QuantaPoint operator-(const QuantaPoint& a, const QuantaPoint& b) { return {a.x - b.x, a.y - b.y}; }
double length(const QuantaPoint& p) { return std::hypot(p.x, p.y); }

std::int32_t rounded(double n) {
    return std::isfinite(n) ? static_cast<std::int32_t>(std::lround(std::clamp(n, -double(farthest_mark), double(farthest_mark)))) : 0;
}

JointPoint rounded(JointPoint::Frame frame, const QuantaPoint& local) { return {frame, rounded(local.x), rounded(local.y)}; }

/// Whether a figure shows what was drawn, within the tolerance.
bool shows(const JointFigure& figure, const DrawnJoint& drawn, const JointFrames& frames) {
    if (figure.size() != drawn.marks.size()) return false;
    std::size_t next = 0;  // point
    for (std::size_t m = 0; m < figure.size(); ++m) {
        const JointMark& mark = figure[m];
        if (DrawnJoint::Mark{mark.kind, mark.look, mark.radius, static_cast<std::uint32_t>(mark.points.size())} != drawn.marks[m]) return false;
        for (const JointPoint& p : mark.points) {
            if (!frames.has(p.frame)) return false;
            if (!(length(frames.place(p.frame, {double(p.x), double(p.y)}) - drawn.points[next++]) <= JointFigures::tolerance)) return false;
        }
    }
    return true;
}

/// What a point of a joint never seen before is likely to be fixed to: the way from end to end if it lies there, else the body of the nearer end.
JointPoint::Frame guess(const JointFrames& frames, const QuantaPoint& place) {
    if (frames.has(JointPoint::between)) {
        const QuantaPoint p = frames.local(JointPoint::between, place);
        if (p.x > 0.01 * between_parts && p.x < 0.99 * between_parts) return JointPoint::between;
    }
    const bool is_nearer_b = frames.has_ends && length(place - frames.ends[1]) < length(place - frames.ends[0]);
    if (is_nearer_b && frames.has(JointPoint::body_b)) return JointPoint::body_b;
    if (frames.has(JointPoint::body_a)) return JointPoint::body_a;
    return frames.has(JointPoint::body_b) ? JointPoint::body_b : JointPoint::world;
}

/// The frame in which a point has moved the least.
JointPoint::Frame steadiest(const JointFrames& before, const QuantaPoint& was, const JointFrames& now, const QuantaPoint& is, bool is_end) {
    // Those that an end may be fixed in come first.
    constexpr JointPoint::Frame tried[] = {JointPoint::body_a,       JointPoint::body_b,    JointPoint::world,    JointPoint::end_a_turn_b,
                                           JointPoint::end_b_turn_a, JointPoint::end_a_way, JointPoint::end_b_way, JointPoint::between};
    JointPoint::Frame best = JointPoint::world;
    double least = 1e300;
    for (const JointPoint::Frame frame : tried) {
        if (is_end && frame >= JointPoint::end_a_turn_b) break;
        if (!before.has(frame) || !now.has(frame)) continue;
        const double moved = length(now.place(frame, before.local(frame, was)) - is);
        if (moved < 0.5 * least) {
            least = std::max(moved, 0.1);
            best = frame;
        }
    }
    return best;
}

}  // namespace

bool JointFrames::has(JointPoint::Frame frame) const {
    switch (frame) {
    case JointPoint::world: return true;
    case JointPoint::body_a: return id_a != 0 || has_ends;
    case JointPoint::body_b: return id_b != 0;
    case JointPoint::end_a_turn_b: return id_b != 0 && has_ends;
    case JointPoint::end_b_turn_a: return has_ends;
    default: return has_ends && length(ends[1] - ends[0]) >= shortest;
    }
}

QuantaPose JointFrames::pose(JointPoint::Frame frame) const {
    switch (frame) {
    case JointPoint::world: return {};
    case JointPoint::body_a: return a;
    case JointPoint::body_b: return b;
    case JointPoint::end_a_turn_b: return {ends[0], b.c, b.s};
    case JointPoint::end_b_turn_a: return {ends[1], a.c, a.s};
    default: {
        const QuantaPoint way = ends[1] - ends[0];
        const double far = length(way);
        return {ends[frame == JointPoint::end_b_way ? 1 : 0], way.x / far, way.y / far};
    }
    }
}

QuantaPoint JointFrames::local(JointPoint::Frame frame, const QuantaPoint& place) const {
    const QuantaPose in = pose(frame);
    const QuantaPoint d = place - in.origin;
    const double unit = frame == JointPoint::between ? between_parts / length(ends[1] - ends[0]) : 1;
    return {unit * (in.c * d.x + in.s * d.y), in.c * d.y - in.s * d.x};
}

QuantaPoint JointFrames::place(JointPoint::Frame frame, const QuantaPoint& local) const {
    const QuantaPose in = pose(frame);
    const double x = frame == JointPoint::between ? local.x / between_parts * length(ends[1] - ends[0]) : local.x;
    return {in.origin.x + in.c * x - in.s * local.y, in.origin.y + in.s * x + in.c * local.y};
}

void find_ends(DrawnJoint& drawn, JointFrames& frames) {
    for (const JointMark::Kind kind : {JointMark::dot, JointMark::ring}) {
        drawn.ends = kind;
        std::size_t found = 0, next = 0;  // point
        for (const DrawnJoint::Mark& mark : drawn.marks) {
            if (mark.kind == kind && found < 2) frames.ends[found++] = drawn.points[next];
            next += mark.point_count;
        }
        frames.has_ends = found == 2;
        if (frames.has_ends) break;
    }
    if (frames.id_a == 0) frames.a = {{std::round(frames.ends[0].x), std::round(frames.ends[0].y)}, 1, 0};
}

JointEntry JointFigures::entry_of(std::uint32_t slot, const DrawnJoint& drawn, const JointFrames& frames) {
    if (slot >= watched_.size()) watched_.resize(slot + 1);
    Watched& last = watched_[slot];
    const bool is_same_joint = last.is_known && last.entry.body_a == frames.id_a && last.entry.body_b == frames.id_b;
    if (!is_same_joint || !shows(figures_[last.entry.figure], drawn, frames)) {
        const bool compares = is_same_joint && drawn.marks == last.drawn.marks;
        JointFigure figure;
        std::size_t next = 0;  // point
        for (const DrawnJoint::Mark& mark : drawn.marks) {
            figure.push_back({mark.kind, mark.look, mark.radius, {}});
            for (std::uint32_t i = 0; i < mark.point_count; ++i, ++next) {
                const QuantaPoint& p = drawn.points[next];
                const JointPoint::Frame frame =
                    compares ? steadiest(last.frames, last.drawn.points[next], frames, p, mark.kind == drawn.ends) : guess(frames, p);
                figure.back().points.push_back(rounded(frame, frames.local(frame, p)));
            }
        }
        last = {true, {number_of(figure), frames.id_a, frames.id_b, 0, 0}, drawn, frames};
    }
    if (frames.id_a == 0) {
        last.entry.x = rounded(frames.a.origin.x);
        last.entry.y = rounded(frames.a.origin.y);
    }
    return last.entry;
}

/// That of a figure which is the same but for rounding, or a new one.
std::uint32_t JointFigures::number_of(const JointFigure& figure) {
    std::string key;
    for (const JointMark& mark : figure) {
        key += static_cast<char>(16 * mark.kind + mark.look);
        key += std::to_string(mark.radius);
        for (const JointPoint& point : mark.points) key += static_cast<char>('a' + point.frame);
    }
    const auto nearly_same = [](const JointMark& a, const JointMark& b) {
        return std::equal(a.points.begin(), a.points.end(), b.points.begin(), [](const JointPoint& p, const JointPoint& q) {
            return std::abs(p.x - q.x) <= rounding && std::abs(p.y - q.y) <= rounding;
        });
    };
    std::vector<std::uint32_t>& alike = alike_[key];
    for (std::size_t i = 0; i < std::min(most_tried, alike.size()); ++i) {
        const std::uint32_t number = alike[alike.size() - 1 - i];
        if (std::equal(figure.begin(), figure.end(), figures_[number].begin(), nearly_same)) return number;
    }
    alike.push_back(static_cast<std::uint32_t>(figures_.size()));
    figures_.push_back(figure);
    return alike.back();
}

}  // namespace islet::tools
