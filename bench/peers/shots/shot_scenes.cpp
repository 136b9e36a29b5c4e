#include "bench/peers/shots/shot_scenes.hpp"

#include "bench/accuracy/suites/sources.hpp"
#include "client/bundle/shot_plan.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/topology.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cd::bench {

namespace {

constexpr double inch = 0.0254;
constexpr std::array models{Model{"drivaer_fastback.ply"},
                            Model{"m113_apc.glb"},
                            Model{"sedan.obj"},
                            Model{"lugged_wheel.obj"},
                            Model{"motorbike.ply"},
                            Model{"hatchback.obj", inch}};

ShotScene scene_of(const ShotTarget& target, const char* kind) {
    return {target.name, kind, analyse_topology(*target.mesh).is_closed(), target.mesh, {}};
}

/// Rounds a positive number to 8 binary digits.
double with_few_digits(double value) {
    int exponent = 0;
    const double digits = std::round(256 * std::frexp(value, &exponent));
    return std::ldexp(digits, exponent - 8);
}

/// Returns a box around the given one, whose middle and half sides are multiples of `unit`.
Aabb box_on_grid(const Aabb& box, double unit) {
    const auto rounded = [&](double x) { return unit * std::round(x / unit); };
    const auto rounded_up = [&](double x) { return unit * std::ceil(x / unit); };
    const Vec3 middle = box.center().unaryExpr(rounded);
    const Vec3 half = (0.5 * box.size() + Vec3::Constant(unit)).unaryExpr(rounded_up);
    Aabb on_grid;
    on_grid.add(middle - half);
    on_grid.add(middle + half);
    return on_grid;
}

/// Returns the pose of a view along an axis with the numbers that it would have without roundings:
/// a quaternion of 0 and 1, which is the same rotation, and a translation by multiples of `unit`.
Pose without_roundings(const Pose& pose, double unit) {
    const Quaternion q = pose.quaternion();
    const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    const auto whole = [&](double x) { return std::round(x / largest); };
    const auto multiple = [&](double x) { return unit * std::round(x / unit); };
    return Pose::from_quaternion({whole(q.w), whole(q.x), whole(q.y), whole(q.z)},
                                 pose.translation().unaryExpr(multiple));
}

/// Collects lines along the three axes, each through a given point.
class LinesOnAxes {
  public:
    explicit LinesOnAxes(const Mesh& mesh) {
        const Aabb box = bounding_box(mesh.vertices());
        const double most = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
        far_ = std::exp2(std::ceil(std::log2(most)) + 1);
    }

    /// Adds a line if the line is one of floats.
    void add(const Vec3& point, std::size_t axis) {
        const auto along = static_cast<Eigen::Index>(axis);
        LineEnds line{point, point};
        line.p[along] = far_;
        line.q[along] = -far_;
        if (std::all_of(line.p.begin(), line.p.end(), is_float_number)) {
            lines_[axis].push_back(line);
        }
    }

    /// Returns a bundle for each axis that has lines.
    [[nodiscard]] std::vector<ShotBundle> bundles() const {
        std::vector<ShotBundle> bundles;
        for (const std::vector<LineEnds>& lines : lines_) {
            if (!lines.empty()) {
                bundles.push_back({tests::share(line_mesh(lines).value()), {Pose()}});
            }
        }
        return bundles;
    }

  private:
    double far_ = 1;
    std::array<std::vector<LineEnds>, 3> lines_;
};

/// Returns at most `count` of the values, evenly spread.
template <class Value>
std::vector<Value> spread(const std::vector<Value>& all, std::size_t count) {
    const std::size_t kept = std::min(count, all.size());
    std::vector<Value> values;
    for (std::size_t i = 0; i < kept; ++i) {
        values.push_back(all[i * all.size() / kept]);
    }
    return values;
}

template <class Value>
void make_unique(std::vector<Value>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace

std::vector<ShotTarget> shot_targets(const ShotSceneOptions& options) {
    const auto is_wanted = [&](const std::string& name) {
        return name.find(options.only) != std::string::npos;
    };
    std::vector<ShotTarget> targets;
    if (is_wanted("sphere")) {
        targets.push_back(
            {"sphere",
             tests::share(tests::as_floats(tests::make_sphere(options.sphere_subdivisions)))});
    }
    for (const Model& model : models) {
        const std::string name = std::filesystem::path(model.file).stem();
        if (!is_wanted(name)) {
            continue;
        }
        if (const auto mesh = load_model(options.models, model)) {
            targets.push_back({name, tests::share(tests::as_floats(*mesh))});
        }
    }
    return targets;
}

ShotScene grid_scene(const ShotTarget& target, std::uint32_t lines) {
    const Aabb box = bounding_box(target.mesh->vertices());
    const Vec3 size = box.size();
    const double area = (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()) / 3;
    ShotsSpec front;
    front.grid.spacing = with_few_digits(std::sqrt(area / lines));
    ShotsSpec left = front;
    left.azimuth_deg = {90, 90, 1};
    ShotsSpec above = front;
    above.elevation_deg = {90, 90, 1};

    const Aabb on_grid = box_on_grid(box, front.grid.spacing);
    ShotScene scene = scene_of(target, "grid");
    ShotBundle bundle{tests::share(shot_mesh(front, on_grid).value()), {}};
    for (const ShotsSpec& spec : {front, left, above}) {
        const std::vector<BundlePose> places = shot_poses(spec, on_grid).value();
        for (const BundlePose& place : places) {
            bundle.poses.push_back(without_roundings(place.pose, front.grid.spacing));
        }
    }
    scene.bundles.push_back(std::move(bundle));
    return scene;
}

ShotScene vertex_scene(const ShotTarget& target, std::uint32_t count) {
    std::vector<std::uint32_t> used;
    for (const Triangle& triangle : target.mesh->triangles()) {
        used.insert(used.end(), triangle.begin(), triangle.end());
    }
    make_unique(used);
    LinesOnAxes lines(*target.mesh);
    std::size_t next = 0;
    for (const std::uint32_t vertex : spread(used, count)) {
        lines.add(target.mesh->vertices()[vertex], next++ % 3);
    }
    ShotScene scene = scene_of(target, "vertices");
    scene.bundles = lines.bundles();
    return scene;
}

ShotScene edge_scene(const ShotTarget& target, std::uint32_t count) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& triangle : target.mesh->triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges.emplace_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
        }
    }
    make_unique(edges);
    LinesOnAxes lines(*target.mesh);
    std::size_t next = 0;
    for (const auto& [i, j] : spread(edges, count)) {
        const std::vector<Vec3>& vertices = target.mesh->vertices();
        lines.add(0.5 * (vertices[i] + vertices[j]), next++ % 3);
    }
    ShotScene scene = scene_of(target, "edge middles");
    scene.bundles = lines.bundles();
    return scene;
}

} // namespace cd::bench
