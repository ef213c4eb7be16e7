#include "registry.hpp"

#ifdef ISLET_BOX2D
#include "box2d_engine.hpp"
#endif
#ifdef ISLET_BOX2D3
#include "box2d3/box2d3_engine.hpp"
#endif
#ifdef ISLET_CHIPMUNK
#include "chipmunk_engine.hpp"
#endif

namespace islet::engines {
namespace {

using samples::Engine;
using samples::Scene;

std::string lacks_nothing(const Scene&) { return {}; }
std::unique_ptr<Engine> make_islet() { return std::make_unique<samples::IsletEngine>(); }

#ifdef ISLET_BOX2D
// With the skin outside, as its users make shapes, and without continuous collision, which is to its advantage (README.md).
std::unique_ptr<Engine> make_box2d() { return std::make_unique<Box2dEngine>(Box2dOptions{.skin = Skin::outside, .continuous = false, .nearest = true}); }
std::unique_ptr<Engine> make_exact_box2d() { return std::make_unique<Box2dEngine>(Box2dOptions{.nearest = true}); }
#endif

#ifdef ISLET_BOX2D3
std::unique_ptr<Engine> make_box2d3() { return std::make_unique<Box2d3Engine>(); }
#endif

#ifdef ISLET_CHIPMUNK
std::unique_ptr<Engine> make_chipmunk() { return std::make_unique<ChipmunkEngine>(); }
#endif

}  // namespace

const std::vector<EngineInfo>& registry() {
    static const std::vector<EngineInfo> list = {
        {"islet", lacks_nothing, make_islet, make_islet, true},
#ifdef ISLET_BOX2D
        {"box2d", box2d_lacks_even_nearest, make_box2d, make_exact_box2d},
#endif
#ifdef ISLET_BOX2D3
        {"box2d3", box2d3_lacks, make_box2d3, make_box2d3, true},
#endif
#ifdef ISLET_CHIPMUNK
        {"chipmunk", chipmunk_lacks, make_chipmunk, make_chipmunk},
#endif
    };
    return list;
}

const EngineInfo* find_engine(const std::string& name) {
    for (const EngineInfo& info : registry()) {
        if (name == info.name) return &info;
    }
    return nullptr;
}

}  // namespace islet::engines
