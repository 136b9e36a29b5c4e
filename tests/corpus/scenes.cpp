#include "tests/corpus/scenes.hpp"

#include "common/core/check.hpp"
#include "tests/corpus/scene_list.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>
#include <utility>

namespace cd::tests {

Body solid(Mesh mesh) {
    return {share(std::move(mesh)), true};
}

Body surface(Mesh mesh) {
    return {share(std::move(mesh)), false};
}

const std::vector<Scene>& corpus_scenes() {
    static const Scenes scenes = [] {
        Scenes all;
        add_box_scenes(all);
        add_round_scenes(all);
        add_building_scenes(all);
        add_odd_scenes(all);
        return all;
    }();
    return scenes;
}

const Scene& corpus_scene(std::string_view name) {
    const auto& scenes = corpus_scenes();
    const auto found = std::find_if(
        scenes.begin(), scenes.end(), [&](const Scene& scene) { return scene.name == name; });
    CD_CHECK(found != scenes.end());
    return *found;
}

} // namespace cd::tests
