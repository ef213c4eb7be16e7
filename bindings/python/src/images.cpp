// Snapshots and recordings as bytes: what they say about themselves, deltas, replays.
#include "world.hpp"

namespace islet::python {
namespace {

constexpr std::uint64_t usual_memory_limit = 2'000'000'000;  // bytes

py::bytes bytes_of(const std::vector<std::byte>& from, std::size_t count) { return {reinterpret_cast<const char*>(from.data()), count}; }

py::bytes delta_between(py::handle from, py::handle to) {
    const Image before(from), after(to);
    std::vector<std::byte> out(max_delta_bytes(after.bytes().size()));
    Error error = Error::none;
    const std::size_t count = delta(before.bytes(), after.bytes(), out, &error);
    if (count == 0) refuse(error);
    return bytes_of(out, count);
}

py::bytes apply_delta(py::handle from, py::handle difference) {
    const Image before(from), change(difference);
    // A delta may lead to an image of any size.
    for (std::size_t room = before.bytes().size() + 64 * change.bytes().size();; room *= 2) {
        std::vector<std::byte> out(room);
        Error error = Error::none;
        const std::size_t count = apply(before.bytes(), change.bytes(), out, &error);
        if (count != 0) return bytes_of(out, count);
        if (error != Error::image_too_small || room > usual_memory_limit) refuse(error);
    }
}

SnapshotInfo snapshot_info(py::handle image) {
    SnapshotInfo info;
    if (const Error error = read_snapshot(Image(image).bytes(), info); error != Error::none) refuse(error);
    return info;
}

RecordingInfo recording_info(const Image& recording) {
    RecordingInfo info;
    if (const Error error = read_recording(recording.bytes(), info); error != Error::none) refuse(error);
    return info;
}

py::tuple replay_all(py::handle from, py::handle steps, std::uint32_t workers, std::uint64_t memory_limit) {
    const Image recording(from);
    const RecordingInfo info = recording_info(recording);
    if (const std::size_t bytes = world_bytes(info.needed); bytes > memory_limit)
        refuse(Error::bad_capacity, "the recording needs a world of " + std::to_string(bytes) + " bytes, and memory_limit is " + std::to_string(memory_limit));
    const std::uint64_t most = steps.is_none() ? ~std::uint64_t{0} : py::cast<std::uint64_t>(steps);
    PyWorld w;
    w.owner = make_world(info.needed, WorldDef{}, workers, w.world);
    ReplayResult result;
    {
        const Unlocked unlocked(*w.owner);
        result = replay(*w.world, recording.bytes(), most);
    }
    return py::make_tuple(w, result);
}

}  // namespace

void add_images(py::module_& m) {
    m.def("delta", delta_between, py::arg("before"), py::arg("after"), "What changed between two snapshots, packed: apply(before, delta) gives `after` again.");
    m.def("apply", apply_delta, py::arg("before"), py::arg("delta"), "The snapshot to which a delta leads from the snapshot `before`.");
    m.def("read_snapshot", snapshot_info, py::arg("image"), "What a snapshot says about itself.");
    m.def("read_recording", [](py::handle recording) { return recording_info(Image(recording)); }, py::arg("recording"), "What a recording says about itself.");
    m.def("replay", replay_all, py::arg("recording"), py::arg("steps") = py::none(), py::arg("workers") = 1u, py::arg("memory_limit") = usual_memory_limit,
          "Makes the calls of a recording again, in a world of its own, up to and including so many steps. Returns the world and a ReplayResult: whether each "
          "step came out as recorded. A recording whose world needs more than memory_limit bytes is refused.");
}

}  // namespace islet::python
