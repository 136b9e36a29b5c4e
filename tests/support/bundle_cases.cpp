#include "tests/support/bundle_cases.hpp"

#include "tests/support/shapes.hpp"
#include "tests/support/shot_cases.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace cd::tests {

namespace {

bool is_rigid(const Pose& pose) {
    return pose.kind() == Pose::Kind::Quaternion || pose.matrix() == Mat3::Identity();
}

/// A corner of a triangle, a point of an edge, or a point of its plane.
Vec3 aim(std::mt19937_64& random, const Corners& t) {
    const Vec3 along = t[1] - t[0];
    switch (random() % 4) {
    case 0:
        return t[random() % 3];
    case 1:
        return t[0] + static_cast<double>(random() % 5) / 4 * along;
    default:
        return t[0] + uniform(random, 0, 1) * along + uniform(random, -0.2, 0.6) * (t[2] - t[0]);
    }
}

/// Moves a number by at most two steps of a double.
double nudged(std::mt19937_64& random, double x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (auto steps = random() % 3; steps > 0; --steps) {
        x = std::nextafter(x, random() % 2 == 0 ? infinity : -infinity);
    }
    return x;
}

Mesh mesh_of(const std::vector<Corners>& corners) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const Corners& t : corners) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), t.begin(), t.end());
        triangles.push_back({first, first + 1, first + 2});
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

} // namespace

std::vector<std::string> bundle_kinds() {
    std::vector<std::string> names;
    for (const auto& [name, make] : shot_makers()) {
        names.push_back(name);
    }
    return names;
}

Mesh mesh_of(const std::vector<Segment>& lines) {
    std::vector<Vec3> ends;
    std::vector<Triangle> triangles;
    for (const Segment& line : lines) {
        const auto first = static_cast<std::uint32_t>(ends.size());
        ends.push_back(line.p);
        ends.push_back(line.q);
        triangles.push_back({first, first + 1, first + 1});
    }
    return make_mesh(std::move(ends), std::move(triangles));
}

BundleCase make_bundle_case(const std::string& kind, std::mt19937_64& random) {
    const ShotCase c = shot_makers().at(kind)(random);
    BundleCase made{mesh_of(c.triangles), {}, c.poses};
    if (!is_rigid(made.poses.b)) {
        made.poses.b = random() % 2 == 0 ? Pose() : make_pose(random, 1);
    }
    const auto axis = static_cast<Eigen::Index>(random() % 3);
    const Mat3 to_b = made.poses.b.rotation().transpose();
    std::vector<Vec3> aims;
    double far = 0;
    for (int i = 0; i < 12; ++i) {
        const Corners& t = c.triangles[random() % c.triangles.size()];
        const Vec3 in_world = made.poses.a.apply(aim(random, t));
        aims.push_back(to_b * (in_world - made.poses.b.translation()));
        far = std::max(far, aims.back().cwiseAbs().maxCoeff());
    }
    // Some bundles end amid the triangles.
    const double reach = std::ldexp(1.0, std::ilogb(far) + (random() % 4 == 0 ? -1 : 2));
    const double from = random() % 2 == 0 ? reach : -reach;
    for (const Vec3& at : aims) {
        Segment line{at, at};
        line.p[(axis + 1) % 3] = line.q[(axis + 1) % 3] = nudged(random, at[(axis + 1) % 3]);
        line.p[(axis + 2) % 3] = line.q[(axis + 2) % 3] = nudged(random, at[(axis + 2) % 3]);
        line.p[axis] = from;
        line.q[axis] = -from;
        made.lines.push_back(line);
    }
    return made;
}

std::vector<Segment> grid_lines(std::mt19937_64& random,
                                std::size_t axis,
                                const std::array<int, 2>& counts,
                                double spacing,
                                double jitter,
                                const std::array<double, 2>& ends) {
    const auto along = static_cast<Eigen::Index>(axis);
    std::vector<Segment> lines;
    for (int j = 0; j < counts[1]; ++j) {
        for (int i = 0; i < counts[0]; ++i) {
            Vec3 p = Vec3::Zero();
            p[(along + 1) % 3] =
                spacing * (i - 0.5 * (counts[0] - 1) + jitter * uniform(random, -0.5, 0.5));
            p[(along + 2) % 3] =
                spacing * (j - 0.5 * (counts[1] - 1) + jitter * uniform(random, -0.5, 0.5));
            Segment line{p, p};
            line.p[along] = ends[0];
            line.q[along] = ends[1];
            lines.push_back(line);
        }
    }
    return lines;
}

} // namespace cd::tests
