#include "common/pair/poses/plain_poses.hpp"

#include "common/pair/numbers/double_double.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cd {

namespace {

/// Returns M(q) / q.q if all entries are 0, 1 or -1. Then q has 1, 2 or 4 nonzero components of one
/// magnitude. (With three, entries are 2/3.)
std::optional<Mat3> permutation_of(const Quaternion& q) {
    const std::array<double, 4> sizes{std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)};
    const double largest = *std::max_element(sizes.begin(), sizes.end());
    int count = 0;
    for (const double size : sizes) {
        if (size != 0 && size != largest) {
            return std::nullopt;
        }
        count += size != 0 ? 1 : 0;
    }
    if (count == 3) {
        return std::nullopt;
    }
    // With their signs as components, the computation is exact, and q.q is 1, 2 or 4.
    const auto sign = [](double x) { return static_cast<double>((x > 0) - (x < 0)); };
    const Quaternion units{sign(q.w), sign(q.x), sign(q.y), sign(q.z)};
    return Pose::from_quaternion(units, Vec3::Zero()).rotation();
}

/// Returns the linear part if it only permutes and mirrors axes.
std::optional<Mat3> permutation_of(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return permutation_of(pose.quaternion());
    }
    const Mat3 sizes = pose.matrix().cwiseAbs();
    const bool permutes = ((sizes.array() == 0) || (sizes.array() == 1)).all() &&
                          (sizes.rowwise().sum().array() == 1).all() &&
                          (sizes.colwise().sum().array() == 1).all();
    return permutes ? std::optional(pose.matrix()) : std::nullopt;
}

/// Tests whether a pose is provably not singular: its |determinant| exceeds the possible error of
/// six products with at most five roundings each.
bool is_invertible(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return true;
    }
    const Mat3& m = pose.matrix();
    const Mat3 s = m.cwiseAbs();
    double permanent = 0;
    for (int k = 0; k < 3; ++k) {
        const int x = (k + 1) % 3;
        const int y = (k + 2) % 3;
        permanent += s(0, k) * (s(1, x) * s(2, y) + s(1, y) * s(2, x));
    }
    const double determinant = m.row(0).dot(m.row(1).cross(m.row(2)));
    return std::abs(determinant) > 0x1p-40 * permanent + 0x1p-900 && s.maxCoeff() < 0x1p100;
}

/// Returns l - r if no component rounds.
std::optional<Vec3> exact_difference(const Vec3& l, const Vec3& r) {
    Vec3 difference;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble sum = exact_sum(l[k], -r[k]);
        if (!(sum.low == 0)) { // The negation also catches NaN, after an overflow.
            return std::nullopt;
        }
        difference[k] = sum.high;
    }
    return difference;
}

/// Returns the numbers in units of 2^-digits times the power of two above the largest |number|;
/// nothing if one is not whole in this unit.
template <std::size_t n>
std::optional<std::array<double, n>> whole_numbers(const std::array<double, n>& numbers,
                                                   int digits) {
    double largest = 0;
    for (const double number : numbers) {
        largest = std::max(largest, std::abs(number));
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    if (std::abs(exponent) > 900) {
        return std::nullopt;
    }
    const double units = std::ldexp(1.0, digits - exponent);
    std::array<double, n> whole;
    for (std::size_t i = 0; i < n; ++i) {
        whole[i] = numbers[i] * units;
        if (whole[i] != std::trunc(whole[i])) {
            return std::nullopt;
        }
    }
    return whole;
}

/// Returns R^-1 d for a quaternion's rotation R = M / n, if doubles hold and compute it exactly.
/// Then R x + d = R (x + R^-1 d).
std::optional<Vec3> turned_back(const Quaternion& q, const Vec3& d) {
    // With components below 2^20, n and the entries of M are whole and below 2^43.
    const auto whole = whole_numbers(std::array{q.w, q.x, q.y, q.z}, 20);
    if (!whole) {
        return std::nullopt;
    }
    // In this range the rounding errors of products are doubles, too.
    for (const double component : {d.x(), d.y(), d.z()}) {
        if (component != 0 && !(std::abs(component) > 0x1p-800 && std::abs(component) < 0x1p800)) {
            return std::nullopt;
        }
    }
    const auto [w, x, y, z] = *whole;
    const double n = w * w + x * x + y * y + z * z;
    Mat3 transposed;
    transposed << w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y), //
        2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x),           //
        2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z;
    Vec3 turned;
    for (int row = 0; row < 3; ++row) {
        DoubleDouble sum;
        bool is_exact = true;
        for (int k = 0; k < 3; ++k) {
            const DoubleDouble product = exact_product(transposed(row, k), d[k]);
            const DoubleDouble next = exact_sum(sum.high, product.high);
            is_exact = is_exact && product.low == 0 && next.low == 0;
            sum = next;
        }
        turned[row] = sum.high / n;
        const DoubleDouble back = exact_product(turned[row], n);
        if (!is_exact || back.high != sum.high || back.low != 0) {
            return std::nullopt;
        }
    }
    return turned;
}

Pose with_translation(const Pose& pose, const Vec3& translation) {
    return pose.kind() == Pose::Kind::Matrix
               ? Pose::from_matrix(pose.matrix(), translation)
               : Pose::from_quaternion(pose.quaternion(), translation);
}

} // namespace

bool permutes_axes(const Pose& pose) {
    return permutation_of(pose).has_value();
}

bool is_short(const Pose& pose) {
    constexpr int digits = 12;
    if (pose.kind() == Pose::Kind::Quaternion) {
        const Quaternion& q = pose.quaternion();
        return whole_numbers(std::array{q.w, q.x, q.y, q.z}, digits).has_value();
    }
    std::array<double, 9> entries;
    std::copy_n(pose.matrix().data(), 9, entries.begin());
    return whole_numbers(entries, digits).has_value();
}

PosePair plain_poses(const PosePair& poses) {
    if (poses.a == poses.b && is_invertible(poses.a)) {
        return {};
    }
    PosePair plain = poses;
    if (poses.a.kind() == Pose::Kind::Quaternion && poses.b.kind() == Pose::Kind::Quaternion &&
        poses.a.quaternion() == poses.b.quaternion()) {
        if (const auto apart = exact_difference(poses.b.translation(), poses.a.translation())) {
            if (const auto turned = turned_back(poses.a.quaternion(), *apart)) {
                return {Pose(), Pose::from_matrix(Mat3::Identity(), *turned)};
            }
        }
    }
    if (const auto apart = exact_difference(poses.b.translation(), poses.a.translation())) {
        plain.a = with_translation(poses.a, Vec3::Zero());
        plain.b = with_translation(poses.b, *apart);
    }
    const std::optional<Mat3> a = permutation_of(plain.a);
    const std::optional<Mat3> b = permutation_of(plain.b);
    if (a && b) {
        // Undoing A's permutation is exact: products with 1 and -1 do not round.
        const Mat3 undone = a->transpose();
        return {Pose::from_matrix(Mat3::Identity(), undone * plain.a.translation()),
                Pose::from_matrix(undone * *b, undone * plain.b.translation())};
    }
    return plain;
}

} // namespace cd
