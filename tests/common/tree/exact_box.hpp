// Boxes and poses in rational arithmetic: the slow reference for box tests.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"
#include "tests/support/posed_point.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace cd::tests {

using Rational = boost::multiprecision::cpp_rational;
using ExactVec = std::array<Rational, 3>;
using ExactMat = std::array<ExactVec, 3>; ///< Three rows.

inline Rational dot(const ExactVec& a, const ExactVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline ExactVec cross(const ExactVec& a, const ExactVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline ExactVec operator*(const ExactMat& m, const ExactVec& v) {
    return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

inline ExactMat transposed(const ExactMat& m) {
    return {ExactVec{m[0][0], m[1][0], m[2][0]},
            ExactVec{m[0][1], m[1][1], m[2][1]},
            ExactVec{m[0][2], m[1][2], m[2][2]}};
}

inline ExactMat operator*(const ExactMat& a, const ExactMat& b) {
    const ExactMat columns = transposed(b);
    return transposed({a * columns[0], a * columns[1], a * columns[2]});
}

inline ExactVec operator+(const ExactVec& a, const ExactVec& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline ExactVec scaled(const Rational& factor, const ExactVec& v) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}

inline ExactMat inverse(const ExactMat& m) {
    const Rational factor = 1 / dot(m[0], cross(m[1], m[2]));
    return transposed({scaled(factor, cross(m[1], m[2])),
                       scaled(factor, cross(m[2], m[0])),
                       scaled(factor, cross(m[0], m[1]))});
}

inline ExactVec exact(const Vec3& v) {
    return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

inline ExactMat axes_of(const ObbNode& node) {
    ExactMat m;
    for (std::size_t i = 0; i < 9; ++i) {
        m[i / 3][i % 3] = Rational(node.axes[i]);
    }
    return m;
}

inline ExactVec center_of(const ObbNode& node) {
    return {Rational(node.center[0]), Rational(node.center[1]), Rational(node.center[2])};
}

/// Returns the centre in doubles.
inline Vec3 center_point(const ObbNode& node) {
    return {node.center[0], node.center[1], node.center[2]};
}

/// Checks the contract of ObbNode.
inline bool contains(const ObbNode& node, const Vec3& point) {
    const ExactVec alpha = axes_of(node) * (exact(point) + scaled(Rational(-1), center_of(node)));
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::isfinite(node.half[i]) && abs(alpha[i]) > Rational(node.half[i])) {
            return false;
        }
    }
    return true;
}

/// Returns the exact linear part of a pose.
inline ExactMat exact_rotation(const Pose& pose) {
    return rotation_in<Rational>(pose);
}

/// A box in the world: a parallelepiped, since its frame is only nearly orthonormal.
struct ExactBox {
    ExactVec center;
    std::array<ExactVec, 3> edges; ///< From the centre to three faces' middles.
};

inline ExactBox exact_box(const ObbNode& node, const Pose& pose) {
    const ExactMat f = axes_of(node);
    const ExactMat rotation = exact_rotation(pose);
    const ExactMat columns = transposed(inverse(f));
    ExactBox box;
    box.center = rotation * center_of(node) + exact(pose.translation());
    for (std::size_t k = 0; k < 3; ++k) {
        box.edges[k] = rotation * scaled(Rational(node.half[k]), columns[k]);
    }
    return box;
}

/// True if the closed boxes share a point: no plane along a face of one, or along one edge of
/// each, separates them.
inline bool exactly_overlap(const ExactBox& a, const ExactBox& b) {
    std::vector<ExactVec> axes;
    for (std::size_t i = 0; i < 3; ++i) {
        axes.push_back(cross(a.edges[i], a.edges[(i + 1) % 3]));
        axes.push_back(cross(b.edges[i], b.edges[(i + 1) % 3]));
        for (std::size_t k = 0; k < 3; ++k) {
            axes.push_back(cross(a.edges[i], b.edges[k]));
        }
    }
    const ExactVec between = b.center + scaled(Rational(-1), a.center);
    for (const ExactVec& axis : axes) {
        Rational reach = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            reach += abs(dot(axis, a.edges[k])) + abs(dot(axis, b.edges[k]));
        }
        if (abs(dot(axis, between)) > reach) {
            return false;
        }
    }
    return true;
}

inline bool exactly_overlap(const ObbNode& a, const ObbNode& b, const PosePair& poses) {
    return exactly_overlap(exact_box(a, poses.a), exact_box(b, poses.b));
}

} // namespace cd::tests
