// Several worlds that are to stay equal bit by bit: every call goes to each of them, and after it, and after every step, they are compared. They differ
// in what must not matter: lanes, workers, capacity.
//
// A chorus can write its calls down as data (Deed), to make them again without some of them, and to print them as C++.
#pragma once

#include <array>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "cpp_text.hpp"
#include "hook_menu.hpp"
#include "islet/islet.hpp"
#include "state/image.hpp"

namespace islet::test {

/// What a program does that found a fault. Each program has its own.
[[noreturn]] void broken(const char* what);

class Chorus;

/// A call that was made.
struct Deed {
    virtual ~Deed() = default;
    virtual void run(Chorus& all) const = 0;
    virtual std::string text() const = 0;
    /// The same call with its `k`-th number made simpler by way `how`; null if that is none.
    virtual std::shared_ptr<const Deed> simpler(std::uint32_t, std::uint32_t) const { return nullptr; }
    virtual std::uint32_t numbers() const { return 0; }
    virtual bool is_step() const { return false; }
};
using Deeds = std::vector<std::shared_ptr<const Deed>>;

/// What the ids of calls that are made again are now: other ones, if calls before them are left out.
class NewIds {
public:
    void operator()(BodyId& id) const { look_up(0, id); }
    void operator()(ShapeId& id) const { look_up(1, id); }
    void operator()(JointId& id) const { look_up(2, id); }
    template <class T>
    void operator()(T& a) const {
        if constexpr (requires { detail::members(*this, a); }) detail::members(*this, a);
    }
    template <class A, class B, class... Rest>
    void operator()(A& a, B& b, Rest&... rest) const {
        (*this)(a);
        (*this)(b);
        ((*this)(rest), ...);
    }
    void learn(BodyId was, BodyId is) { now_[0][{was.index1, was.generation}] = {is.index1, is.generation}; }
    void learn(ShapeId was, ShapeId is) { now_[1][{was.index1, was.generation}] = {is.index1, is.generation}; }
    void learn(JointId was, JointId is) { now_[2][{was.index1, was.generation}] = {is.index1, is.generation}; }
    template <class T>
    void learn(T, T) {}

private:
    template <class Id>
    void look_up(int kind, Id& id) const {
        const auto found = now_[kind].find({id.index1, id.generation});
        if (found != now_[kind].end()) id = {found->second.first, found->second.second};
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, std::uint32_t>> now_[3];
};

class Chorus {
public:
    static constexpr std::uint32_t most = 4;
    struct Voice {
        World* world = nullptr;
        const char* name = "";
        bool sings = true;        ///< false: makes the calls, but is not compared: it was in need of room, and others were not
        bool other_room = false;  ///< its capacity is another
    };

    void add(World* world, const char* name, bool other_room = false) { voices_[count_++] = {world, name, true, other_room}; }
    void clear() {
        count_ = 0;
        ids = {};
        log = nullptr;
        recording_ = false;
        earlier_bytes_ = 0;
        told = 0;
        steps = 0;
    }
    World& first() const { return *voices_[0].world; }
    std::uint32_t size() const { return count_; }
    Voice& voice(std::uint32_t i) { return voices_[i]; }

    Deeds* log = nullptr;  ///< where calls are written down
    NewIds ids;
    std::uint32_t told = 0;          ///< calls made
    std::uint32_t* told_to = nullptr;  ///< and counted here too, before each
    std::uint32_t last_call = ~0u;   ///< the run ends before this call is made
    std::uint64_t steps = 0;
    World* replayer = nullptr;       ///< for recordings
    bool checks = true;              ///< world for world; false: the caller does

    // -- calls -------------------------------------------------------------------------------------------------------------------

    template <class F, class... A>
    auto tell(const char* name, F f, const A&... a);

#define ISLET_ALL(name) \
    template <class... A> \
    auto name(const A&... a) { \
        return tell(#name, [](World& w, const auto&... x) { return w.name(x...); }, a...); \
    }
    ISLET_ALL(set_gravity)
    ISLET_ALL(set_solver)
    ISLET_ALL(enable_sleep)
    ISLET_ALL(enable_continuous)
    ISLET_ALL(enable_seamless_floors)
    ISLET_ALL(set_hit_threshold)
    ISLET_ALL(set_restitution_threshold)
    ISLET_ALL(set_max_speed)
    ISLET_ALL(explode)
    ISLET_ALL(create_body)
    ISLET_ALL(destroy_body)
    ISLET_ALL(set_transform)
    ISLET_ALL(set_linear_velocity)
    ISLET_ALL(set_angular_velocity)
    ISLET_ALL(set_target)
    ISLET_ALL(apply_force)
    ISLET_ALL(apply_force_to_center)
    ISLET_ALL(apply_torque)
    ISLET_ALL(apply_linear_impulse)
    ISLET_ALL(apply_linear_impulse_to_center)
    ISLET_ALL(apply_angular_impulse)
    ISLET_ALL(set_type)
    ISLET_ALL(set_mass)
    ISLET_ALL(reset_mass)
    ISLET_ALL(set_linear_damping)
    ISLET_ALL(set_angular_damping)
    ISLET_ALL(set_gravity_scale)
    ISLET_ALL(set_fixed_rotation)
    ISLET_ALL(lock_x)
    ISLET_ALL(lock_y)
    ISLET_ALL(set_enabled)
    ISLET_ALL(set_bullet)
    ISLET_ALL(set_sleep_threshold)
    ISLET_ALL(wake)
    ISLET_ALL(sleep)
    ISLET_ALL(set_user_data)
    ISLET_ALL(create_shape)
    ISLET_ALL(destroy_shape)
    ISLET_ALL(set_circle)
    ISLET_ALL(set_capsule)
    ISLET_ALL(set_segment)
    ISLET_ALL(set_polygon)
    ISLET_ALL(set_half_space)
    ISLET_ALL(set_chain_segment)
    ISLET_ALL(set_sensor)
    ISLET_ALL(set_density)
    ISLET_ALL(set_friction)
    ISLET_ALL(set_restitution)
    ISLET_ALL(set_rolling_resistance)
    ISLET_ALL(set_tangent_speed)
    ISLET_ALL(set_material)
    ISLET_ALL(enable_sensor_events)
    ISLET_ALL(enable_hit_events)
    ISLET_ALL(enable_pre_solve)
    ISLET_ALL(set_one_way)
    ISLET_ALL(apply_wind)
    ISLET_ALL(set_filter)
    ISLET_ALL(create_joint)
    ISLET_ALL(destroy_joint)
    ISLET_ALL(set_frames)
    ISLET_ALL(set_collide_connected)
    ISLET_ALL(set_break)
    ISLET_ALL(set_spring)
    ISLET_ALL(set_limit)
    ISLET_ALL(set_motor)
    ISLET_ALL(set_joint_friction)
    ISLET_ALL(set_ratchet)
    ISLET_ALL(set_joint_length)
    ISLET_ALL(set_joint_velocity)
    ISLET_ALL(set_joint_strength)
    ISLET_ALL(set_softness)
    ISLET_ALL(set_grounds)
    ISLET_ALL(set_joint_ratio)
#undef ISLET_ALL
    std::uint32_t create_chain(BodyId body, std::span<const Vec2> points, bool loop, const ShapeDef& def = {}, std::span<ShapeId> out = {});
    /// Those of hook_menu.hpp.
    void set_hooks(std::uint32_t number);
    /// The first world is recorded from here on, and another repeats what it did.
    void begin_recording();
    void end_recording();
    /// The world of other capacity becomes what the first one is now: by load, restore, or a delta to the image taken before.
    void travel(std::uint32_t way);
    /// A step, after which all that is promised of worlds is checked.
    void step(float dt);

    // -- comparing ---------------------------------------------------------------------------------------------------------------

    /// Breaks if the worlds' states differ; `events` too.
    void compare(bool events);
    /// Breaks if the first world is not sound, or a body is nowhere.
    void check();
    void log_deed(std::shared_ptr<const Deed> deed) {
        if (told_to != nullptr) *told_to = told;
        if (log != nullptr) log->push_back(std::move(deed));
        if (told++ == last_call) broken("it ends here");
    }

private:
    template <class F, class R, class... A>
    struct Told;
    static bool needs_room(Error e) {
        return e == Error::bodies_full || e == Error::shapes_full || e == Error::contacts_full || e == Error::geometries_full || e == Error::joints_full ||
               e == Error::events_full || e == Error::hits_full;
    }

    Voice voices_[most];
    std::uint32_t count_ = 0;
    bool recording_ = false;
    std::vector<std::uint64_t> image_, earlier_, packed_, unpacked_, record_;
    std::size_t earlier_bytes_ = 0;
};

/// What is no call of World.
struct Doing final : Deed {
    void (*what)(Chorus&, std::uint32_t);
    std::uint32_t way;
    const char* words;
    Doing(void (*w)(Chorus&, std::uint32_t), std::uint32_t by, const char* t) : what(w), way(by), words(t) {}
    void run(Chorus& all) const override { what(all, way); }
    std::string text() const override { return words; }
};

// -- calls as data ----------------------------------------------------------------------------------------------------------------------

template <class F, class R, class... A>
struct Chorus::Told final : Deed {
    const char* name;
    F f;
    std::tuple<A...> arguments;
    R result{};

    Told(const char* n, F function, const A&... a) : name(n), f(function), arguments(a...) {}
    void run(Chorus& all) const override {
        std::tuple<A...> now = arguments;
        std::apply([&](auto&... a) { (all.ids(a), ...); }, now);
        if constexpr (std::is_same_v<std::tuple<A...>, std::tuple<float>>) {
            if (is_step()) return all.step(std::get<0>(now));  // which compares
        }
        if constexpr (std::is_same_v<R, char>) std::apply([&](const auto&... a) { all.tell(name, f, a...); }, now);
        else all.ids.learn(result, std::apply([&](const auto&... a) { return all.tell(name, f, a...); }, now));
    }
    std::string text() const override {
        std::string line = std::string("w->") + name + "(";
        std::apply([&](const auto&... a) { ((line += cpp_text(a), line += ", "), ...); }, arguments);
        line.resize(line.size() - 2);
        if (std::strcmp(name, "set_hooks") == 0) return "w->set_hooks(hooks_of(" + line.substr(line.find('(') + 1) + "));";
        return line + ");" + made(result);
    }
    std::uint32_t numbers() const override {
        Numbers n;
        auto copy = arguments;
        std::apply([&](auto&... a) { (n(a), ...); }, copy);
        return n.count;
    }
    std::shared_ptr<const Deed> simpler(std::uint32_t k, std::uint32_t how) const override {
        auto other = std::make_shared<Told>(*this);
        Numbers n, usual;
        usual.wanted = k;
        usual.reads = true;
        std::tuple<A...> plain{};
        std::apply([&](auto&... a) { (usual(a), ...); }, plain);
        n.plain = usual.plain;
        n.wanted = k;
        n.how = how;
        std::apply([&](auto&... a) { (n(a), ...); }, other->arguments);
        return n.changed ? other : nullptr;
    }
    bool is_step() const override { return std::strcmp(name, "step") == 0; }

private:
    static std::string made(BodyId id) { return id ? "  // " + cpp_text(id) : ""; }
    static std::string made(ShapeId id) { return id ? "  // " + cpp_text(id) : ""; }
    static std::string made(JointId id) { return id ? "  // " + cpp_text(id) : ""; }
    template <class T>
    static std::string made(T) { return ""; }
};

template <class F, class... A>
auto Chorus::tell(const char* name, F f, const A&... a) {
    using R = decltype(f(first(), a...));
    using Kept = std::conditional_t<std::is_void_v<R>, char, R>;
    std::shared_ptr<Told<F, Kept, A...>> deed;
    if (log != nullptr) deed = std::make_shared<Told<F, Kept, A...>>(name, f, a...);
    log_deed(deed);
    for (std::uint32_t i = 0; i < count_; ++i) voices_[i].world->clear_error();
    const auto after = [&] {
        const Error error = first().last_error();
        for (std::uint32_t i = 1; i < count_; ++i) {
            Voice& v = voices_[i];
            if (v.other_room && v.sings && (needs_room(error) || needs_room(v.world->last_error()))) v.sings = false;
            if (v.sings && v.world->last_error() != error && error != Error::recording_full) broken("a call has another error in another world");
        }
    };
    if constexpr (std::is_void_v<R>) {
        for (std::uint32_t i = 0; i < count_; ++i) f(*voices_[i].world, a...);
        after();
    } else {
        const R result = f(first(), a...);
        R others[most];
        for (std::uint32_t i = 1; i < count_; ++i) others[i] = f(*voices_[i].world, a...);
        after();
        for (std::uint32_t i = 1; i < count_; ++i)
            if (voices_[i].sings && !(others[i] == result)) broken("a call returns something else in another world");
        if (deed != nullptr) deed->result = result;
        return result;
    }
}

inline std::uint32_t Chorus::create_chain(BodyId body, std::span<const Vec2> points, bool loop, const ShapeDef& def, std::span<ShapeId> out) {
    const auto make = [](World& w, BodyId b, const PointList& list, bool closed, const ShapeDef& d) { return w.create_chain(b, list.span(), closed, d); };
    const std::uint32_t n = tell("create_chain", make, body, PointList(points), loop, def);
    ShapeId made[64];  // newest first
    const std::uint32_t count = n > 0 ? first().shapes(body, made) : 0;
    for (std::uint32_t i = 0; i < n && i < out.size() && n <= count && n <= 64; ++i) out[i] = made[n - 1 - i];
    return n;
}

inline void Chorus::set_hooks(std::uint32_t number) {
    const bool again = recording_;
    if (recording_) end_recording();  // which does not hold them
    tell("set_hooks", [](World& w, const std::uint32_t& n) { w.set_hooks(hooks_of(n)); }, number);
    if (again) begin_recording();
}

inline void Chorus::step(float dt) {
    ++steps;
    tell("step", [](World& w, const float& h) { w.step(h); }, dt);
    const bool short_of_room = first().report().dropped_contacts + first().report().dropped_events + first().report().dropped_hits != 0;
    for (std::uint32_t i = 1; i < count_ && short_of_room; ++i)
        if (voices_[i].other_room) voices_[i].sings = false;
    if (!checks) return;
    // A step that is refused leaves what the last one told, which is not known to worlds that were loaded since.
    compare(first().last_error() != Error::bad_time_step);
    check();
}

namespace chorus_detail {

inline std::span<std::byte> room(std::vector<std::uint64_t>& words, std::size_t bytes) {
    if (words.size() < bytes / 8 + 1) words.resize(bytes / 8 + 1);
    return {reinterpret_cast<std::byte*>(words.data()), bytes};
}

template <class T>
bool same(std::span<const T> a, std::span<const T> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// The arrays of an image by name, but for the events that wait behind them.
inline constexpr auto part_names = [] {
    std::array<const char*, detail::part_count - 2> names{};
    std::size_t n = 0;
#define ISLET_NAME(name, size, per, kept, ...) \
    if (detail::Kept::kept == detail::Kept::saved) names[n++] = #name;
    ISLET_ARRAYS(ISLET_NAME)
#undef ISLET_NAME
    return names;
}();

/// These have padding.
inline bool same(std::span<const JointBreakEvent> a, std::span<const JointBreakEvent> b) {
    bool equal = a.size() == b.size();
    for (std::size_t i = 0; equal && i < a.size(); ++i)
        equal = a[i].joint == b[i].joint && a[i].body_a == b[i].body_a && a[i].body_b == b[i].body_b && a[i].user_data == b[i].user_data &&
                std::memcmp(&a[i].force, &b[i].force, sizeof(Vec2)) == 0 && std::memcmp(&a[i].torque, &b[i].torque, sizeof(float)) == 0;
    return equal;
}

/// But for their places in the buckets, which depend on the capacity, and are other ones after loading.
inline bool same_geometries(const detail::Core& x, const detail::Core& y) {
    for (std::uint32_t i = 0; i < x.state->geometry_pool.high_water; ++i) {
        detail::Geometry a = x.geometries[i], b = y.geometries[i];
        if (a.references != 0) a.next = b.next = 0;
        if (std::memcmp(static_cast<const void*>(&a), &b, sizeof a) != 0) return false;
    }
    return true;
}

/// Null, or what differs.
inline const char* difference(const World& a, const World& b) {
    using namespace detail;
    const Core& x = Core::of(a);
    const Core& y = Core::of(b);
    ImageHeader h = header_of(x), other = header_of(y);
    other.set_capacity(h.capacity());
    if (std::memcmp(&h, &other, sizeof h) != 0) return "one world holds more than another";
    const void* parts[part_count];
    std::uint32_t n = 0, i = 0;
    const char* different = nullptr;
    for_each_part(x, h, [&](const auto* from, std::uint64_t) { parts[n++] = from; });
    for_each_part(y, h, [&](const auto* from, std::uint64_t bytes) {
        if (i < std::size(part_names) && different == nullptr && std::memcmp(parts[i], from, static_cast<std::size_t>(bytes)) != 0) different = part_names[i];
        if (different != nullptr && std::string_view(different) == "geometries" && same_geometries(x, y)) different = nullptr;
        ++i;
    });
    return different;
}

}  // namespace chorus_detail

inline void Chorus::begin_recording() {
    if (log != nullptr || told_to != nullptr || last_call != ~0u) log_deed(std::make_shared<Doing>([](Chorus& c, std::uint32_t) { c.begin_recording(); }, 0, "begin_recording();"));
    if (recording_ || replayer == nullptr) return;
    recording_ = first().start_recording(chorus_detail::room(record_, 1 << 20));
}

inline void Chorus::end_recording() {
    if (log != nullptr || told_to != nullptr || last_call != ~0u) log_deed(std::make_shared<Doing>([](Chorus& c, std::uint32_t) { c.end_recording(); }, 0, "end_recording();"));
    if (!recording_) return;
    recording_ = false;
    const std::span<std::byte> all = chorus_detail::room(record_, 1 << 20);
    const std::size_t n = first().is_recording() ? first().stop_recording() : all.size();
    if (n == 0) broken("a recording does not end");
    replayer->set_hooks(first().hooks());
    const ReplayResult result = replay(*replayer, all.first(n));
    if (result.end == ReplayEnd::differs) broken("a replay differs");
    if (result.end != ReplayEnd::complete) broken("a replay is refused");
    if (n != all.size() && chorus_detail::difference(first(), *replayer) != nullptr) broken("a replay ends elsewhere");
    if (n != all.size() && first().hash() != replayer->hash()) broken("a replay ends with another hash");
}

inline void Chorus::travel(std::uint32_t way) {
    static constexpr void (*again)(Chorus&, std::uint32_t) = [](Chorus& c, std::uint32_t w) { c.travel(w); };
    log_deed(log != nullptr ? std::make_shared<Doing>(again, way, way % 3 == 0 ? "travel(0);" : way % 3 == 1 ? "travel(1);" : "travel(2);") : nullptr);
    const std::size_t n = first().snapshot_bytes();
    const std::span<std::byte> image = chorus_detail::room(image_, n);
    if (first().save(image) != n) broken("a world does not fit the image that it asks for");
    std::span<const std::byte> from = image;
    if (way % 3 == 2 && earlier_bytes_ != 0) {
        const std::span<const std::byte> earlier = chorus_detail::room(earlier_, earlier_bytes_);
        const std::span<std::byte> packed = chorus_detail::room(packed_, max_delta_bytes(n));
        const std::span<std::byte> unpacked = chorus_detail::room(unpacked_, n);
        const std::size_t bytes = delta(earlier, image, packed);
        if (bytes == 0 || apply(earlier, packed.first(bytes), unpacked) != n) broken("a delta cannot be applied");
        if (std::memcmp(unpacked.data(), image.data(), n) != 0) broken("a delta leads to another image");
        from = unpacked;
    }
    for (std::uint32_t i = 1; i < count_; ++i) {
        Voice& v = voices_[i];
        if (!v.other_room) continue;
        if (!(way % 3 == 1 ? v.world->restore(from) : v.world->load(from))) broken(describe(v.world->last_error()));
        v.sings = true;
        if (v.world->hash() != first().hash()) broken("a loaded world has another hash");
    }
    compare(false);
    std::swap(image_, earlier_);
    earlier_bytes_ = n;
}

inline void Chorus::compare(bool events) {
    using chorus_detail::same;
    const World& a = first();
    for (std::uint32_t i = 1; i < count_; ++i) {
        const Voice& v = voices_[i];
        if (!v.sings) continue;
        const World& b = *v.world;
        if (const char* part = chorus_detail::difference(a, b)) {
            static char what[128];
            std::snprintf(what, sizeof what, "worlds differ: %s, %s", v.name, part);
            broken(what);
        }
        if (!events) continue;
        if (!same(a.begin_touch_events(), b.begin_touch_events()) || !same(a.end_touch_events(), b.end_touch_events())) broken("touch events differ");
        if (!same(a.sensor_begin_events(), b.sensor_begin_events()) || !same(a.sensor_end_events(), b.sensor_end_events())) broken("sensor events differ");
        if (!same(a.hit_events(), b.hit_events()) || !same(a.broken_joints(), b.broken_joints())) broken("hits or broken joints differ");
        if (!same(a.moved_bodies(), b.moved_bodies()) || !same(a.slept_bodies(), b.slept_bodies())) broken("moved or slept bodies differ");
        if (std::memcmp(&a.report(), &b.report(), sizeof(StepReport)) != 0) broken("reports differ");
    }
}

inline void Chorus::check() {
    const World& w = first();
    if (const char* fault = w.validate()) broken(fault);
    const std::uint32_t slots = w.capacity().bodies;
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
        const BodyId b = w.body_at(slot);
        if (!b) continue;
        const Transform pose = w.transform(b);
        const bool finite = is_finite(pose.p) && is_finite(pose.q.c) && is_finite(pose.q.s) && is_finite(w.linear_velocity(b)) &&
                            is_finite(w.angular_velocity(b)) && is_finite(w.center_of_mass(b));
        if (!finite) broken("a body is at no place, or moves at no speed");
        if (abs(pose.q.c * pose.q.c + pose.q.s * pose.q.s - 1) > 1e-3f) broken("a rotation is none");
    }
}

}  // namespace islet::test
