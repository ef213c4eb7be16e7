#include "registry.hpp"

#ifdef ISLET_BOX2D
#include "box2d_engine.hpp"
#endif

namespace islet::engines {

const std::vector<EngineInfo>& registry() {
    static const std::vector<EngineInfo> list = {
        {"islet", [](const samples::Scene&) { return std::string(); },
         []() -> std::unique_ptr<samples::Engine> { return std::make_unique<samples::IsletEngine>(); }},
#ifdef ISLET_BOX2D
        {"box2d", box2d_lacks_even_nearest,
         []() -> std::unique_ptr<samples::Engine> {
             return std::make_unique<Box2dEngine>(Box2dOptions{.skin = Skin::outside, .continuous = false, .nearest = true});
         }},
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
