// Fleets: actions and observations are numpy's arrays, which the engine reads and writes where they are.
#include <cstring>
#include <new>
#include <string>
#include <type_traits>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "world.hpp"

namespace islet::python {
namespace {

struct PyFleet final : Owner {
    PyFleet(const World& prototype, std::uint32_t worlds, std::uint32_t workers_) : workers(workers_) {
        if (workers == 0 || workers > max_workers) refuse(Error::out_of_range, "workers");
        const std::size_t bytes = Fleet::bytes(worlds, prototype.capacity(), workers);
        if (bytes == 0) refuse(Error::out_of_range, "worlds");
        if (workers > 1) threads = std::make_unique<Threads>(workers);
        block = static_cast<std::byte*>(::operator new (bytes, std::align_val_t{world_alignment}));
        Error error = Error::none;
        fleet = Fleet::create({block, bytes}, prototype, worlds, threads ? threads->tasks() : TaskSystem{}, &error);
        if (fleet == nullptr) {
            ::operator delete (block, std::align_val_t{world_alignment});
            refuse(error);
        }
        for (std::uint32_t k = 0; k < worlds; ++k) (*fleet)[k].set_hooks({});  // which belong to the prototype
    }
    ~PyFleet() override { ::operator delete (block, std::align_val_t{world_alignment}); }

    std::uint32_t workers;
    std::unique_ptr<Threads> threads;
    std::byte* block = nullptr;
    Fleet* fleet = nullptr;
    std::vector<Drive> drives;
    std::vector<Sense> senses;
};
using Shared = std::shared_ptr<PyFleet>;

void check(Error error, const char* detail = "") {
    if (error != Error::none) refuse(error, detail);
}

std::string shape_of(const std::vector<py::ssize_t>& shape) { return py::cast<std::string>(py::str(py::tuple(py::cast(shape)))); }

/// An array of the caller's as the engine reads it: of this type and shape, in a row. It stays the caller's; nothing is copied.
/// Raises TypeError for another type, and ValueError for another shape or layout.
template <class T>
T* array_of(py::handle given, const std::vector<py::ssize_t>& shape, const char* name, bool writes) {
    const auto complaint = [&](const std::string& what) {
        return std::string(name) + " must be a C-contiguous array of " + py::cast<std::string>(py::str(py::dtype::of<T>())) + " of shape " + shape_of(shape) +
               ", not " + what;
    };
    if (!py::isinstance<py::array>(given)) throw py::type_error(complaint(py::cast<std::string>(py::str(py::type::handle_of(given)))));
    auto array = py::reinterpret_borrow<py::array>(given);
    const std::vector<py::ssize_t> is(array.shape(), array.shape() + array.ndim());
    const std::string kind = py::cast<std::string>(py::str(array.dtype())) + " of shape " + shape_of(is);
    if (!py::isinstance<py::array_t<T>>(given)) throw py::type_error(complaint(kind));
    if (is != shape) throw py::value_error(complaint(kind));
    if ((array.flags() & py::array::c_style) == 0) throw py::value_error(complaint("one with gaps or another order"));
    if (reinterpret_cast<std::uintptr_t>(array.data()) % alignof(T) != 0) throw py::value_error(complaint("one that is not aligned"));
    if (writes && !array.writeable()) throw py::value_error(complaint("a read-only one"));
    return const_cast<T*>(static_cast<const T*>(array.data()));
}

std::uint32_t worlds_of(const PyFleet& f) {
    if (f.fleet == nullptr) throw py::type_error("Fleet.__init__ was not called");  // Fleet.__new__ alone makes none
    return f.fleet->size();
}
py::ssize_t size(const PyFleet& f) { return static_cast<py::ssize_t>(worlds_of(f)); }

/// For calls that use the worlds. What runs Python comes before it: another thread may begin a step meanwhile.
Fleet& idle(const PyFleet& f) {
    refuse_if_busy(f);
    worlds_of(f);
    return *f.fleet;
}

/// Whether two arrays share memory.
bool overlap(py::handle a, py::handle b) {
    if (a.is_none() || b.is_none()) return false;
    const auto range = [](py::handle of) {
        const auto array = py::reinterpret_borrow<py::array>(of);
        const auto begin = reinterpret_cast<std::uintptr_t>(array.data());
        return std::pair{begin, begin + static_cast<std::uintptr_t>(array.nbytes())};
    };
    const auto [begin_a, end_a] = range(a);
    const auto [begin_b, end_b] = range(b);
    return begin_a < end_b && begin_b < end_a;
}

span<const std::uint8_t> mask_of(const PyFleet& f, py::handle mask) {
    if (mask.is_none()) return {};
    const auto n = static_cast<std::size_t>(worlds_of(f));
    if (py::isinstance<py::array_t<bool>>(mask)) return {reinterpret_cast<const std::uint8_t*>(array_of<bool>(mask, {size(f)}, "mask", false)), n};
    return {array_of<std::uint8_t>(mask, {size(f)}, "mask", false), n};
}

/// Where observations go: `out`, or a new array of zeros.
py::object observations_for(const PyFleet& f, py::handle out) {
    const std::vector<py::ssize_t> shape = {size(f), static_cast<py::ssize_t>(columns(f.senses))};
    if (!out.is_none()) {
        array_of<float>(out, shape, "out", true);
        return py::reinterpret_borrow<py::object>(out);
    }
    py::array_t<float> made(shape);
    if (made.size() > 0) std::memset(made.mutable_data(), 0, static_cast<std::size_t>(made.nbytes()));
    return made;
}
span<float> floats(py::object& array) {
    auto values = py::reinterpret_borrow<py::array>(array);
    return {static_cast<float*>(values.mutable_data()), static_cast<std::size_t>(values.size())};
}

py::object step_fleet(PyFleet& f, py::handle actions, float dt, std::uint32_t repeat, py::handle mask, py::handle out) {
    idle(f);
    FleetStep what;
    what.dt = dt;
    what.repeat = repeat;
    what.mask = mask_of(f, mask);
    if (!actions.is_none()) {
        what.actions = {array_of<float>(actions, {size(f), static_cast<py::ssize_t>(f.drives.size())}, "actions", false),
                        std::size_t{worlds_of(f)} * f.drives.size()};
        what.drives = f.drives;
    }
    py::object observations = py::none();
    if (!f.senses.empty()) {
        observations = observations_for(f, out);
        if (overlap(out, actions) || overlap(out, mask)) throw py::value_error("out must share no memory with actions and mask");
        what.senses = f.senses;
        what.observations = floats(observations);
    } else if (!out.is_none()) {
        throw py::value_error("out needs a fleet with senses");
    }
    Error error = Error::none;
    {
        const Unlocked unlocked(f);
        error = f.fleet->step(what);
        f.after_steps();
    }
    check(error);
    return observations;
}

py::object observe(PyFleet& f, py::handle mask, py::handle out) {
    idle(f);
    py::object observations = observations_for(f, out);
    if (overlap(out, mask)) throw py::value_error("out must share no memory with mask");
    check(f.fleet->observe(f.senses, floats(observations), mask_of(f, mask)));
    return observations;
}

/// A world of the fleet; -1 is the last.
std::uint32_t place(const PyFleet& f, py::ssize_t k) {
    if (k < 0) k += size(f);
    if (k < 0 || k >= size(f)) throw py::index_error("the fleet has " + std::to_string(size(f)) + " worlds");
    return static_cast<std::uint32_t>(k);
}

template <class T>
std::vector<T> list_of(py::handle values) {
    std::vector<T> all;
    for (const py::handle value : values) all.push_back(py::cast<T>(value));
    return all;
}

bool is_of_joint(const Drive& drive) { return drive.kind >= DriveKind::joint_torque; }
bool is_of_joint(const Sense& sense) { return sense.kind == SenseKind::joint; }

/// Drives or senses. Each names the body or joint that its kind needs: a step would refuse it, too, but could not say which one it is.
template <class T>
std::vector<T> columns_of(py::handle values) {
    std::vector<T> all = list_of<T>(values);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool of_joint = is_of_joint(all[i]);
        if ((of_joint ? all[i].joint.index1 : all[i].body.index1) != 0) continue;
        const std::string kind = py::cast<std::string>(py::cast(all[i].kind).attr("name"));
        refuse(Error::null_id, (std::is_same_v<T, Drive> ? "drives[" : "senses[") + std::to_string(i) + (of_joint ? "].joint" : "].body") + " of kind " + kind);
    }
    return all;
}

/// Sets drives or senses.
template <class T>
void set_columns(PyFleet& f, std::vector<T>& columns, py::handle values) {
    std::vector<T> made = columns_of<T>(values);
    idle(f);
    columns = std::move(made);
}

void reset(PyFleet& f, py::ssize_t k, py::handle bytes, std::uint64_t seed, py::handle variations) {
    const Image image(bytes);
    const std::vector<Variation> changes = list_of<Variation>(variations);
    idle(f);
    // What comes from a file may be damaged: reset() trusts it, a world's load() does not.
    World& world = (*f.fleet)[place(f, k)];
    const py::bytes before = save(world);
    detail::begin_call(&world);
    world.load(image.bytes());
    check(detail::end_call(&world, Error::none), "image");
    const Error error = f.fleet->reset(place(f, k), image.bytes(), seed, changes);
    if (error == Error::none) return;
    const Image old(before);
    world.restore(old.bytes());
    refuse(error);
}

void fork(PyFleet& f, py::handle parents) {
    const auto n = static_cast<std::size_t>(worlds_of(f));
    if (py::isinstance<py::array_t<std::uint32_t>>(parents)) {
        idle(f);
        check(f.fleet->fork({array_of<std::uint32_t>(parents, {size(f)}, "parents", false), n}), "parents");
        return;
    }
    std::vector<std::uint32_t> all;
    for (const py::handle parent : parents) {
        const auto k = py::cast<long long>(parent);
        all.push_back(k < 0 || k >= static_cast<long long>(n) ? 0xffffffffu : static_cast<std::uint32_t>(k));
    }
    check(idle(f).fork(all), "parents");
}

Shared make(const PyWorld& prototype, std::uint32_t worlds, std::uint32_t workers, py::handle drives, py::handle senses) {
    idle_owner_of(prototype);
    auto made = std::make_shared<PyFleet>(*prototype.world, worlds, workers);
    made->drives = columns_of<Drive>(drives);
    made->senses = columns_of<Sense>(senses);
    return made;
}

py::tuple state(const PyFleet& f) {
    idle(f);
    py::list worlds;
    for (std::uint32_t k = 0; k < f.fleet->size(); ++k) worlds.append(save((*f.fleet)[k]));
    return py::make_tuple((*f.fleet)[0].capacity(), f.workers, py::cast(f.drives), py::cast(f.senses), worlds);
}

Shared from_state(const py::tuple& s) {
    const auto worlds = s[4].cast<py::list>();
    if (worlds.empty()) refuse(Error::out_of_range, "worlds");
    PyWorld first;
    first.owner = make_world(s[0].cast<Capacity>(), WorldDef{}, 1, first.world);
    Shared made = make(first, static_cast<std::uint32_t>(worlds.size()), s[1].cast<std::uint32_t>(), s[2], s[3]);
    for (std::uint32_t k = 0; k < made->fleet->size(); ++k) {
        World& world = (*made->fleet)[k];
        const Image image(worlds[k]);
        detail::begin_call(&world);
        world.load(image.bytes());
        check(detail::end_call(&world, Error::none));
    }
    return made;
}

}  // namespace

void add_fleet(py::module_& m) {
    py::class_<PyFleet, Shared> c(m, "Fleet", "Many worlds that start as copies of one world and step together.");
    zero_what_is_not_made<PyFleet>();
    c.def(py::init(&make), py::arg("world"), py::arg("worlds"), py::arg("workers") = 1u, py::arg("drives") = py::tuple(), py::arg("senses") = py::tuple(),
          "Makes `worlds` copies of a world, stepped by so many threads.");
    c.def_property(
        "drives", [](const PyFleet& f) { return py::cast(f.drives); }, [](PyFleet& f, py::handle v) { set_columns(f, f.drives, v); },
        "What each column of the actions does.");
    c.def_property(
        "senses", [](const PyFleet& f) { return py::cast(f.senses); }, [](PyFleet& f, py::handle v) { set_columns(f, f.senses, v); },
        "What the columns of the observations tell.");
    c.def_property_readonly(
        "columns", [](const PyFleet& f) { return columns(f.senses); }, "Columns of the observations.");
    c.def_property_readonly(
        "workers", [](const PyFleet& f) { return f.workers; }, "Threads that step the worlds.");
    c.def("__len__", worlds_of);
    c.def(
        "__getitem__",
        [](const Shared& f, py::ssize_t k) {
            return PyWorld{f, &(*f->fleet)[place(*f, k)]};
        },
        py::arg("k"), "World k, which can be read and changed like any other.");
    c.def("step", step_fleet, py::arg("actions") = py::none(), py::arg("dt") = 1.0f / 60, py::arg("repeat") = 1u, py::arg("mask") = py::none(),
          py::arg("out") = py::none(),
          "Applies the actions, an array of float32 of shape (worlds, drives), steps `repeat` times, and observes: an array of float32 of shape (worlds, "
          "columns). "
          "Worlds where the mask is 0 stay as they are, and so do their rows in `out`. None without senses.");
    c.def("observe", observe, py::arg("mask") = py::none(), py::arg("out") = py::none(), "Observes without a step.");
    c.def("reset", reset, py::arg("k"), py::arg("image"), py::arg("seed") = 0, py::arg("variations") = py::tuple(),
          "Takes world k back to a snapshot, and changes bodies at random: the same seed gives the same changes.");
    c.def(
        "copy",
        [](PyFleet& f, py::ssize_t from, py::ssize_t to) {
            idle(f);
            check(f.fleet->copy(place(f, from), place(f, to)));
        },
        py::arg("source"), py::arg("target"), "Makes world `target` a copy of world `source`.");
    c.def("fork", fork, py::arg("parents"),
          "Makes each world k a copy of world parents[k], at once. A parent stays as it is: parents[parents[k]] is parents[k].");
    c.def(
        "hashes",
        [](const PyFleet& f) {
            idle(f);
            py::array_t<std::uint64_t> all(size(f));
            for (std::uint32_t k = 0; k < f.fleet->size(); ++k) all.mutable_data()[k] = (*f.fleet)[k].hash();
            return all;
        },
        "The hash of each world.");
    c.def("__repr__", [](const PyFleet& f) { return "<islet.Fleet of " + std::to_string(worlds_of(f)) + " worlds>"; });
    c.def(py::pickle([](const PyFleet& f) { return state(f); }, [](const py::tuple& s) { return from_state(s); }));
}

}  // namespace islet::python
