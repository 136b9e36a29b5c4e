#include "bench/accuracy/distance.hpp"

#include "bench/peers/engines/engine.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cd::bench {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the distance of a point from a segment, which may be a point.
double distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double square = along.squaredNorm();
    const double share = square > 0 ? std::clamp((p - from).dot(along) / square, 0.0, 1.0) : 0.0;
    return (p - from - share * along).norm();
}

/// Returns the distance of two segments: the nearest points are both inner, or one is an end.
double distance_of_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
    double least = std::min({distance_to_segment(p0, q0, q1),
                             distance_to_segment(p1, q0, q1),
                             distance_to_segment(q0, p0, p1),
                             distance_to_segment(q1, p0, p1)});
    // Ericson, Real-Time Collision Detection (2004), section 5.1.9.
    const Vec3 d1 = p1 - p0;
    const Vec3 d2 = q1 - q0;
    const Vec3 r = p0 - q0;
    const double a = d1.squaredNorm();
    const double e = d2.squaredNorm();
    const double b = d1.dot(d2);
    const double denominator = a * e - b * b;
    if (denominator > 0) {
        const double s = (b * d2.dot(r) - d1.dot(r) * e) / denominator;
        const double t = (a * d2.dot(r) - d1.dot(r) * b) / denominator;
        if (s > 0 && s < 1 && t > 0 && t < 1) {
            least = std::min(least, (r + s * d1 - t * d2).norm());
        }
    }
    return least;
}

/// Returns the distance of a point from a triangle, which may be degenerate.
double distance_to_triangle(const Vec3& p, const Corners& t) {
    double least = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
        least = std::min(least, distance_to_segment(p, t[i], t[(i + 1) % 3]));
    }
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    bool is_above = normal.squaredNorm() > 0;
    for (std::size_t i = 0; i < 3 && is_above; ++i) {
        is_above = normal.cross(t[(i + 1) % 3] - t[i]).dot(p - t[i]) >= 0;
    }
    return is_above ? std::min(least, std::abs(normal.dot(p - t[0])) / normal.norm()) : least;
}

double distance_of_triangles(const Corners& a, const Corners& b) {
    double least = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, distance_to_triangle(a[i], b), distance_to_triangle(b[i], a)});
        for (std::size_t j = 0; j < 3; ++j) {
            least =
                std::min(least, distance_of_segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
        }
    }
    return least;
}

struct Sphere {
    Vec3 center;
    double radius;
};

/// Returns world spheres around a tree's boxes.
std::vector<Sphere> spheres_of(const ObbTree& tree, const WorldFrame& to_world) {
    std::vector<Sphere> spheres;
    for (const ObbNode& node : tree.nodes()) {
        const Vec3 center(node.center[0], node.center[1], node.center[2]);
        const double radius = std::sqrt(static_cast<double>(node.half[0]) * node.half[0] +
                                        static_cast<double>(node.half[1]) * node.half[1] +
                                        static_cast<double>(node.half[2]) * node.half[2]);
        spheres.push_back({to_world.rotation * center + to_world.translation, radius});
    }
    return spheres;
}

} // namespace

double distance_of_bodies(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    const WorldFrame to_world_a(poses.a);
    const WorldFrame to_world_b(poses.b);
    const std::vector<Sphere> spheres_a = spheres_of(a, to_world_a);
    const std::vector<Sphere> spheres_b = spheres_of(b, to_world_b);
    const TriangleSpan triangles_a{a.view().vertices, a.view().triangles};
    const TriangleSpan triangles_b{b.view().vertices, b.view().triangles};
    const auto least_between = [&](std::uint32_t ia, std::uint32_t ib) {
        return (spheres_a[ia].center - spheres_b[ib].center).norm() - spheres_a[ia].radius -
               spheres_b[ib].radius;
    };
    double least = infinity;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [ia, ib] = stack.back();
        stack.pop_back();
        const ObbNode& node_a = a.nodes()[ia];
        const ObbNode& node_b = b.nodes()[ib];
        if (least_between(ia, ib) >= least) {
            continue;
        }
        if (node_a.is_leaf() && node_b.is_leaf()) {
            for (std::uint32_t i = node_a.triangles_begin; i < node_a.triangles_end; ++i) {
                for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
                    least = std::min(least,
                                     distance_of_triangles(to_world_a(triangles_a.corners_at(i)),
                                                           to_world_b(triangles_b.corners_at(j))));
                }
            }
            continue;
        }
        const bool down_a =
            node_b.is_leaf() || (!node_a.is_leaf() && spheres_a[ia].radius >= spheres_b[ib].radius);
        std::array<std::pair<std::uint32_t, std::uint32_t>, 2> next{
            {{down_a ? ia + 1 : ia, down_a ? ib : ib + 1},
             {down_a ? node_a.right : ia, down_a ? ib : node_b.right}}};
        // The nearer pair is popped first.
        if (least_between(next[0].first, next[0].second) <
            least_between(next[1].first, next[1].second)) {
            std::swap(next[0], next[1]);
        }
        stack.insert(stack.end(), next.begin(), next.end());
    }
    return least;
}

} // namespace cd::bench
