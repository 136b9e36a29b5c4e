#include "bench/peers/motions/motion_scenes.hpp"

#include "tests/support/shapes.hpp"

#include <cstddef>
#include <random>
#include <stdexcept>
#include <utility>

namespace cd::bench {

namespace {

constexpr double path_length = 3; // Of vehicles, metres.

KeyedPath checked(const Result<KeyedPath>& path) {
    if (!path) {
        throw std::runtime_error("a path is no motion: " + path.error().detail);
    }
    return path.value();
}

/// Adds the paths of a pose, with a turn or without one.
void add_paths(const PosePair& pose, double degrees, MotionScene& scene) {
    const MotionPaths maker(*scene.a, *scene.b, {path_length, degrees, scene.resolution});
    const auto paths = maker.paths_of(pose);
    if (!paths) {
        throw std::runtime_error("a path is no motion: " + paths.error().detail);
    }
    for (KeyedPath path : paths.value()) {
        path.kind += degrees == 0 ? ", straight" : ", turning";
        scene.paths.push_back(std::move(path));
    }
}

MotionScene motions_of(const Scene& bodies) {
    MotionScene scene{bodies.name, bodies.a, bodies.b, 0.0005, path_length, {}};
    for (const PosePair& pose : bodies.poses) {
        add_paths(pose, 0, scene);
        add_paths(pose, 30, scene);
    }
    return scene;
}

/// Adds paths of B along z, and of A against it by a share of the way, beside each other by up to 1
/// in x and y.
void add_encounters(const char* kind, double share_of_a, std::size_t count, MotionScene& scene) {
    const BodyRadii radii{body_radius(scene.a->vertices()), body_radius(scene.b->vertices())};
    std::mt19937_64 random(1);
    const double way_a = 0.5 * share_of_a * scene.length;
    const double way_b = 0.5 * scene.length - way_a;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 beside(tests::uniform(random, -1, 1), tests::uniform(random, -1, 1), 0);
        const auto poses = [&](double time) {
            return PosePair{Pose::from_quaternion({}, Vec3(0, 0, -time * way_a)),
                            Pose::from_quaternion({}, beside + Vec3(0, 0, time * way_b))};
        };
        scene.paths.push_back(
            checked(keyed_path(kind, poses(-1), poses(1), radii, scene.resolution)));
    }
}

/// Two boxes of side 2 whose meshes stand apart along z.
MotionScene two_boxes(std::size_t count) {
    MotionScene scene{"two boxes",
                      tests::share(tests::make_box_between(Vec3(-1, -1, 3), Vec3(1, 1, 5))),
                      tests::share(tests::make_box_between(Vec3(-1, -1, -5), Vec3(1, 1, -3))),
                      0.001,
                      16,
                      {}};
    add_encounters("both, straight", 0.5, count, scene);
    return scene;
}

MotionScene thin_wall(std::size_t count) {
    MotionScene scene{
        "thin wall",
        tests::share(tests::make_box_between(Vec3(-2, -2, -0.5e-6), Vec3(2, 2, 0.5e-6))),
        tests::share(tests::make_box(Vec3(0.001, 0.001, 0.001))),
        0.001,
        10,
        {}};
    add_encounters("through, straight", 0, count, scene);
    return scene;
}

} // namespace

std::vector<MotionScene> motion_scenes(const MotionSceneOptions& options) {
    const auto is_wanted = [&](const std::string& name) {
        return name.find(options.only) != std::string::npos;
    };
    std::vector<MotionScene> scenes;
    for (const SceneSource& source : scene_sources(options.scenes)) {
        const bool is_vehicle =
            source.name == "drivaer x sedan" || source.name == "hatchback x toy truck";
        if (is_vehicle && is_wanted(source.name)) {
            if (const auto bodies = source.load()) {
                scenes.push_back(motions_of(*bodies));
            }
        }
    }
    for (MotionScene& scene :
         std::vector{two_boxes(options.scenes.poses), thin_wall(options.scenes.poses)}) {
        if (is_wanted(scene.name)) {
            scenes.push_back(std::move(scene));
        }
    }
    return scenes;
}

} // namespace cd::bench
