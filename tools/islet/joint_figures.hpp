// What World::draw draws of joints, as a movie keeps it: marks that are fixed in a body's frame are told once, not in every frame.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "drawing.hpp"
#include "movie.hpp"

namespace islet::tools {

/// A point or a vector in quanta, y up.
struct QuantaPoint {
    double x = 0, y = 0;
};

/// Where a frame of reference lies: x = origin + (c, s), all from the movie's origin.
struct QuantaPose {
    QuantaPoint origin;
    double c = 1, s = 0;
};

/// The frames in which a joint's marks may be fixed.
struct JointFrames {
    std::uint32_t id_a = 0, id_b = 0;  // of the bodies in the movie, + 1; 0: not in it. Then `a` is the first end, in whole quanta and not turned
    QuantaPose a, b;
    QuantaPoint ends[2];
    bool has_ends = false;

    bool has(JointPoint::Frame frame) const;
    /// Where a frame lies; of `between` but for how long its x is.
    QuantaPose pose(JointPoint::Frame frame) const;
    /// The point's place in a frame, and back.
    QuantaPoint local(JointPoint::Frame frame, const QuantaPoint& place) const;
    QuantaPoint place(JointPoint::Frame frame, const QuantaPoint& local) const;
};

/// The marks of a joint as they were drawn.
struct DrawnJoint {
    struct Mark {
        JointMark::Kind kind = JointMark::dot;
        JointMark::Look look = JointMark::plain;
        std::int32_t radius = 0;
        std::uint32_t point_count = 0;
        friend bool operator==(const Mark&, const Mark&) = default;
    };
    std::vector<Mark> marks;
    std::vector<QuantaPoint> points;        // of one mark after the other
    JointMark::Kind ends = JointMark::dot;  // what its ends are: dots, or rings if there are none
};

/// Looks for the two ends of what was drawn.
void find_ends(DrawnJoint& drawn, JointFrames& frames);

class JointFigures {
public:
    /// Marks are within so many quanta of where they were drawn, but for what the frames themselves are rounded by; dots are fixed to their bodies.
    static constexpr double tolerance = 8;

    /// What is to be recorded of the joint in a slot of which this was drawn: what was before, while that still shows it.
    JointEntry entry_of(std::uint32_t slot, const DrawnJoint& drawn, const JointFrames& frames);
    const std::vector<JointFigure>& figures() const { return figures_; }

private:
    /// What was drawn of a joint when its entry was last changed.
    struct Watched {
        bool is_known = false;
        JointEntry entry;
        DrawnJoint drawn;
        JointFrames frames;
    };

    std::uint32_t number_of(const JointFigure& figure);

    std::vector<JointFigure> figures_;
    std::map<std::string, std::vector<std::uint32_t>> alike_;  // figures by what they are made of, but for where the points are
    std::vector<Watched> watched_;                             // by slot
};

}  // namespace islet::tools
