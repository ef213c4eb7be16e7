// A world as a whole: how it is made, steps, snapshots, recordings, and arrays of all bodies.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <pybind11/numpy.h>

#include "islet/svg.hpp"
#include "world.hpp"

namespace islet::python {
namespace {

std::uint32_t checked_workers(std::uint32_t workers) {
    if (workers == 0 || workers > max_workers) refuse(Error::out_of_range, "workers");
    return workers;
}

constexpr std::uint32_t usual_bodies = 256;

/// What is not said of a capacity follows from the bodies.
Capacity whole(Capacity c) {
    if (c.bodies == 0) c.bodies = usual_bodies;
    if (c.shapes == 0) c.shapes = c.bodies;
    if (c.contacts == 0) c.contacts = 5 * c.shapes;
    return c;
}

PyWorld make(const py::kwargs& named) {
    Capacity capacity;
    WorldDef def;
    std::uint32_t workers = 1;
    py::dict of_capacity, of_def;
    bool said_of_joints = false;  // 0 joints may be meant
    for (const auto& [name, value] : named) {
        const auto is = [name = name](const char* text) { return PyUnicode_CompareWithASCIIString(name.ptr(), text) == 0; };
        said_of_joints |= is("joints") || is("capacity");
        if (is("workers"))
            workers = py::cast<std::uint32_t>(value);
        else if (is("capacity"))
            capacity = py::cast<Capacity>(value);
        else
            (find_field(record_of<Capacity>(), name) != nullptr ? of_capacity : of_def)[name] = value;
    }
    fill_record(&capacity, record_of<Capacity>(), py::tuple(), of_capacity);
    if (!said_of_joints) capacity.joints = capacity.bodies == 0 ? usual_bodies : capacity.bodies;
    fill_record(&def, record_of<WorldDef>(), py::tuple(), of_def);
    PyWorld w;
    w.owner = make_world(whole(capacity), def, workers, w.world);
    return w;
}

void step_world(PyWorld& w, float dt, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        Call call(w);
        const std::uint64_t steps = w.world->step_count();
        {
            const Unlocked unlocked(*w.owner);
            w.world->step(dt);
            w.owner->after_steps();
        }
        const Error error = call.error();
        if (error == Error::none) continue;
        if (w.world->step_count() == steps) refuse(error);
        // The step went on without room for something.
        if (PyErr_WarnEx(PyExc_RuntimeWarning, describe(error), 1) != 0) throw py::error_already_set();
    }
}

py::tuple state(const PyWorld& w) {
    idle_owner_of(w);
    return py::make_tuple(w.world->capacity(), w.world->tasks().workers, save(*w.world));
}

PyWorld from_state(const Capacity& capacity, std::uint32_t workers, py::handle bytes) {
    const Image image(bytes);
    PyWorld w;
    w.owner = make_world(capacity, WorldDef{}, workers, w.world);
    Call call(w);
    w.world->load(image.bytes());
    call.check();
    return w;
}

/// Where rows of the bodies go: an array of yours, of the right shape, or a new one.
py::array_t<float> rows_for(const World& world, py::handle out, py::ssize_t columns) {
    const auto bodies = static_cast<py::ssize_t>(world.capacity().bodies);
    if (out.is_none()) return py::array_t<float>(std::vector<py::ssize_t>{bodies, columns});
    if (!py::isinstance<py::array_t<float>>(out)) throw py::type_error("out must be a C-contiguous array of float32");
    if (!py::isinstance<py::array_t<float, py::array::c_style>>(out)) throw py::value_error("out must be a C-contiguous array of float32");
    auto rows = py::reinterpret_borrow<py::array_t<float>>(out);
    if (reinterpret_cast<std::uintptr_t>(rows.data()) % alignof(float) != 0) throw py::value_error("out must be an aligned array of float32");
    if (rows.ndim() != 2 || rows.shape(0) != bodies || rows.shape(1) != columns || !rows.writeable())
        throw py::value_error("out must be a writable array of shape (" + std::to_string(bodies) + ", " + std::to_string(columns) + ")");
    return rows;
}

template <class F>
py::array_t<float> gather(PyWorld& w, py::handle out, py::ssize_t columns, F put) {
    refuse_if_busy(owner_of(w));
    py::array_t<float> rows = rows_for(*w.world, out, columns);
    float* row = rows.mutable_data();
    for (std::uint32_t slot = 0; slot < w.world->capacity().bodies; ++slot, row += columns) {
        const BodyId body = w.world->body_at(slot);
        if (body)
            put(*w.world, body, row);
        else
            std::fill(row, row + columns, 0.0f);
    }
    return rows;
}

py::bytes stop_recording(PyWorld& w) {
    Owner& owner = idle_owner_of(w);
    const auto found = owner.recording_of(w.world);
    if (found == owner.recordings.end()) refuse(Error::not_a_recording);
    const std::span<const std::byte> bytes = found->second->finish();
    py::bytes made(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    owner.recordings.erase(found);
    if (bytes.empty()) refuse(Error::not_a_recording, "it ended when the world became a copy of another, or for want of room");
    return made;
}

std::string svg(PyWorld& w, py::handle view, const std::string& title, float dt, bool joints) {
    Call call(w);
    tools::Picture picture;
    picture.view = view.is_none() ? view_of(*w.world) : py::cast<Aabb>(view);
    picture.title = title;
    picture.dt = dt;
    DebugDraw what = tools::usual_drawing();
    what.joints = joints;
    std::string text = tools::draw_svg(*w.world, picture, what);
    call.check();
    return text;
}

}  // namespace

std::shared_ptr<Owner> make_world(const Capacity& capacity, const WorldDef& given, std::uint32_t workers, World*& world) {
    if (!is_valid(capacity)) refuse(Error::bad_capacity);
    auto owner = std::make_shared<WorldOwner>(world_bytes(capacity), checked_workers(workers));
    WorldDef def = given;
    if (owner->threads) def.tasks = owner->threads->tasks();
    Error error = Error::none;
    world = World::create({owner->block, owner->size}, capacity, def, &error);
    if (world == nullptr) {
        const FieldFault fault = find_fault(def);
        refuse(error, fault.field != nullptr ? fault.field : "");
    }
    return owner;
}

Image::Image(py::handle from) {
    if (PyObject_CheckBuffer(from.ptr()) == 0) throw py::type_error("bytes are wanted, not " + py::cast<std::string>(py::repr(py::type::handle_of(from))));
    info_ = py::reinterpret_borrow<py::buffer>(from).request();
    py::ssize_t stride = info_.itemsize;
    for (py::ssize_t i = info_.ndim; i-- > 0; stride *= info_.shape[static_cast<std::size_t>(i)])
        if (info_.strides[static_cast<std::size_t>(i)] != stride) throw py::type_error("the bytes must lie in a row");
    const auto size = static_cast<std::size_t>(info_.size * info_.itemsize);
    if (reinterpret_cast<std::uintptr_t>(info_.ptr) % snapshot_alignment != 0) {
        copy_.resize((size + 7) / 8);
        std::memcpy(copy_.data(), info_.ptr, size);
        bytes_ = {reinterpret_cast<const std::byte*>(copy_.data()), size};
    } else {
        bytes_ = {static_cast<const std::byte*>(info_.ptr), size};
    }
}

py::bytes save(const World& world) {
    const std::size_t size = world.snapshot_bytes();
    auto made = py::reinterpret_steal<py::bytes>(PyBytes_FromStringAndSize(nullptr, static_cast<py::ssize_t>(size)));
    if (!made) throw py::error_already_set();
    if (world.save({reinterpret_cast<std::byte*>(PyBytes_AS_STRING(made.ptr())), size}) != size) refuse(world.last_error());
    return made;
}

Aabb view_of(const World& world) {
    constexpr float farthest = 1.0e4f;  // m
    std::optional<Aabb> all;
    for (const ShapeId shape : all_shapes(world)) {
        const Aabb box = world.aabb(shape);
        if (!(abs(box.lower.x) < farthest && abs(box.lower.y) < farthest && abs(box.upper.x) < farthest && abs(box.upper.y) < farthest)) continue;
        all = all ? merge(*all, box) : box;
    }
    if (!all) return {{-10, -1}, {10, 11}};
    return expand(*all, 0.5f + 0.02f * (all->upper.x - all->lower.x));
}

void add_state(WorldClass& w) {
    w.def(py::init([](const py::kwargs& named) { return make(named); }));
    w.def("step", step_world, py::arg("dt") = 1.0f / 60, py::arg("count") = 1u,
          "Advances time by dt seconds, `count` times. Other threads run meanwhile. Where there is no room for a contact or an event, the step goes on, and a "
          "RuntimeWarning says so.");
    w.def(
        "hash", [](const PyWorld& world) { return idle_owner_of(world), world.world->hash(); },
        "Hash of all state that affects the future. Worlds with equal hashes have equal futures.");
    w.def(
        "save", [](const PyWorld& world) { return idle_owner_of(world), save(*world.world); }, "A snapshot of the world.");
    w.def(
        "restore",
        [](PyWorld& world, py::handle bytes) {
            const Image image(bytes);
            Call call(world);
            world.world->load(image.bytes());
            call.check();
        },
        py::arg("image"), "Takes the world back to a snapshot, of which nothing is used before all of it is found sound.");
    w.def(
        "copy",
        [](const PyWorld& world) {
            const py::tuple s = state(world);
            return from_state(s[0].cast<Capacity>(), s[1].cast<std::uint32_t>(), s[2]);
        },
        "A world of its own that is now the same.");
    w.def(
        "validate",
        [](PyWorld& world) {
            idle_owner_of(world);
            const char* const broken = world.world->validate();
            return broken == nullptr ? py::object(py::none()) : py::object(py::str(broken));
        },
        "Checks every internal invariant: None, or a sentence that says what is broken. Slow.");
    w.def_property_readonly(
        "workers", [](const PyWorld& world) { return owner_of(world), world.world->tasks().workers; }, "Threads that step the world.");
    w.def_property_readonly(
        "error", [](const PyWorld& world) { return owner_of(world), world.world->last_error(); }, "The last error.");
    w.def(
        "poses",
        [](PyWorld& world, py::handle out) {
            return gather(world, out, 4, [](const World& in, BodyId body, float* row) {
                const Transform t = in.transform(body);
                row[0] = t.p.x, row[1] = t.p.y, row[2] = t.q.c, row[3] = t.q.s;
            });
        },
        py::arg("out") = py::none(), "x, y, cosine and sine of each body, a row for each slot (zeros where there is no body).");
    w.def(
        "velocities",
        [](PyWorld& world, py::handle out) {
            return gather(world, out, 3, [](const World& in, BodyId body, float* row) {
                const Vec2 v = in.linear_velocity(body);
                row[0] = v.x, row[1] = v.y, row[2] = in.angular_velocity(body);
            });
        },
        py::arg("out") = py::none(), "Velocity x, y and angular velocity of each body, a row for each slot (zeros where there is no body).");
    w.def(
        "start_recording",
        [](PyWorld& world) {
            Owner& owner = idle_owner_of(world);
            auto begun = std::make_unique<samples::WorldRecording>(*world.world);
            if (const auto found = owner.recording_of(world.world); found != owner.recordings.end())
                found->second = std::move(begun);  // which has ended the other
            else
                owner.recordings.emplace_back(world.world, std::move(begun));
        },
        "Records from now on every call that changes the world, and what its fleet does with it. To become a copy of another world ends the recording.");
    w.def("stop_recording", stop_recording, "Ends the recording; its bytes, for `islet replay`.");
    w.def("svg", svg, py::arg("view") = py::none(), py::arg("title") = "", py::arg("dt") = 1.0f / 60, py::arg("joints") = true,
          "A picture: an SVG document. Of the box `view`, or of all shapes, with joints or without.");
    w.def("_repr_svg_", [](PyWorld& world) { return svg(world, py::none(), "", 1.0f / 60, true); });
    w.def("__repr__", [](const PyWorld& world) {
        owner_of(world);
        return "<islet.World: " + std::to_string(world.world->body_count()) + " bodies, " + std::to_string(world.world->shape_count()) + " shapes, " +
               std::to_string(world.world->joint_count()) + " joints, " + std::to_string(world.world->step_count()) + " steps>";
    });
    w.def(py::pickle([](const PyWorld& world) { return state(world); },
                     [](const py::tuple& s) { return from_state(s[0].cast<Capacity>(), s[1].cast<std::uint32_t>(), s[2]); }));
    w.def("__copy__", [](const py::object& self) { return self.attr("copy")(); });
    w.def("__deepcopy__", [](const py::object& self, py::handle) { return self.attr("copy")(); });
}

}  // namespace islet::python
