#include "tests/corpus/categories.hpp"

namespace cd::tests {

std::vector<std::string> scene_categories() {
    std::vector<std::string> categories;
    for (const Scene& scene : corpus_scenes()) {
        if (categories.empty() || categories.back() != scene.category) {
            categories.push_back(scene.category);
        }
    }
    return categories;
}

std::vector<const Scene*> scenes_of(const std::string& category) {
    std::vector<const Scene*> scenes;
    for (const Scene& scene : corpus_scenes()) {
        if (scene.category == category) {
            scenes.push_back(&scene);
        }
    }
    return scenes;
}

} // namespace cd::tests
