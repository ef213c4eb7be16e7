// What the engine asks of Python while it works: hooks, and a mover's filter.
#include "world.hpp"

namespace islet::python {
namespace {

/// Calls ask_hooks(hooks) with Python's lock, on whatever thread the world is. After an exception nothing is asked until that has been raised.
template <class Ask>
void ask(Owner& owner, Ask&& ask_hooks) {
    const py::gil_scoped_acquire locked;
    if (owner.hooks->raised) return;
    try {
        ask_hooks(*owner.hooks);
    } catch (...) { owner.hooks->raised = std::current_exception(); }
}

Owner& owner_of(void* context) { return *static_cast<Owner*>(context); }

bool may_meet(ShapeId a, ShapeId b, void* context) {
    bool answer = true;
    ask(owner_of(context), [&](PyHooks& hooks) {
        const Asking asking(owner_of(context));
        answer = py::cast<bool>(hooks.filter(a, b));
    });
    return answer;
}

void before_solve(PreSolve& contact, void* context) {
    ask(owner_of(context), [&](PyHooks& hooks) {
        const Asking asking(owner_of(context));
        const py::object seen = py::cast(contact);
        hooks.pre_solve(seen);
        contact = py::cast<const PreSolve&>(seen);
    });
}

/// These come from any thread, several at once: they may not call the world.
template <py::object PyHooks::*hook>
float mixed(float a, std::uint32_t material_a, float b, std::uint32_t material_b, void* context) {
    float answer = 0;
    ask(owner_of(context), [&](PyHooks& hooks) { answer = py::cast<float>((hooks.*hook)(a, material_a, b, material_b)); });
    return answer;
}

void set_hooks(PyWorld& w, const py::object& filter, const py::object& pre_solve, const py::object& mix_friction, const py::object& mix_restitution) {
    for (const py::object& hook : {filter, pre_solve, mix_friction, mix_restitution})
        if (!hook.is_none() && PyCallable_Check(hook.ptr()) == 0) throw py::type_error("a hook is a function or None");
    if (dynamic_cast<WorldOwner*>(w.owner.get()) == nullptr) refuse(Error::feature_cut, "only a World by itself has hooks");
    Hooks hooks;
    hooks.context = w.owner.get();
    if (!filter.is_none()) hooks.filter = may_meet;
    if (!pre_solve.is_none()) hooks.pre_solve = before_solve;
    if (!mix_friction.is_none()) hooks.mix_friction = mixed<&PyHooks::mix_friction>;
    if (!mix_restitution.is_none()) hooks.mix_restitution = mixed<&PyHooks::mix_restitution>;
    Call call(w);
    // The world may ask at once.
    auto before = std::exchange(w.owner->hooks, std::make_unique<PyHooks>(PyHooks{filter, pre_solve, mix_friction, mix_restitution, nullptr}));
    w.world->set_hooks(hooks);
    const Error error = call.error();
    if (error == Error::none) return;
    w.owner->hooks = std::move(before);
    refuse(error);
}

/// A mover's filter, and what it raised.
struct MoverQuestion {
    Owner& owner;
    const py::object& collides;
    std::exception_ptr raised;

    static bool ask(const Surface& surface, void* context) {
        auto& question = *static_cast<MoverQuestion*>(context);
        if (question.raised) return true;
        const Asking asking(question.owner);
        try {
            return py::cast<bool>(question.collides(surface));
        } catch (...) {
            question.raised = std::current_exception();
            return true;
        }
    }
};

void move(PyWorld& w, MoverState& state, const MoverDef& given, float dt, const py::object& collides, const py::kwargs& named) {
    MoverInput input;
    fill_record(&input, record_of<MoverInput>(), py::tuple(), named);
    MoverDef def = given;
    MoverQuestion question{*w.owner, collides, nullptr};
    if (!collides.is_none()) {
        if (PyCallable_Check(collides.ptr()) == 0) throw py::type_error("collides is a function or None");
        def.collides = MoverQuestion::ask;
        def.context = &question;
    }
    Call call(w);
    step_mover(*w.world, def, state, input, dt);
    call.check();
    if (question.raised) std::rethrow_exception(question.raised);
}

/// The hooks of a world that has one object in Python, as a world by itself has; or null.
PyHooks* hooks_of(PyObject* self) {
    const auto* const world = static_cast<const PyWorld*>(reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().value_ptr());
    return world != nullptr && world->owner.use_count() == 1 ? world->owner->hooks.get() : nullptr;
}

int traverse(PyObject* self, visitproc visit, void* arg) {
    Py_VISIT(Py_TYPE(self));
    if (const PyHooks* const hooks = hooks_of(self)) {
        Py_VISIT(hooks->filter.ptr());
        Py_VISIT(hooks->pre_solve.ptr());
        Py_VISIT(hooks->mix_friction.ptr());
        Py_VISIT(hooks->mix_restitution.ptr());
    }
    return 0;
}

int clear(PyObject* self) {
    if (PyHooks* const hooks = hooks_of(self)) {
        auto* const world = static_cast<const PyWorld*>(reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().value_ptr());
        world->world->set_hooks({});
        *hooks = {};
    }
    return 0;
}

}  // namespace

py::custom_type_setup collectable() {
    return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
        heap_type->ht_type.tp_flags |= Py_TPFLAGS_HAVE_GC;
        heap_type->ht_type.tp_traverse = traverse;
        heap_type->ht_type.tp_clear = clear;
        heap_type->ht_type.tp_dealloc = [](PyObject* self) {
            PyObject_GC_UnTrack(self);
            py::detail::pybind11_object_dealloc(self);
        };
    });
}

void add_asking(WorldClass& w) {
    w.def("set_hooks", set_hooks, py::kw_only(), py::arg("filter") = py::none(), py::arg("pre_solve") = py::none(), py::arg("mix_friction") = py::none(),
          py::arg("mix_restitution") = py::none(),
          "Functions that steps call, to let you decide something; those not given are taken away. They may read the world. What one raises is raised again "
          "after the step.");
    w.def("step_mover", move, py::arg("state").noconvert(), py::arg("mover") = MoverDef{}, py::arg("dt") = 1.0f / 60, py::arg("collides") = py::none(),
          "Moves a character mover by dt seconds, once after each step of the world. Changes its MoverState.");
}

}  // namespace islet::python
