#include "../exact.hpp"

#include "islet/types.hpp"

namespace islet {

const char* describe(Error e) {
    switch (e) {
        case Error::none: return "No error.";
        case Error::null_id: return "The id is null: use one that a create function returned, and check it for null there.";
        case Error::stale_id: return "The id is stale: the object was destroyed, or belongs to another world. Drop the id.";
        case Error::not_finite: return "A number is NaN or infinite: check the arguments of the call.";
        case Error::out_of_range: return "A number is outside its range: the comment on the field or function gives the range.";
        case Error::bad_time_step: return "The time step must be from a microsecond to a second: 1/60 is usual.";
        case Error::bad_geometry:
            return "The geometry breaks its rules: sizes are above 0, polygons convex with 3 to 8 corners, not in one line (make_polygon, make_box), and boxes "
                   "have lower <= upper.";
        case Error::bad_chain: return "A chain needs at least 2 points (3 for a loop), neighbours more than 0.005 m apart.";
        case Error::bodies_full: return "No room for another body: raise Capacity::bodies.";
        case Error::shapes_full: return "No room for another shape: raise Capacity::shapes.";
        case Error::contacts_full:
            return "No room for another contact: raise Capacity::contacts to 3 to 5 for each moving shape, 7 in a squeezed pile. Each step tries again.";
        case Error::geometries_full: return "No room for another different geometry: raise Capacity::geometries.";
        case Error::block_too_small: return "The memory given is too small: world_bytes(capacity) says how much is needed.";
        case Error::block_misaligned: return "The memory given must be aligned to world_alignment bytes.";
        case Error::bad_capacity: return "A world needs room for at least one body, shape and contact, and for at most max_capacity of each.";
        case Error::events_full: return "More contacts began or ended than there is room to report: raise Capacity::events, or destroy less between steps.";
        case Error::joints_full: return "No room for another joint: raise Capacity::joints.";
        case Error::same_body: return "A joint needs two different bodies.";
        case Error::no_dynamic_body: return "A joint needs at least one dynamic body, and so does an island: impulses do not move the others.";
        case Error::wrong_joint_type: return "Joints of this type have no such property; gears couple revolute and prismatic joints only.";
        case Error::image_too_small: return "The memory given for the image is too small: snapshot_bytes or max_delta_bytes says how much is needed.";
        case Error::image_misaligned: return "An image to load must be aligned to snapshot_alignment bytes: copy it to memory that is.";
        case Error::not_an_image: return "These bytes are no image of this kind: snapshots come from World::save, deltas from delta.";
        case Error::other_byte_order: return "The image comes from a machine of the other byte order (big- and little-endian): step the world there, or here.";
        case Error::other_version: return "Another version of Islet wrote this, in another format: use one version at both ends. describe_format names both.";
        case Error::truncated_image: return "The image is shorter or longer than it says: give all of it, and nothing else.";
        case Error::corrupt_image: return "The image is not as it was saved: its checksum is wrong. Get it again.";
        case Error::unsound_image: return "The image has a right checksum but holds no sound world: whoever made it is not to be trusted.";
        case Error::image_too_large: return "The world is too small for the image: read_snapshot says which capacity it needs.";
        case Error::wrong_delta: return "The delta does not start from the image given: apply it to the one it was made from.";
        case Error::feature_cut:
            return "This program lacks a part of the engine that the call needs. In the small profile, ISLET_WITH puts it back; elsewhere, take it out of "
                   "ISLET_WITHOUT, or link it (World::load links joints).";
        case Error::not_a_sensor: return "The shape is no sensor: ShapeDef::sensor makes one.";
        case Error::recording_full: return "The memory for the recording is used up: it holds everything before this call. Give more, or move it in time.";
        case Error::not_a_recording: return "These bytes are no recording, or nothing is being recorded: start_recording begins one.";
        case Error::corrupt_recording: return "The recording is not as it was made: its sums are wrong. Get it again.";
        case Error::in_step:
            return "A hook, the error hook or a drawing function must not change, step, save, hash or draw the world that calls it: note what to do, and do it "
                   "after.";
        case Error::inexact_build:
            return "The engine's floats are not IEEE's: compile it without -ffast-math and -ffp-contract=fast, for a unit that keeps denormal numbers.";
        case Error::endless_shape: return "A dynamic body cannot have a shape without end: make the body static or kinematic, or give it a box.";
        case Error::hits_full: return "More hits in one step than there is room to report: raise Capacity::hits or the hit threshold.";
    }
    return "Unknown error.";
}

}  // namespace islet
