#include "tests/support/exact_distance.hpp"

#include "tests/support/posed_point.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace cd::tests {

namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class N>
using Point = std::array<N, 3>;
template <class N>
using Points = std::array<Point<N>, 3>;

template <class N>
Point<N> minus(const Point<N>& l, const Point<N>& r) {
    return {N(l[0] - r[0]), N(l[1] - r[1]), N(l[2] - r[2])};
}

template <class N>
N dot(const Point<N>& l, const Point<N>& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

template <class N>
Point<N> cross(const Point<N>& l, const Point<N>& r) {
    return {
        N(l[1] * r[2] - l[2] * r[1]), N(l[2] * r[0] - l[0] * r[2]), N(l[0] * r[1] - l[1] * r[0])};
}

template <class N>
Points<N> corners_in_world(const Mesh& mesh, std::uint32_t triangle, const Pose& pose) {
    const Corners corners = mesh.corners(triangle);
    return {world_point<N>(pose, corners[0]),
            world_point<N>(pose, corners[1]),
            world_point<N>(pose, corners[2])};
}

template <class N>
N point_to_segment(const Point<N>& p, const Point<N>& a, const Point<N>& b) {
    const Point<N> d = minus(b, a);
    const N length = dot(d, d);
    const N along = dot(minus(p, a), d);
    if (along <= 0) {
        return dot(minus(p, a), minus(p, a));
    }
    if (along >= length) {
        return dot(minus(p, b), minus(p, b));
    }
    const Point<N> normal = cross(d, minus(p, a));
    return dot(normal, normal) / length;
}

/// Lowers `least` to the point's distance from the triangle's plane if its foot is inside.
template <class N>
void point_to_face(const Point<N>& p, const Points<N>& t, N& least) {
    const Point<N> normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    const N square = dot(normal, normal);
    if (square == 0) {
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Point<N> edge = minus(t[(i + 1) % 3], t[i]);
        if (dot(cross(edge, minus(p, t[i])), normal) < 0) {
            return;
        }
    }
    const N height = dot(minus(p, t[0]), normal);
    least = std::min(least, N(height * height / square));
}

/// Lowers `least` to the distance of two lines if their nearest points lie on both edges.
template <class N>
void edge_to_edge(
    const Point<N>& a, const Point<N>& a2, const Point<N>& b, const Point<N>& b2, N& least) {
    const Point<N> d = minus(a2, a);
    const Point<N> e = minus(b2, b);
    const Point<N> normal = cross(d, e);
    const N square = dot(normal, normal);
    if (square == 0) {
        return;
    }
    const Point<N> between = minus(b, a);
    const N s = dot(cross(between, e), normal);
    const N t = dot(cross(between, d), normal);
    if (s < 0 || s > square || t < 0 || t > square) {
        return;
    }
    const N height = dot(between, normal);
    least = std::min(least, N(height * height / square));
}

/// Returns the squared distance of two triangles that do not intersect.
template <class N>
N squared_distance(const Points<N>& a, const Points<N>& b) {
    N least = point_to_segment(a[0], b[0], b[1]);
    for (std::size_t i = 0; i < 3; ++i) {
        point_to_face(a[i], b, least);
        point_to_face(b[i], a, least);
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t i2 = (i + 1) % 3;
            const std::size_t j2 = (j + 1) % 3;
            least = std::min(least, point_to_segment(a[i], b[j], b[j2]));
            least = std::min(least, point_to_segment(b[j], a[i], a[i2]));
            edge_to_edge(a[i], a[i2], b[j], b[j2], least);
        }
    }
    return least;
}

template <class N>
std::vector<Points<N>> all_corners(const Mesh& mesh, const Pose& pose) {
    std::vector<Points<N>> triangles;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        triangles.push_back(corners_in_world<N>(mesh, i, pose));
    }
    return triangles;
}

} // namespace

bool distance_is_at_most(const Mesh& a, const Mesh& b, const PosePair& poses, double bound) {
    const auto corners_a = all_corners<double>(a, poses.a);
    const auto corners_b = all_corners<double>(b, poses.b);
    struct Near {
        double square;
        std::uint32_t a;
        std::uint32_t b;
    };
    std::vector<Near> pairs;
    for (std::uint32_t i = 0; i < corners_a.size(); ++i) {
        for (std::uint32_t j = 0; j < corners_b.size(); ++j) {
            pairs.push_back({squared_distance(corners_a[i], corners_b[j]), i, j});
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Near& l, const Near& r) {
        return l.square < r.square;
    });
    // One pair that is near enough is proof; doubles only choose which pairs to try first.
    constexpr std::size_t pairs_tried = 8;
    const Rational limit = Rational(bound) * Rational(bound);
    for (std::size_t i = 0; i < std::min(pairs_tried, pairs.size()); ++i) {
        if (squared_distance(corners_in_world<Rational>(a, pairs[i].a, poses.a),
                             corners_in_world<Rational>(b, pairs[i].b, poses.b)) <= limit) {
            return true;
        }
    }
    return false;
}

} // namespace cd::tests
