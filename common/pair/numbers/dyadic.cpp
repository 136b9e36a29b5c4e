#include "common/pair/numbers/dyadic.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cd {

namespace {

/// Rounds bits * 2^unit to the nearest finite double. `bits` must have at least 56 significant
/// bits.
double nearest_double(std::uint64_t bits, int unit) {
    constexpr int lowest_unit = -1074; // The unit of denormal numbers.
    const int dropped = std::max(static_cast<int>(std::bit_width(bits)) - 53, lowest_unit - unit);
    if (dropped >= 64) {
        return 0; // Less than half of the least denormal number.
    }
    const std::uint64_t step = std::uint64_t{1} << dropped;
    const std::uint64_t rest = bits & (step - 1);
    std::uint64_t kept = bits >> dropped;
    if (rest > step / 2 || (rest == step / 2 && kept % 2 == 1)) {
        ++kept;
    }
    const double value = std::ldexp(static_cast<double>(kept), unit + dropped);
    return std::min(value, std::numeric_limits<double>::max());
}

} // namespace

Dyadic to_dyadic(double value) {
    if (value == 0) {
        return {};
    }
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent); // In (-1, 1), 53 bits.
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    // Moves trailing zeros to the exponent, so that the numbers of designed parts, which lie on
    // grids, get short.
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {ExactInt(mantissa / (std::int64_t{1} << zeros)), exponent - 53 + zeros};
}

Dyadic operator*(const Dyadic& l, const Dyadic& r) {
    if (l.mantissa == 0 || r.mantissa == 0) {
        return {};
    }
    return {l.mantissa * r.mantissa, l.exponent + r.exponent};
}

Dyadic operator+(const Dyadic& l, const Dyadic& r) {
    if (l.mantissa == 0) {
        return r;
    }
    if (r.mantissa == 0) {
        return l;
    }
    const int exponent = std::min(l.exponent, r.exponent);
    return {(l.mantissa << (l.exponent - exponent)) + (r.mantissa << (r.exponent - exponent)),
            exponent};
}

Dyadic operator-(const Dyadic& l, const Dyadic& r) {
    return l + Dyadic{-r.mantissa, r.exponent};
}

double nearest_double(const ExactInt& numerator, const ExactInt& denominator, int exponent) {
    CD_CHECK(denominator != 0);
    if (numerator == 0) {
        return 0;
    }
    ExactInt n = abs(numerator);
    ExactInt d = abs(denominator);
    // The shift gives the quotient 55 or 56 bits: those of a double, and at least one more, which
    // tells in which half of a step the remainder lies.
    const int shift = 55 - (static_cast<int>(msb(n)) - static_cast<int>(msb(d)));
    shift >= 0 ? n <<= shift : d <<= -shift;
    ExactInt quotient;
    ExactInt rest;
    divide_qr(n, d, quotient, rest);
    // A sticky bit represents all following bits: a tie needs it to be 0.
    const std::uint64_t bits = 2 * quotient.convert_to<std::uint64_t>() + (rest != 0 ? 1u : 0u);
    const int unit = exponent - shift - 1;
    const double magnitude = nearest_double(bits, unit);
    return numerator.sign() == denominator.sign() ? magnitude : 0 - magnitude;
}

ExactPose to_exact(const Pose& pose) {
    ExactPose exact;
    for (int row = 0; row < 3; ++row) {
        exact.translation[static_cast<std::size_t>(row)] = to_dyadic(pose.translation()[row]);
    }
    if (pose.kind() == Pose::Kind::Matrix) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                exact.linear[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                    to_dyadic(pose.matrix()(row, column));
            }
        }
        return exact;
    }
    const Dyadic w = to_dyadic(pose.quaternion().w);
    const Dyadic x = to_dyadic(pose.quaternion().x);
    const Dyadic y = to_dyadic(pose.quaternion().y);
    const Dyadic z = to_dyadic(pose.quaternion().z);
    const Dyadic two{2, 0};
    exact.linear[0] = {w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)};
    exact.linear[1] = {two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)};
    exact.linear[2] = {two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z};
    exact.norm = w * w + x * x + y * y + z * z;
    for (Dyadic& component : exact.translation) {
        component = component * exact.norm;
    }
    return exact;
}

std::array<Dyadic, 3> scaled_world(const ExactPose& pose, const Vec3& point) {
    const std::array<Dyadic, 3> x{to_dyadic(point.x()), to_dyadic(point.y()), to_dyadic(point.z())};
    std::array<Dyadic, 3> result;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto& r = pose.linear[row];
        result[row] = r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + pose.translation[row];
    }
    return result;
}

ExactLattice to_lattice(const std::array<Dyadic, 18>& coordinates) {
    ExactLattice lattice;
    bool any = false;
    for (const Dyadic& value : coordinates) {
        if (value.mantissa != 0) {
            lattice.exponent = any ? std::min(lattice.exponent, value.exponent) : value.exponent;
            any = true;
        }
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const Dyadic& value = coordinates[i];
        if (value.mantissa != 0) {
            lattice.corners[i / 3][i % 3] = value.mantissa << (value.exponent - lattice.exponent);
        }
    }
    return lattice;
}

} // namespace cd
