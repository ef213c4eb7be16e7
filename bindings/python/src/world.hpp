// World as Python has it: who keeps its memory, and how each call is checked.
#pragma once

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "records.hpp"

#include "harness/world_recording.hpp"
#include "threads.hpp"

namespace islet::python {

/// Thrown where a call fails: Python gets islet.Error.
struct Refused {
    Error error;
    std::string detail;
};
[[noreturn]] inline void refuse(Error error, std::string detail = {}) { throw Refused{error, std::move(detail)}; }

/// Functions of Python, or None, that a world asks. What the first of them raises is raised again where the call ends that made the world ask.
struct PyHooks {
    py::object filter, pre_solve, mix_friction, mix_restitution;
    std::exception_ptr raised;
};

/// Keeps the memory of a world, or of all worlds of a fleet. `busy` while a thread steps them without Python's lock: other threads are refused.
struct Owner {
    virtual ~Owner() = default;
    bool busy = false;
    std::thread::id asking;  // the thread on which a world asks something of Python now
    std::unique_ptr<PyHooks> hooks;
    std::vector<std::pair<const World*, std::unique_ptr<samples::WorldRecording>>> recordings;  // of those worlds that are recorded

    auto recording_of(const World* world) {
        return std::find_if(recordings.begin(), recordings.end(), [world](const auto& of) { return of.first == world; });
    }

    void after_steps() {
        for (auto& [world, recording] : recordings) recording->after_step();
    }
};

/// Of a world by itself.
struct WorldOwner final : Owner {
    WorldOwner(std::size_t bytes, std::uint32_t workers)
        : size(bytes), block(static_cast<std::byte*>(::operator new (bytes, std::align_val_t{world_alignment}))) {
        if (workers > 1) threads = std::make_unique<Threads>(workers);
    }
    ~WorldOwner() override { ::operator delete (block, std::align_val_t{world_alignment}); }
    std::size_t size;
    std::byte* block;
    std::unique_ptr<Threads> threads;
};

struct PyWorld {
    std::shared_ptr<Owner> owner;
    World* world = nullptr;
};
using WorldClass = py::class_<PyWorld>;

/// World.__new__ alone makes none.
inline Owner& owner_of(const PyWorld& w) {
    if (!w.owner) throw py::type_error("World.__init__ was not called");
    return *w.owner;
}

/// While a world asks something of Python, the thread on which it does may call the world.
inline void refuse_if_busy(const Owner& owner) {
    if (owner.busy && owner.asking != std::this_thread::get_id()) refuse(Error::in_step, "another thread uses the world");
}

/// The owner of a world that is not in a step, nor asking a hook.
inline Owner& idle_owner_of(const PyWorld& w) {
    Owner& owner = owner_of(w);
    refuse_if_busy(owner);
    if (owner.asking != std::thread::id{}) refuse(Error::in_step);
    return owner;
}

/// A call to a world: refused while another thread steps it; its error becomes an exception.
class Call {
public:
    explicit Call(const PyWorld& of) : owner_(owner_of(of)), world_(of.world) {
        refuse_if_busy(owner_);
        is_answer_ = owner_.asking != std::thread::id{};
        if (is_answer_) outer_ = world_->last_error();
        detail::begin_call(world_);
    }
    ~Call() {
        if (!ended_) end();
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    Error error() {
        const Error error = end();
        if (!is_answer_ && owner_.hooks && owner_.hooks->raised) std::rethrow_exception(std::exchange(owner_.hooks->raised, nullptr));
        return error;
    }
    void check() {
        if (const Error e = error(); e != Error::none) refuse(e);
    }

private:
    Error end() {
        ended_ = true;
        const Error error = detail::end_call(world_, Error::none);
        if (is_answer_) {  // the call that the world is in has its own error
            world_->clear_error();
            if (outer_ != Error::none) detail::refuse_call(world_, outer_);
        }
        return error;
    }

    Owner& owner_;
    World* world_;
    Error outer_ = Error::none;
    bool is_answer_ = false, ended_ = false;
};

/// Marks, while it lives, that a world asks Python something on this thread.
class Asking {
public:
    explicit Asking(Owner& owner) : owner_(owner), before_(std::exchange(owner.asking, std::this_thread::get_id())) {}
    ~Asking() { owner_.asking = before_; }
    Asking(const Asking&) = delete;
    Asking& operator=(const Asking&) = delete;

private:
    Owner& owner_;
    std::thread::id before_;
};

/// Without Python's lock, but with the world's.
class Unlocked {
public:
    explicit Unlocked(Owner& owner) : busy_{owner} {}

private:
    struct Busy {
        explicit Busy(Owner& of) : owner(of) {
            refuse_if_busy(owner);
            before = std::exchange(owner.busy, true);  // true in a step that a hook asks for, and that the world refuses
        }
        ~Busy() { owner.busy = before; }
        Owner& owner;
        bool before = false;
    };
    Busy busy_;  // first: it begins before Python is unlocked, and ends when Python is locked again
    py::gil_scoped_release release_;
};

template <class T>
py::object give(const T& value) {
    if constexpr (std::is_pointer_v<T>) {
        if (value == nullptr) return py::none();
        return py::cast(*value);
    } else if constexpr (std::is_same_v<T, QueryHit> || std::is_same_v<T, ClosestHit>) {
        return value ? py::cast(value) : py::none();
    } else {
        return py::cast(value);
    }
}
template <class T>
py::object give(const span<T>& values) {
    py::list all(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) all[i] = py::cast(values[i]);
    return all;
}

template <class F, class R, class... A>
auto checked_call(F f) {
    return [f](PyWorld& w, A... arguments) {
        Call call(w);
        if constexpr (std::is_void_v<R>) {
            (w.world->*f)(arguments...);
            call.check();
        } else {
            decltype(auto) result = (w.world->*f)(arguments...);
            call.check();
            return give(result);
        }
    };
}
/// A function of World whose error becomes an exception.
template <class R, class... A>
auto checked(R (World::*f)(A...)) {
    return checked_call<decltype(f), R, A...>(f);
}
template <class R, class... A>
auto checked(R (World::*f)(A...) const) {
    return checked_call<decltype(f), R, A...>(f);
}

/// What a function writes to a span, all of it: f(span) tells how many there are.
template <class T, class F>
py::object all_of(const PyWorld& w, F f) {
    Call call(w);
    std::vector<T> found(f(*w.world, span<T>()));
    if (!found.empty()) f(*w.world, span<T>(found));
    call.check();
    return give(span<const T>(found));
}

/// Bytes of whatever has them in a row, aligned as an image must be.
class Image {
public:
    explicit Image(py::handle from);
    span<const std::byte> bytes() const { return bytes_; }

private:
    py::buffer_info info_;
    std::vector<std::uint64_t> copy_;
    span<const std::byte> bytes_;
};

py::bytes save(const World& world);

std::shared_ptr<Owner> make_world(const Capacity& capacity, const WorldDef& def, std::uint32_t workers, World*& world);
/// The box of all shapes that end somewhere.
Aabb view_of(const World& world);

void add_records_0(py::module_& m);
void add_records_1(py::module_& m);
void add_records_2(py::module_& m);
void add_calls_0(WorldClass& w, py::module_& m);
void add_calls_1(WorldClass& w, py::module_& m);
void add_calls_2(WorldClass& w, py::module_& m);
void add_making(WorldClass& w);       // bodies, shapes, joints
void add_finding(WorldClass& w);      // queries
void add_state(WorldClass& w);        // steps, snapshots, arrays
void add_asking(WorldClass& w);       // hooks, the mover
py::custom_type_setup collectable();  // a world and its hooks, which may know the world
void add_images(py::module_& m);      // deltas, replays
void add_fleet(py::module_& m);
void add_scenes(py::module_& m, WorldClass& w);

}  // namespace islet::python
