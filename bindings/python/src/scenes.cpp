// Scenes of the catalogue, with their scripts.
#include "harness/engine.hpp"
#include "islet/svg.hpp"
#include "scenes/catalogue.hpp"
#include "world.hpp"

namespace islet::python {
namespace {

struct PyScene final : Owner {
    explicit PyScene(samples::Scene made) : scene(std::move(made)) { engine.load(scene); }
    samples::Scene scene;
    samples::IsletEngine engine;
    int steps = 0;
};

std::shared_ptr<PyScene> open(const std::string& name) {
    const samples::SceneInfo* const info = samples::find_scene(name);
    if (info == nullptr) throw py::key_error("there is no scene " + name + "; islet.scenes() lists them");
    return std::make_shared<PyScene>(info->make());
}

PyWorld world_of(const std::shared_ptr<PyScene>& scene) { return {scene, &scene->engine.world()}; }

void step_scene(const std::shared_ptr<PyScene>& s, int count) {
    for (int i = 0; i < count; ++i) {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        refuse_if_busy(*s);
        const Unlocked unlocked(*s);
        s->engine.advance(s->scene, s->steps++, s->scene.dt);
    }
}

std::string svg(const std::shared_ptr<PyScene>& s) {
    const PyWorld w = world_of(s);
    const Call call(w);
    tools::Picture picture;
    picture.view = s->scene.view;
    picture.title = s->scene.name;
    picture.dt = s->scene.dt;
    return tools::draw_svg(*w.world, picture);
}

}  // namespace

void add_scenes(py::module_& m, WorldClass&) {
    m.def(
        "scenes",
        [] {
            py::dict all;
            for (const samples::SceneInfo& info : samples::catalogue()) all[info.name] = info.description;
            return all;
        },
        "The scenes of the catalogue: a line about each by its name.");
    py::class_<PyScene, std::shared_ptr<PyScene>> c(m, "Scene", "A scene of the catalogue with its script. step() runs both; world.step() only the world.");
    zero_what_is_not_made<PyScene>();
    c.def(py::init(&open), py::arg("name"));
    c.def("step", step_scene, py::arg("count") = 1, "Takes steps of `dt`, with what the script does before and after each.");
    c.def_property_readonly("world", world_of, "Its world.");
    c.def_property_readonly("name", [](const PyScene& s) { return s.scene.name; });
    c.def_property_readonly(
        "dt", [](const PyScene& s) { return s.scene.dt; }, "s");
    c.def_property_readonly(
        "steps", [](const PyScene& s) { return s.scene.steps; }, "How long it runs in the manual and in tests.");
    c.def_property_readonly(
        "view", [](const PyScene& s) { return s.scene.view; }, "m, what a picture shows.");
    c.def("svg", svg, "A picture: an SVG document.");
    c.def("_repr_svg_", svg);
    c.def("__repr__", [](const PyScene& s) { return "<islet.Scene " + s.scene.name + ", " + std::to_string(s.steps) + " steps>"; });
}

}  // namespace islet::python
