// Exact numbers made from doubles: integers times powers of two, and poses made of them.
#pragma once

#include "common/geometry/pose.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>

namespace cd {

/// An integer of any size. One of up to 1024 bits, enough for ordinary coordinates, needs no heap.
using ExactInt = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024>>;

/// mantissa * 2^exponent. Sums, differences and products are exact.
struct Dyadic {
    ExactInt mantissa = 0;
    int exponent = 0;
};

/// Converts a finite double. The mantissa is odd, or 0 with exponent 0.
[[nodiscard]] Dyadic to_dyadic(double value);

[[nodiscard]] Dyadic operator*(const Dyadic& left, const Dyadic& right);
[[nodiscard]] Dyadic operator+(const Dyadic& left, const Dyadic& right);
[[nodiscard]] Dyadic operator-(const Dyadic& left, const Dyadic& right);

/// Rounds (numerator / denominator) 2^exponent to the nearest finite double, ties to even; the
/// denominator must not be 0. Denormal results round to their coarser grid. Values beyond the
/// largest finite double become it, with their sign: there is no infinity. A zero result is +0.
[[nodiscard]] double
nearest_double(const ExactInt& numerator, const ExactInt& denominator, int exponent);

/// A body's map to the world, scaled by its norm: x' = (linear x + translation) / norm. A matrix
/// has norm 1, a quaternion q has q.q.
struct ExactPose {
    std::array<std::array<Dyadic, 3>, 3> linear;
    std::array<Dyadic, 3> translation;
    Dyadic norm{1, 0};
};

[[nodiscard]] ExactPose to_exact(const Pose& pose);
/// Returns where a pose puts a point, times the pose's norm.
[[nodiscard]] std::array<Dyadic, 3> scaled_world(const ExactPose& pose, const Vec3& point);

/// The corners of two triangles, each a multiple of 2^exponent.
struct ExactLattice {
    std::array<std::array<ExactInt, 3>, 6> corners;
    int exponent = 0;
};
/// Returns the corners of these coordinates, with the largest exponent if one is not 0.
[[nodiscard]] ExactLattice to_lattice(const std::array<Dyadic, 18>& coordinates);

} // namespace cd
