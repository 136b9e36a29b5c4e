// Exact numbers made from doubles: integers times powers of two, and poses in them.
#pragma once

#include "common/geometry/pose.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>

namespace cd {

/// Of any size; up to 1024 bits stay out of the heap, which is what ordinary coordinates need.
using ExactInt = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024>>;

/// mantissa * 2^exponent. Sums, differences and products are exact.
struct Dyadic {
    ExactInt mantissa = 0;
    int exponent = 0;
};

/// The value of a finite double, with an odd mantissa; 0 has exponent 0.
[[nodiscard]] Dyadic to_dyadic(double value);

[[nodiscard]] Dyadic operator*(const Dyadic& left, const Dyadic& right);
[[nodiscard]] Dyadic operator+(const Dyadic& left, const Dyadic& right);
[[nodiscard]] Dyadic operator-(const Dyadic& left, const Dyadic& right);

/// The finite double that is nearest to (numerator / denominator) 2^exponent, to even from the
/// middle between two; the denominator is not 0. So denormal values land on their coarser grid, and
/// what lies beyond the largest finite double becomes that, with its sign: there is no infinity.
/// A zero result is +0.
[[nodiscard]] double
nearest_double(const ExactInt& numerator, const ExactInt& denominator, int exponent);

/// A body's map to the world, times its own norm: x' = (linear x + translation) / norm. A matrix
/// has norm 1, a quaternion q has q.q.
struct ExactPose {
    std::array<std::array<Dyadic, 3>, 3> linear;
    std::array<Dyadic, 3> translation;
    Dyadic norm{1, 0};
};

[[nodiscard]] ExactPose to_exact(const Pose& pose);

} // namespace cd
