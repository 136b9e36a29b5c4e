#include "common/motion/motion_keys.hpp"

#include "common/core/errors.hpp"
#include "common/motion/key_grid.hpp"
#include "common/motion/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace cd {

namespace {

using Components = std::array<double, 4>; ///< w, x, y, z.

/// Divides a quaternion by its length, with a few roundings. An exact power of two scales it first,
/// so that no square overflows or vanishes.
Quaternion unit(const Components& q) {
    double largest = 0;
    for (const double x : q) {
        largest = std::max(largest, std::abs(x));
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    Components scaled{};
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        scaled[i] = std::ldexp(q[i], -exponent);
        square += scaled[i] * scaled[i];
    }
    const double length = std::sqrt(square);
    return {scaled[0] / length, scaled[1] / length, scaled[2] / length, scaled[3] / length};
}

/// Returns the quaternion of a rotation, multiplied by four times its largest component, so that
/// nothing cancels. Shepperd, Quaternion from Rotation Matrix (1978).
Components quaternion_of(const Mat3& m) {
    const double x = m(0, 0);
    const double y = m(1, 1);
    const double z = m(2, 2);
    const double trace = x + y + z;
    if (trace >= x && trace >= y && trace >= z) {
        return {1 + trace, m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
    }
    if (x >= y && x >= z) {
        return {m(2, 1) - m(1, 2), 1 + x - y - z, m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)};
    }
    if (y >= z) {
        return {m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), 1 - x + y - z, m(1, 2) + m(2, 1)};
    }
    return {m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), 1 - x - y + z};
}

double frobenius(const Mat3& m) {
    double square = 0;
    for (int i = 0; i < 9; ++i) {
        square += m(i / 3, i % 3) * m(i / 3, i % 3);
    }
    return std::sqrt(square);
}

/// Returns all keys with quaternions of norm 1.
Result<std::vector<PosePair>> unit_keys(std::span<const PosePair> given, const NameKey& name) {
    std::vector<PosePair> keys;
    keys.reserve(given.size());
    for (const PosePair& pair : given) {
        const std::string place = name(keys.size()) + ": ";
        const Pose a = CD_TRY(within(place, unit_key(pair.a)));
        const Pose b = CD_TRY(within(place, unit_key(pair.b)));
        keys.push_back({a, b});
    }
    return keys;
}

/// Returns the largest depth of a motion from one key to the next.
Result<unsigned> largest_depth(std::span<const PosePair> keys,
                               const BodyRadii& radii,
                               double resolution,
                               const NameKey& name) {
    unsigned depth = 0;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const unsigned each = CD_TRY(
            within(name(i + 1) + ": ", motion_depth(keys[i], keys[i + 1], radii, resolution)));
        depth = std::max(depth, each);
    }
    return depth;
}

} // namespace

Result<Pose> unit_key(const Pose& given) {
    if (!given.is_finite()) {
        return bad_input("a key of a motion has a number that is not finite");
    }
    if (given.kind() == Pose::Kind::Quaternion) {
        const Quaternion& q = given.quaternion();
        return Pose::from_quaternion(unit({q.w, q.x, q.y, q.z}), given.translation());
    }
    const Components q = quaternion_of(given.matrix());
    const bool is_zero = std::ranges::all_of(q, [](double x) { return x == 0; });
    const Pose key = Pose::from_quaternion(is_zero ? Quaternion{} : unit(q), given.translation());
    if (!(frobenius(key.rotation() - given.matrix()) <= key_matrix_off_max)) {
        return bad_input("the matrix of a key is no rotation; motions are of rigid bodies");
    }
    return key;
}

double moved_at_most(const Pose& given, const Pose& rounded, double radius) {
    // Both rotations err by at most 16 u in an entry; 2^-46 covers these and the roundings here.
    const double turned = frobenius(rounded.rotation() - given.rotation()) + 0x1p-46;
    const Vec3 shift = rounded.translation() - given.translation(); // Exact.
    const double shifted = std::abs(shift.x()) + std::abs(shift.y()) + std::abs(shift.z());
    return (1 + 0x1p-40) * (turned * radius + shifted);
}

std::string name_of_key(std::size_t key) {
    return "key " + std::to_string(key);
}

Result<RoundedKeys> round_keys(std::span<const PosePair> given,
                               const BodyRadii& radii,
                               double resolution,
                               const NameKey& name) {
    const auto keys = CD_TRY(unit_keys(given, name));
    KeyGrid grid;
    for (const PosePair& pair : keys) {
        grid.exponent = std::max({grid.exponent,
                                  grid_exponent(pair.a.translation()),
                                  grid_exponent(pair.b.translation())});
    }
    RoundedKeys rounded;
    // The finest grid tells how coarse the grid must be. Rounding may change the depth again, but
    // hardly ever does; the rounds end at the largest depth.
    unsigned bits_needed = 1;
    while (rounded.bits < bits_needed) {
        grid.bits = bits_needed;
        rounded.bits = bits_needed;
        rounded.keys.clear();
        for (const PosePair& pair : keys) {
            rounded.keys.push_back({grid.rounded(pair.a), grid.rounded(pair.b)});
        }
        const unsigned depth = CD_TRY(largest_depth(rounded.keys, radii, resolution, name));
        bits_needed = depth + 1;
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
        const PosePair& to = rounded.keys[i];
        rounded.moved.a = std::max(rounded.moved.a, moved_at_most(given[i].a, to.a, radii.a));
        rounded.moved.b = std::max(rounded.moved.b, moved_at_most(given[i].b, to.b, radii.b));
    }
    return rounded;
}

} // namespace cd
