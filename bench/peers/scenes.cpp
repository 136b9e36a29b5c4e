#include "bench/peers/scenes.hpp"

#include "bench/accuracy/suites/sources.hpp"
#include "bench/posed_trees.hpp"
#include "client/demo/sheet.hpp"
#include "client/demo/vehicle.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <random>
#include <utility>

namespace cd::bench {

namespace {

using MeshPointer = std::shared_ptr<const Mesh>;

std::vector<PosePair> spread(const std::vector<PosePair>& all, std::size_t count) {
    const std::size_t kept = std::min(count, all.size());
    std::vector<PosePair> poses;
    for (std::size_t i = 0; i < kept; ++i) {
        poses.push_back(all[i * all.size() / kept]);
    }
    return poses;
}

std::vector<PosePair> penetrating(const MeshPointer& a, const MeshPointer& b, std::size_t count) {
    ThreadPool pool;
    return random_poses(build_tree(a, {}, pool), build_tree(b, {}, pool), count, pool);
}

/// Places a wheel, its axle along y, into itself, turned about the axle, slightly tilted and moved:
/// lugs lie in their own grooves, and surface lies along surface.
std::vector<PosePair> nested(const Mesh& wheel, std::size_t count) {
    const Aabb box = bounding_box(wheel.vertices());
    std::mt19937_64 draw(1);
    std::vector<PosePair> poses;
    for (std::size_t i = 0; i < count; ++i) {
        // A quaternion contains half the angle.
        const auto [c, s] = circle_point(0.5 * tests::uniform(draw, 0, 1));
        const double tilt_x = tests::uniform(draw, -0.01, 0.01);
        const double tilt_z = tests::uniform(draw, -0.01, 0.01);
        const Quaternion turn = Quaternion{1, tilt_x, 0, tilt_z} * Quaternion{c, 0, s, 0};
        const Vec3 moved = tests::random_point(draw, 0.005 * box.diagonal());
        const Vec3 turned = Pose::from_quaternion(turn, Vec3::Zero()).apply(box.center());
        poses.push_back({Pose{}, Pose::from_quaternion(turn, box.center() - turned + moved)});
    }
    return poses;
}

struct Couple {
    const char* name;
    Model a;
    Model b;
    const char* poses = nullptr; ///< A pose file; null: generated poses.
};

constexpr double inch = 0.0254;
constexpr std::array couples{
    Couple{"drivaer x sedan", {"drivaer_fastback.ply"}, {"sedan.obj"}, "drivaer_sedan.scen"},
    Couple{"sedan x sedan", {"sedan.obj"}, {"sedan.obj"}, "sedan_sedan.scen"},
    Couple{
        "drivaer near sedan", {"drivaer_fastback.ply"}, {"sedan.obj"}, "drivaer_sedan_near.scen"},
    Couple{"m113 x sedan", {"m113_apc.glb"}, {"sedan.obj"}},
    Couple{"motorbike x motorbike", {"motorbike.ply"}, {"motorbike.ply"}},
    Couple{"bunny x bunny", {"stanford_bunny.ply"}, {"stanford_bunny.ply"}},
    Couple{"hatchback x toy truck", {"hatchback.obj", inch}, {"toy_truck.glb"}},
};

std::optional<Scene> load_couple(const Couple& couple, const SceneOptions& options) {
    const auto a = load_model(options.models, couple.a);
    const auto b = load_model(options.models, couple.b);
    if (!a || !b) {
        return std::nullopt;
    }
    Scene scene{"scenes", couple.name, a, b, {}};
    if (couple.poses == nullptr) {
        scene.poses = penetrating(a, b, options.poses);
    } else {
        const std::filesystem::path path = options.scenarios / couple.poses;
        scene.poses = spread(read_poses(path).value_or(std::vector<PosePair>()), options.poses);
        if (scene.poses.empty()) {
            std::fprintf(stderr, "MISSING: %s; its scene is left out\n", path.c_str());
            return std::nullopt;
        }
    }
    return scene;
}

/// A grid of 10 steps in each of six axes, of a sedan that stands beside the carrier.
struct Sweep {
    const char* name;
    double step;    ///< Metres.
    double degrees; ///< The step of the angles.
    double beside;  ///< The middle of the grid along y, metres.
};

constexpr std::array sweeps{
    Sweep{"sweep at 1 cm", 0.01, 1, 2.29},
    Sweep{"sweep at 1 mm", 0.001, 0.1, 2.25},
};

GridAxis axis_about(double middle, double step) {
    return {middle - 4.5 * step, middle + 4.5 * step, 10};
}

/// Takes poses that follow each other in the middle of the grid.
std::optional<Scene> load_sweep(const Sweep& sweep, const SceneOptions& options) {
    const auto a = load_model(options.models, {"m113_apc.glb"});
    const auto b = load_model(options.models, {"sedan.obj"});
    if (!a || !b) {
        return std::nullopt;
    }
    Grid grid;
    grid.position = {
        axis_about(0, sweep.step), axis_about(sweep.beside, sweep.step), axis_about(0, sweep.step)};
    for (int i = 0; i < 3; ++i) {
        grid.rotation[static_cast<std::size_t>(i)] = rotation_axis(axis_about(0, sweep.degrees), i);
    }
    Scene scene{"scenes", sweep.name, a, b, {}};
    const std::uint64_t count = std::min<std::uint64_t>(options.poses, grid.count());
    const std::uint64_t first = (grid.count() - count) / 2;
    for (std::uint64_t i = 0; i < count; ++i) {
        scene.poses.push_back(scenario_on(grid, first + i).poses);
    }
    return scene;
}

std::optional<Scene> load_wheel(const SceneOptions& options) {
    const auto wheel = load_model(options.models, {"lugged_wheel.obj"});
    if (!wheel) {
        return std::nullopt;
    }
    return Scene{"scenes", "wheel in its grooves", wheel, wheel, nested(*wheel, options.poses)};
}

struct Generated {
    MeshPointer truck;
    MeshPointer car;
};

Generated generate(std::uint64_t triangles) {
    return {make_vehicle(VehicleKind::Truck, triangles),
            make_vehicle(VehicleKind::Car, triangles * 3 / 10)};
}

/// One size for all, so that every size is tested in the same poses.
constexpr std::uint64_t posing_triangles = 30000;

Scene generated_scene(std::string suite,
                      std::string name,
                      std::uint64_t triangles,
                      std::size_t poses) {
    const Generated posed = generate(posing_triangles);
    Scene scene{std::move(suite), std::move(name), nullptr, nullptr, {}};
    scene.poses = penetrating(posed.truck, posed.car, poses);
    const Generated vehicles = generate(triangles);
    scene.a = vehicles.truck;
    scene.b = vehicles.car;
    return scene;
}

void add_sizes(const SceneOptions& options, std::vector<SceneSource>& sources) {
    for (std::uint64_t decade = 1000; decade <= options.size_max; decade *= 10) {
        for (const std::uint64_t triangles : {decade, 3 * decade}) {
            if (triangles > options.size_max) {
                break;
            }
            const std::string name = "truck of " + std::to_string(triangles);
            sources.push_back({"size", name, 1.3 * static_cast<double>(triangles), [=] {
                                   return generated_scene(
                                       "size", name, triangles, options.scaling_poses);
                               }});
        }
    }
}

} // namespace

std::vector<SceneSource> scene_sources(const SceneOptions& options) {
    std::vector<SceneSource> sources;
    for (const Couple& couple : couples) {
        sources.push_back({"scenes", couple.name, 0, [=] { return load_couple(couple, options); }});
    }
    for (const Sweep& sweep : sweeps) {
        sources.push_back({"scenes", sweep.name, 0, [=] { return load_sweep(sweep, options); }});
    }
    sources.push_back({"scenes", "wheel in its grooves", 0, [=] { return load_wheel(options); }});
    sources.push_back({"scenes", "truck x car", 0, [=] {
                           return generated_scene(
                               "scenes", "truck x car", options.vehicle_triangles, options.poses);
                       }});
    add_sizes(options, sources);
    return sources;
}

} // namespace cd::bench
