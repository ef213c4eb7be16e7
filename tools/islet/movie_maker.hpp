// Makes a movie of a run, step by step, for the player, from what World::draw hands out: see movie.hpp for the bytes, html.hpp for the page around them.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "drawing.hpp"
#include "joint_figures.hpp"
#include "movie.hpp"
#include "runner.hpp"

namespace islet::tools {

/// How metres become whole quanta. A body is drawn within half a quantum, on either axis, of where it was, and turned within half a
/// 65536th of a turn; a contact is within half of contact_quanta, what is drawn of a joint within JointFigures::tolerance.
struct Scale {
    double quantum = 1;  // m, a power of two: at most a 65536th of what the picture shows, if that is no smaller than 2^-20 m
    double origin_x = 0, origin_y = 0;  // m

    explicit Scale(const Aabb& view);
    std::int32_t x(double metres) const { return quanta(metres - origin_x); }
    std::int32_t y(double metres) const { return quanta(metres - origin_y); }
    std::int32_t quanta(double metres) const;
};

/// Contacts are placed more coarsely than bodies, in steps of this many quanta.
inline constexpr int contact_quanta = 8;

/// What a step did, in numbers.
struct FrameNumbers {
    int step = 0;
    double kinetic_energy = 0, potential_energy = 0;  // J
    double max_penetration = 0, max_joint_error = 0;  // m
    double ms = 0;                                    // of World::step
    std::size_t bodies = 0, awake_bodies = 0, joints = 0, contacts = 0, touching = 0, islands = 0;
};

/// A shape as the player draws it: points in the body's frame, rounded by the radius. One point is a circle, two are a capsule; a negative
/// radius means lines from point to point with nothing inside.
struct Outline {
    float radius = 0;   // m
    bool solid = true;  // false: a sensor
    std::vector<Vec2> points;
};
using Model = std::vector<Outline>;

class MovieMaker {
public:
    /// Bytes that a movie may grow to: as text in the page they take a third more.
    static constexpr std::size_t usual_budget = 14'000'000;

    /// Records the state that the run starts from. The run must outlive the movie.
    explicit MovieMaker(const Run& run, std::size_t budget = usual_budget);
    /// Records the state after a step. When the movie gets larger than the budget it is thinned, and what comes is recorded as thinly:
    /// first every other step is dropped, then the contacts, then every other step again, as often as needed. The last step is always kept.
    void observe(const StepRecord& record);

    const std::string& bytes() const { return writer_.bytes(); }
    const std::vector<FrameNumbers>& numbers() const { return numbers_; }
    const std::vector<Model>& models() const { return models_; }
    const Scale& scale() const { return scale_; }
    /// Every so many steps are recorded.
    int stride() const { return stride_; }
    bool has_contacts() const { return has_contacts_; }
    /// What is drawn of each step.
    const DebugDraw& drawn() const { return what_; }
    /// Those that bodies had at any time.
    const std::set<BodyLook>& looks() const { return looks_; }

private:
    /// What is known of the body in a slot, to see when it has become another.
    struct Known {
        BodyId body;
        std::uint32_t model = 0, id = 0;  // in the movie
    };
    /// Strokes that belong together.
    using Strokes = std::span<const Stroke* const>;

    void record(const StepRecord& record);
    void read_body(Strokes shapes, FrameNumbers& numbers);
    void read_contact(Strokes dots_and_normals, FrameNumbers& numbers);
    void read_joint(Strokes marks);
    std::uint32_t id_of(Strokes shapes, BodyId body);
    bool shows(const Model& model, Strokes shapes, const Transform& pose) const;
    std::uint32_t model_of(Strokes shapes, BodyId body);
    /// A body's id in the movie + 1, or 0 if nothing of it is drawn; and where it is.
    std::uint32_t frame_of(BodyId body, QuantaPose& pose) const;
    QuantaPoint exact_quanta(Vec2 place) const;
    void thin();
    bool keeps(int step) const;

    const Run& run_;
    const std::size_t budget_;
    const Scale scale_;
    DebugDraw what_;
    int stride_ = 1;
    bool has_contacts_ = true;
    Drawing drawing_;
    Frame frame_;
    MovieWriter writer_;
    std::vector<FrameNumbers> numbers_;
    std::vector<Known> known_;  // by slot
    std::vector<ShapeId> shapes_;
    std::vector<Model> models_;
    std::map<std::string, std::uint32_t> model_index_;  // by the models' bytes
    std::set<BodyLook> looks_;
    JointFigures figures_;
    DrawnJoint drawn_joint_;
};

}  // namespace islet::tools
