#include "common/distance/stages/exact/exact_distance.hpp"

#include "common/core/check.hpp"
#include "common/distance/stages/exact/exact_features.hpp"
#include "common/distance/stages/exact/exact_optimum.hpp"
#include "common/pair/numbers/exact_lattice.hpp"
#include "common/pair/points/exact_points.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

namespace cd {

namespace {

__extension__ typedef unsigned __int128 Wide;

/// Returns the whole part of a square root.
std::uint64_t root_of(Wide square) {
    // Doubles are within 2^-52 of the root, relatively.
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(square)));
    while (Wide{root} * root > square) {
        --root;
    }
    while (Wide{root + 1} * (root + 1) <= square) {
        ++root;
    }
    return root;
}

ExactSquare least_square(const ExactLattice& lattice, std::size_t likely) {
    if (auto square = square_if_nearest(lattice.corners, likely)) {
        return *std::move(square);
    }
    return ExactFeatures(lattice.corners).least();
}

double rounded_of(const ExactSquare& square, const ExactLattice& lattice, const Dyadic& norm) {
    return nearest_root(
        square.n, square.d * norm.mantissa * norm.mantissa, lattice.exponent - norm.exponent);
}

Vec3 rounded_of(const ExactPlace& place, const ExactLattice& lattice, const Dyadic& norm) {
    const ExactInt denominator = place.w * norm.mantissa;
    Vec3 point;
    for (std::size_t k = 0; k < 3; ++k) {
        point[static_cast<Eigen::Index>(k)] =
            nearest_double(place.x[k], denominator, lattice.exponent - norm.exponent);
    }
    return point;
}

} // namespace

ExactDistance::ExactDistance(const PosePair& poses)
    : poses_(poses), a_(to_exact(poses.a)), b_(to_exact(poses.b)), norm_(a_.norm * b_.norm) {}

Vec3 ExactDistance::nearby(const Corners& a) const {
    const Vec3 corner = poses_.a.apply(a[0]);
    return corner.allFinite() ? corner : Vec3::Zero();
}

bool ExactDistance::is_within(const Corners& a,
                              const Corners& b,
                              double d,
                              std::size_t likely) const {
    const ExactLattice lattice = exact_lattice(a_, a, b_, b, nearby(a));
    const ExactSquare square = least_square(lattice, likely);
    // Compares n / d' with the square of d in units of the lattice, which are scaled by the norm.
    const Dyadic bound = to_dyadic(d) * norm_;
    const int shift = 2 * (bound.exponent - lattice.exponent);
    ExactInt left = square.n;
    ExactInt right = bound.mantissa * bound.mantissa * square.d;
    shift >= 0 ? right <<= shift : left <<= -shift;
    return left <= right;
}

double ExactDistance::rounded(const Corners& a, const Corners& b, std::size_t likely) const {
    const ExactLattice lattice = exact_lattice(a_, a, b_, b, nearby(a));
    return rounded_of(least_square(lattice, likely), lattice, norm_);
}

NearestPoints ExactDistance::nearest(const Corners& a, const Corners& b, std::size_t likely) const {
    NearestPoints points;
    points.origin = ExactPoints(poses_).origin(a);
    const ExactLattice lattice = exact_lattice(a_, a, b_, b, points.origin);
    const ExactFeatures features(lattice.corners);
    const double least = rounded_of(least_square(lattice, likely), lattice, norm_);
    std::size_t number = 0;
    for (; number < feature::count; ++number) {
        const auto square = features.square(number);
        if (square && rounded_of(*square, lattice, norm_) == least) {
            break;
        }
    }
    CD_CHECK(number < feature::count);
    const auto places = features.places(number);
    points.of_a = rounded_of(places[0], lattice, norm_);
    points.of_b = rounded_of(places[1], lattice, norm_);
    points.feature = static_cast<std::uint8_t>(number);
    return points;
}

double nearest_root(const ExactInt& n, const ExactInt& d, int exponent) {
    if (n == 0) {
        return 0;
    }
    // The even shift gives the quotient 111 to 113 bits, and its root 56 or 57: those of a double,
    // and at least two more.
    int shift = 111 - (static_cast<int>(msb(n)) - static_cast<int>(msb(d)));
    shift += shift & 1;
    ExactInt dividend = n;
    ExactInt divisor = d;
    shift >= 0 ? dividend <<= shift : divisor <<= -shift;
    ExactInt quotient;
    ExactInt rest;
    divide_qr(dividend, divisor, quotient, rest);
    const Wide square = (Wide{ExactInt(quotient >> 64).convert_to<std::uint64_t>()} << 64) +
                        ExactInt(quotient & ~std::uint64_t{0}).convert_to<std::uint64_t>();
    const std::uint64_t root = root_of(square);
    // A sticky bit represents all following bits.
    const bool is_more = rest != 0 || Wide{root} * root != square;
    return nearest_double(2 * root + (is_more ? 1u : 0u), 1, exponent - shift / 2 - 1);
}

} // namespace cd
