#include "common/tree/planes/simplex.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace cd {

namespace {

using Corners4 = std::array<Vec3, 4>;
using Weights = std::array<double, 4>;

double part_of(double value, double whole) {
    return whole > 0 ? std::clamp(value / whole, 0.0, 1.0) : 0;
}

/// Sets the weights of corners i and k to the nearest point of their segment.
void nearest_of_segment(const Corners4& c, std::size_t i, std::size_t k, Weights& weights) {
    const Vec3 along = c[k] - c[i];
    const double share = part_of(-c[i].dot(along), along.squaredNorm());
    weights[i] = 1 - share;
    weights[k] = share;
}

Vec3 combined(const Corners4& c, const Weights& weights) {
    return weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2] + weights[3] * c[3];
}

/// Sets the weights of three corners to the nearest point of the edges between them.
void nearest_of_edges(const Corners4& c, const std::array<std::size_t, 3>& of, Weights& weights) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t edge = 0; edge < 3; ++edge) {
        Weights of_edge{};
        nearest_of_segment(c, of[edge], of[(edge + 1) % 3], of_edge);
        const double square = combined(c, of_edge).squaredNorm();
        if (square < least) {
            least = square;
            weights = of_edge;
        }
    }
}

/// Sets the weights of three corners to the nearest point of their triangle.
void nearest_of_triangle(
    const Corners4& c, std::size_t i, std::size_t k, std::size_t m, Weights& weights) {
    const Vec3 ab = c[k] - c[i];
    const Vec3 ac = c[m] - c[i];
    const double d1 = -ab.dot(c[i]);
    const double d2 = -ac.dot(c[i]);
    const double d3 = -ab.dot(c[k]);
    const double d4 = -ac.dot(c[k]);
    const double d5 = -ab.dot(c[m]);
    const double d6 = -ac.dot(c[m]);
    const double of_m = d1 * d4 - d3 * d2;
    const double of_k = d5 * d2 - d1 * d6;
    const double of_i = d3 * d6 - d5 * d4;
    if (!(of_i + of_k + of_m > 0x1p-60 * ab.squaredNorm() * ac.squaredNorm())) {
        nearest_of_edges(c, {i, k, m}, weights); // The triangle is degenerate, or nearly so.
    } else if (d1 <= 0 && d2 <= 0) {
        weights[i] = 1;
    } else if (d3 >= 0 && d4 <= d3) {
        weights[k] = 1;
    } else if (d6 >= 0 && d5 <= d6) {
        weights[m] = 1;
    } else if (of_m <= 0 && d1 >= 0 && d3 <= 0) {
        nearest_of_segment(c, i, k, weights);
    } else if (of_k <= 0 && d2 >= 0 && d6 <= 0) {
        nearest_of_segment(c, i, m, weights);
    } else if (of_i <= 0 && d4 >= d3 && d5 >= d6) {
        nearest_of_segment(c, k, m, weights);
    } else {
        const double sum = of_i + of_k + of_m;
        weights[k] = part_of(of_k, sum);
        weights[m] = std::min(part_of(of_m, sum), 1 - weights[k]);
        weights[i] = 1 - weights[k] - weights[m];
    }
}

/// Sets the weights to the origin's if it is inside; else returns false.
bool is_inside(const Corners4& c, Weights& weights) {
    const Vec3 a = c[1] - c[0];
    const Vec3 b = c[2] - c[0];
    const Vec3 d = c[3] - c[0];
    const double volume = a.dot(b.cross(d));
    if (volume == 0) {
        return false;
    }
    const Vec3 to = -c[0];
    weights[1] = to.dot(b.cross(d)) / volume;
    weights[2] = a.dot(to.cross(d)) / volume;
    weights[3] = a.dot(b.cross(to)) / volume;
    weights[0] = 1 - weights[1] - weights[2] - weights[3];
    return std::ranges::all_of(weights, [](double weight) { return weight >= 0 && weight <= 1; });
}

Weights nearest_of_tetrahedron(const Corners4& c) {
    Weights weights{};
    if (is_inside(c, weights)) {
        return weights;
    }
    constexpr std::array<std::array<std::size_t, 3>, 4> faces{
        {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [i, k, m] : faces) {
        Weights of_face{};
        nearest_of_triangle(c, i, k, m, of_face);
        const double square = combined(c, of_face).squaredNorm();
        if (square < least) {
            least = square;
            weights = of_face;
        }
    }
    return weights;
}

} // namespace

NearestOfSimplex nearest_of_simplex(const std::array<Vec3, 4>& corners, std::size_t count) {
    NearestOfSimplex nearest;
    switch (count) {
    case 1:
        nearest.weights[0] = 1;
        break;
    case 2:
        nearest_of_segment(corners, 0, 1, nearest.weights);
        break;
    case 3:
        nearest_of_triangle(corners, 0, 1, 2, nearest.weights);
        break;
    default:
        nearest.weights = nearest_of_tetrahedron(corners);
    }
    for (std::size_t i = 0; i < count; ++i) {
        nearest.point += nearest.weights[i] * corners[i];
    }
    return nearest;
}

} // namespace cd
