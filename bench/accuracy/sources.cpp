#include "bench/accuracy/sources.hpp"

#include "client/mesh_import.hpp"
#include "common/core/thread_pool.hpp"
#include "common/job/pose_source.hpp"
#include "common/tree/build.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/shapes.hpp"

#include <cstdio>
#include <random>

namespace cd::bench {

namespace {

ObbTree tree_of(const std::shared_ptr<const Mesh>& mesh) {
    ThreadPool pool(1);
    return build_tree(mesh, {}, pool);
}

struct Model {
    const char* file;
    double unit = 1;
};

/// Null, and said, where the model is not there.
std::shared_ptr<const Mesh> load(const std::filesystem::path& folder, const Model& model) {
    const std::filesystem::path path = folder / model.file;
    if (!std::filesystem::exists(path)) {
        std::fprintf(stderr, "MISSING: %s; its scenes are left out\n", path.c_str());
        return nullptr;
    }
    ImportOptions options;
    options.unit_factor = model.unit;
    auto imported = import_mesh(path, options);
    if (!imported.has_value()) {
        std::fprintf(stderr, "MISSING: %s\n", imported.error().detail.c_str());
        return nullptr;
    }
    return imported.value().mesh;
}

} // namespace

std::vector<std::string> corpus_categories() {
    std::vector<std::string> names;
    for (const auto& [name, make] : tests::pair_makers()) {
        names.push_back(name);
    }
    return names;
}

PairBatch corpus_batch(const std::string& category, std::uint64_t first, std::uint64_t count) {
    const tests::PairMaker make = tests::pair_makers().at(category);
    std::vector<tests::PosedPair> pairs;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        std::mt19937_64 random(seed);
        pairs.push_back(make(random));
    }
    return PairBatch(pairs);
}

std::vector<Scene> tie_scenes() {
    using tests::share;
    using tests::translation_pose;
    std::vector<Scene> scenes;
    const auto box = share(tests::make_gridded_box({1, 1, 1}, 12));
    scenes.push_back({"scenes",
                      "stacked boxes",
                      box,
                      box,
                      {{Pose{}, translation_pose(0, 0, 1)},
                       {Pose{}, translation_pose(0.5, 0.25, 1)},
                       {translation_pose(0.1, 0.2, 0.3), translation_pose(0.1, 0.2, 1.3)}}});
    const auto torus = share(tests::make_torus(1, 0.4, 48, 24));
    std::mt19937_64 random(1);
    Scene tori{"scenes", "tori", torus, torus, {}};
    for (int i = 0; i < 20; ++i) {
        tori.poses.push_back({Pose{}, tests::make_pose(random, 1.5)});
    }
    scenes.push_back(tori);
    const auto sphere = share(tests::make_sphere(4));
    scenes.push_back({"scenes",
                      "sphere on itself, and tangent",
                      sphere,
                      sphere,
                      {{Pose{}, Pose{}}, {Pose{}, translation_pose(2, 0, 0)}}});
    return scenes;
}

std::vector<Scene> vehicle_scenes(const std::filesystem::path& models, std::uint64_t scenarios) {
    constexpr double inch = 0.0254;
    const std::vector<std::pair<Model, Model>> couples{
        {{"hatchback.obj", inch}, {"toy_truck.glb"}},
        {{"sedan.obj"}, {"polaris_ranger.dae"}},
        {{"man_kat1_8x8.glb"}, {"pushback_tractor.ac"}},
        {{"lugged_wheel.obj"}, {"lugged_wheel.obj"}},
    };
    std::vector<Scene> scenes;
    for (const auto& [first, second] : couples) {
        const auto a = load(models, first);
        const auto b = load(models, second);
        if (!a || !b) {
            continue;
        }
        Scene scene{"vehicles", std::string(first.file) + " x " + second.file, a, b, {}};
        RandomPoses random;
        random.count = scenarios;
        ThreadPool pool(1);
        for (const Scenario& s : make_random_poses(random, tree_of(a), tree_of(b), pool)) {
            scene.poses.push_back(s.poses);
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

SceneCandidates::SceneCandidates(const Scene& scene)
    : scene_(&scene), a_(tree_of(scene.a)), b_(tree_of(scene.b)) {
    for (const PosePair& poses : scene.poses) {
        candidates_.push_back(candidates_of(a_, b_, poses));
    }
}

PairBatch SceneCandidates::batch() const {
    std::vector<PairGroup> groups;
    for (std::size_t s = 0; s < candidates_.size(); ++s) {
        groups.push_back({scene_->poses[s],
                          {a_.view().vertices, a_.view().triangles},
                          {b_.view().vertices, b_.view().triangles},
                          candidates_[s]});
    }
    return PairBatch(std::move(groups));
}

} // namespace cd::bench
