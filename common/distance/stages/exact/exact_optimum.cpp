#include "common/distance/stages/exact/exact_optimum.hpp"

#include "common/pair/numbers/exact_vectors.hpp"

#include <algorithm>
#include <span>

namespace cd {

namespace {

using exact_vectors::cross;
using exact_vectors::dot;
using exact_vectors::minus;

using ThreeCorners = std::span<const ExactVec, 3>;

/// A feature's points x and y. The products of `direction`, a positive multiple of x - y, with x
/// and y are those with two corners.
struct Nearness {
    ExactSquare square;
    ExactVec direction;
    const ExactVec& like_x;
    const ExactVec& like_y;
};

const ExactVec& next(ThreeCorners t, std::size_t k) {
    return t[(k + 1) % 3];
}

ExactVec opposite(const ExactVec& v) {
    return {-v[0], -v[1], -v[2]};
}

Nearness at_corners(const ExactVec& p, const ExactVec& q) {
    const ExactVec w = minus(p, q);
    return {{dot(w, w), 1}, w, p, q};
}

/// Here x is the corner p.
std::optional<Nearness> at_edge(const ExactVec& p, const ExactVec& from, const ExactVec& to) {
    const ExactVec u = minus(to, from);
    const ExactVec w = minus(p, from);
    const ExactInt length = dot(u, u);
    const ExactInt along = dot(w, u);
    if (along < 0 || along > length || length == 0) {
        return std::nullopt;
    }
    const ExactVec direction{
        w[0] * length - u[0] * along, w[1] * length - u[1] * along, w[2] * length - u[2] * along};
    return Nearness{{dot(w, w) * length - along * along, length}, direction, p, from};
}

/// Here x is the corner p.
std::optional<Nearness> at_face(const ExactVec& p, ThreeCorners face) {
    const ExactVec normal = cross(minus(face[1], face[0]), minus(face[2], face[0]));
    for (std::size_t k = 0; k < 3; ++k) {
        const ExactVec edge = minus(next(face, k), face[k]);
        if (dot(normal, cross(edge, minus(p, face[k]))) < 0) {
            return std::nullopt;
        }
    }
    const ExactInt height = dot(minus(p, face[0]), normal);
    if (height == 0) {
        return std::nullopt;
    }
    return Nearness{
        {height * height, dot(normal, normal)}, height > 0 ? normal : opposite(normal), p, face[0]};
}

std::optional<Nearness>
at_edges(const ExactVec& p, const ExactVec& p_to, const ExactVec& q, const ExactVec& q_to) {
    const ExactVec u = minus(p_to, p);
    const ExactVec v = minus(q_to, q);
    const ExactVec w = minus(p, q);
    const ExactVec normal = cross(u, v);
    const ExactInt square = dot(normal, normal);
    const ExactInt s = dot(cross(v, w), normal);
    const ExactInt t = dot(cross(u, w), normal);
    const ExactInt height = dot(w, normal);
    if (s < 0 || s > square || t < 0 || t > square || height == 0) {
        return std::nullopt;
    }
    return Nearness{{height * height, square}, height > 0 ? normal : opposite(normal), p, q};
}

/// Exchanges the roles of x and y.
std::optional<Nearness> swapped(std::optional<Nearness> found) {
    if (!found) {
        return std::nullopt;
    }
    return Nearness{found->square, opposite(found->direction), found->like_y, found->like_x};
}

std::optional<Nearness> nearness_of(ThreeCorners a, ThreeCorners b, std::size_t number) {
    const std::size_t i = number / 3 % 3;
    const std::size_t j = number % 3;
    if (number >= feature::edge_edge) {
        const std::size_t edge = (number - feature::edge_edge) / 3;
        return at_edges(a[edge], next(a, edge), b[j], next(b, j));
    }
    if (number >= feature::face_corner) {
        return swapped(at_face(b[j], a));
    }
    if (number >= feature::corner_face) {
        return at_face(a[j], b);
    }
    if (number >= feature::edge_corner) {
        return swapped(at_edge(b[j], a[i], next(a, i)));
    }
    if (number >= feature::corner_edge) {
        return at_edge(a[i], b[j], next(b, j));
    }
    return at_corners(a[i], b[j]);
}

} // namespace

std::optional<ExactSquare> square_if_nearest(const std::array<ExactVec, 6>& corners,
                                             std::size_t proposed) {
    const ThreeCorners a(corners.data(), 3);
    const ThreeCorners b(corners.data() + 3, 3);
    const std::optional<Nearness> found = nearness_of(a, b, proposed);
    if (!found) {
        return std::nullopt;
    }
    const auto is_farther = [&](const ExactVec& l, const ExactVec& r) {
        return dot(found->direction, minus(l, r)) >= 0;
    };
    const bool is_nearest =
        std::all_of(
            a.begin(), a.end(), [&](const ExactVec& c) { return is_farther(c, found->like_x); }) &&
        std::all_of(
            b.begin(), b.end(), [&](const ExactVec& c) { return is_farther(found->like_y, c); });
    return is_nearest ? std::optional(found->square) : std::nullopt;
}

} // namespace cd
