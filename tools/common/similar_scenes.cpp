#include "similar_scenes.hpp"

#include "scene_files/near_names.hpp"
#include "scenes/catalogue.hpp"

namespace islet::tools {

using namespace samples;

std::vector<std::string> similar_scenes(const std::string& name) {
    std::vector<std::string> known;
    for (const SceneInfo& info : catalogue()) known.emplace_back(info.name);
    return samples::near_names(name, known);
}

}  // namespace islet::tools
