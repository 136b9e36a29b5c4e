#include "bench/accuracy/suites/sources.hpp"

#include "bench/posed_trees.hpp"
#include "client/import/mesh_import.hpp"
#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/geometry/aabb.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/wide/wide_descent.hpp"
#include "tests/corpus/pairs.hpp"
#include "tests/corpus/scenes.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <random>

namespace cd::bench {

namespace {

ObbTree tree_of(const std::shared_ptr<const Mesh>& mesh) {
    ThreadPool pool(1);
    return build_tree(mesh, {}, pool);
}

constexpr double inch = 0.0254;
constexpr std::pair<Model, Model> vehicle_couples[] = {
    {{"hatchback.obj", inch}, {"toy_truck.glb"}},
    {{"sedan.obj"}, {"polaris_ranger.dae"}},
    {{"man_kat1_8x8.glb"}, {"pushback_tractor.ac"}},
    {{"lugged_wheel.obj"}, {"lugged_wheel.obj"}},
};

/// Moves B straight away from A's centre by a share of A's diagonal.
PosePair moved_off(const PosePair& poses, const Aabb& a, double share) {
    const Vec3 away = poses.b.translation() - a.center();
    const double length = away.norm();
    const Vec3 shift = length > 0 ? Vec3(share * a.diagonal() / length * away) : Vec3(Vec3::Zero());
    return {poses.a, Pose::from_quaternion(poses.b.quaternion(), poses.b.translation() + shift)};
}

} // namespace

std::shared_ptr<const Mesh> load_model(const std::filesystem::path& folder, const Model& model) {
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

PairBatch corpus_batch(const std::string& category, std::uint64_t first, std::uint64_t count) {
    std::vector<tests::PosedPair> pairs;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        pairs.push_back(tests::corpus_pair(category, seed));
    }
    return PairBatch(pairs);
}

std::vector<Scene> hard_scenes(std::size_t scenes_max) {
    const std::vector<tests::Scene>& all = tests::corpus_scenes();
    const std::size_t count = std::min(scenes_max, all.size());
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < count; ++i) {
        const tests::Scene& from = all[i * all.size() / count];
        scenes.push_back({"scenes", from.name, from.a.mesh, from.b.mesh, {from.poses}});
    }
    return scenes;
}

Scene torus_scene(std::uint64_t poses) {
    const auto torus = tests::share(tests::make_torus(1, 0.4, 96, 48));
    Scene scene{"motion", "tori in random poses", torus, torus, {}};
    std::mt19937_64 random(1);
    for (std::uint64_t i = 0; i < poses; ++i) {
        scene.poses.push_back({Pose{}, tests::make_pose(random, 3)});
    }
    return scene;
}

std::size_t vehicle_scene_count() {
    return std::size(vehicle_couples);
}

std::optional<Scene>
vehicle_scene(const std::filesystem::path& models, std::size_t couple, std::uint64_t scenarios) {
    CD_CHECK(couple < vehicle_scene_count());
    const auto& [first, second] = vehicle_couples[couple];
    const auto a = load_model(models, first);
    const auto b = load_model(models, second);
    if (!a || !b) {
        return std::nullopt;
    }
    Scene scene{"vehicles", std::string(first.file) + " x " + second.file, a, b, {}};
    if (scenarios == 0) {
        return scene;
    }
    const Aabb box = bounding_box(a->vertices());
    std::mt19937_64 draw(1);
    ThreadPool pool(1);
    for (const PosePair& poses : random_poses(tree_of(a), tree_of(b), scenarios, pool)) {
        scene.poses.push_back(poses);
        scene.poses.push_back(moved_off(poses, box, tests::uniform(draw, 0, 0.2)));
    }
    return scene;
}

SceneCandidates::SceneCandidates(const Scene& scene)
    : scene_(&scene), a_(tree_of(scene.a)), b_(tree_of(scene.b)) {
    for (const PosePair& poses : scene.poses) {
        if (a_.view().wide.nodes.empty() || b_.view().wide.nodes.empty()) {
            candidates_.push_back(candidates_of(a_, b_, poses));
            places_.emplace_back();
        } else {
            add_from_wide(poses);
        }
    }
}

void SceneCandidates::add_from_wide(const PosePair& poses) {
    const WideView& a = a_.view().wide;
    const WideView& b = b_.view().wide;
    std::vector<Candidate>& places = places_.emplace_back();
    std::vector<Candidate>& ids = candidates_.emplace_back();
    WideDescent descent(relative_pose(poses));
    for (descent.start(a, b); !descent.is_done();) {
        for (const Candidate& found : descent.next(candidates_at_once)) {
            places.push_back(found);
            ids.push_back({a.triangles.ids[found.a], b.triangles.ids[found.b]});
        }
    }
}

PairBatch SceneCandidates::batch() const {
    const TreeView& a = a_.view();
    const TreeView& b = b_.view();
    std::vector<PairGroup> groups;
    for (std::size_t s = 0; s < candidates_.size(); ++s) {
        if (places_[s].empty()) {
            groups.push_back({scene_->poses[s],
                              {a.vertices, a.triangles},
                              {b.vertices, b.triangles},
                              candidates_[s]});
        } else {
            groups.push_back({scene_->poses[s],
                              {scene_->a->vertices(), scene_->a->triangles()},
                              {scene_->b->vertices(), scene_->b->triangles()},
                              candidates_[s],
                              {a.wide.triangles, b.wide.triangles, places_[s]}});
        }
    }
    return PairBatch(std::move(groups));
}

} // namespace cd::bench
