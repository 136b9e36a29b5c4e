// Bounds, with u = 2^-53 and e = 16 u^2. Low parts of numbers that are not normalised are bounded
// below, and terms of third order in u are far below the room that each step leaves.
//
// Corners: let M be the largest |entry| of R, or 1 for a quaternion's, times |x_1| + |x_2| + |x_3|,
// plus the largest |offset|; M is the larger of both bodies'. The products and sums of high parts
// are exact. They leave over at most u M for all products, u M for each of three sums, u M for the
// offset's low part and u M for the entries' low parts. These 6 u M are summed in ten roundings of
// at most 6 u^2 M. The products with low parts round by u^2 M, and the entries of a quaternion's
// matrix err by 10 e = 160 u^2. So a component errs by at most 221 u^2 M, and its low part is at
// most 6 u M. Differences: the high parts' difference is exact, with at most 2 u M left over. The
// low parts' difference is at most 12 u M and rounds by 12 u^2 M, and their sum by 14 u^2 M. The
// last sum is exact, so the result is normalised. With both corners: 468 u^2 M, below E = 30 e M.
//
// Determinants of x, y, z whose components, computed or true, are at most X, Y, Z, each of which is
// at least E: errors of the factors change each of six products by at most E (YZ + XZ + XY).
// Arithmetic of a 2 x 2 determinant: the high parts' products and their difference are exact, with
// 4 u XY left over; four products with low parts are u XY each. These 8 u XY are rounded by 4 u^2
// XY for the products with low parts and at most 8 u^2 XY for each of five sums. Low times low, 2
// u^2 XY, is omitted: 46 u^2 XY. Times z: the high parts' products and sums are exact and leave (6
// + 4 + 6) u XYZ; products with low parts are 8 u XYZ and 2 u XYZ for each component. These 46 u
// XYZ go through at most nine sums, 414 u^2 XYZ, and the products' own 30 u^2 XYZ. 24 u^2 XYZ are
// omitted, and three components bring 46 u^2 each: 606 u^2 = 38 e XYZ at most. As X is at most 2 M
// + 2 E < 2.01 M, that is below 2.6 E YZ. The last sum rounds its result relatively, which moves it
// past no bound by more than that. So 9 E (YZ + XZ + XY) bounds the error of a volume. An area errs
// by 2 E (X + Y) and 46 u^2 XY, below 0.2 E Y: 3 E (X + Y).
//
// Underflow: with M from 2^-200 to 2^200, E is at least 2^-298, and a volume's bound at least 9 E^2
// max(X, Y, Z). Products lose some multiples of 2^-1074, times one more factor at most: far less.
// If entries or corners are so large that splitting overflows, NaN results, and no comparison with
// it proves anything.
#include "common/pair/stages/double_double/double_double_triangle_pair.hpp"

#include "common/pair/stages/double/double_triangle_pair.hpp"
#include "common/pair/stages/float/plain_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double magnitude_least = 0x1p-200;
constexpr double magnitude_most = 0x1p200;

/// Returns the high half of the digits (Veltkamp's splitting).
BothBodies head_of(BothBodies x) {
    const BothBodies scaled = (0x1p27 + 1) * x;
    return scaled - (scaled - x);
}

/// Computes a d - b c, not normalised.
DoubleDouble determinant(const DoubleDouble& a,
                         const DoubleDouble& b,
                         const DoubleDouble& c,
                         const DoubleDouble& d) {
    const DoubleDouble left = exact_product(a.high, d.high);
    const DoubleDouble right = exact_product(b.high, c.high);
    const DoubleDouble high = exact_sum(left.high, -right.high);
    const double low = (a.high * d.low + a.low * d.high) - (b.high * c.low + b.low * c.high);
    return {high.high, (high.low + (left.low - right.low)) + low};
}

DoubleDoubleVec cross(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return {determinant(l[1], l[2], r[1], r[2]),
            determinant(l[2], l[0], r[2], r[0]),
            determinant(l[0], l[1], r[0], r[1])};
}

double dot(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    const DoubleDouble x = exact_product(l[0].high, r[0].high);
    const DoubleDouble y = exact_product(l[1].high, r[1].high);
    const DoubleDouble z = exact_product(l[2].high, r[2].high);
    const DoubleDouble xy = exact_sum(x.high, y.high);
    const DoubleDouble xyz = exact_sum(xy.high, z.high);
    const double low = ((l[0].high * r[0].low + l[0].low * r[0].high) +
                        (l[1].high * r[1].low + l[1].low * r[1].high)) +
                       (l[2].high * r[2].low + l[2].low * r[2].high);
    return xyz.high + (((xy.low + xyz.low) + ((x.low + y.low) + z.low)) + low);
}

int proven_sign(double value, double bound) {
    return value > bound ? 1 : value < -bound ? -1 : unknown_sign;
}

/// Returns a lower limit for the bound on |entries|: the errors of a quaternion's entries are
/// relative to 1.
double entry_least(const Pose& pose) {
    return pose.kind() == Pose::Kind::Quaternion ? 1 : 0;
}

double sum_of_sizes(const Vec3& x) {
    return std::abs(x.x()) + std::abs(x.y()) + std::abs(x.z());
}

} // namespace

DoubleDoublePoses::DoubleDoublePoses(const PosePair& poses)
    : largest_a(entry_least(poses.a)), largest_b(entry_least(poses.b)) {
    const DoubleDoubleMatrix a = double_double_rotation(poses.a);
    const DoubleDoubleMatrix b = double_double_rotation(poses.b);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const BothBodies high{a[i][j].high, b[i][j].high};
            const BothBodies head = head_of(high);
            rows[i][j] = {high, BothBodies{a[i][j].low, b[i][j].low}, head, high - head};
            largest_a = std::max(largest_a, std::abs(high[0]));
            largest_b = std::max(largest_b, std::abs(high[1]));
        }
        const auto axis = static_cast<Eigen::Index>(i);
        const DoubleDouble offset =
            exact_sum(poses.a.translation()[axis], -poses.b.translation()[axis]);
        offset_high[i] = BothBodies{offset.high, 0};
        offset_low[i] = BothBodies{offset.low, 0};
        offset_largest = std::max(offset_largest, std::abs(offset.high));
    }
}

DoubleDoubleSigns::DoubleDoubleSigns(const DoubleDoublePoses& poses,
                                     const Corners& a,
                                     const Corners& b,
                                     double bound_scale)
    : scale_(bound_scale) {
    double reach_a = 0;
    double reach_b = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        place(poses, a, b, i);
        reach_a = std::max(reach_a, sum_of_sizes(a[i]));
        reach_b = std::max(reach_b, sum_of_sizes(b[i]));
    }
    // The factor 1.01 covers the rounding of the bounds.
    const double magnitude = 1.01 * std::max(poses.largest_a * reach_a + poses.offset_largest,
                                             poses.largest_b * reach_b);
    const bool is_in_range = magnitude > magnitude_least && magnitude < magnitude_most;
    error_ = is_in_range ? 30 * double_double_error * magnitude
                         : std::numeric_limits<double>::infinity();
}

/// Computes R x + offset for corner i of both triangles.
void DoubleDoubleSigns::place(const DoubleDoublePoses& poses,
                              const Corners& a,
                              const Corners& b,
                              std::size_t i) {
    std::array<BothBodies, 3> x;
    std::array<BothBodies, 3> heads;
    std::array<BothBodies, 3> tails;
    for (std::size_t j = 0; j < 3; ++j) {
        const auto axis = static_cast<Eigen::Index>(j);
        x[j] = BothBodies{a[i][axis], b[i][axis]};
        heads[j] = head_of(x[j]);
        tails[j] = x[j] - heads[j];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        BothBodies high = poses.offset_high[k];
        BothBodies low = poses.offset_low[k];
        for (std::size_t j = 0; j < 3; ++j) {
            const DoubleDoublePoses::Entry& entry = poses.rows[k][j];
            const BothBodies product = entry.high * x[j];
            const BothBodies left_over =
                entry.tail * tails[j] - //
                (((product - entry.head * heads[j]) - entry.tail * heads[j]) -
                 entry.head * tails[j]);
            const two_doubles::Sums sum = two_doubles::exact_sums(high, product);
            high = sum.high;
            low += (sum.low + left_over) + entry.low * x[j];
        }
        corners_[i][k] = {high[0], low[0]};
        corners_[3 + i][k] = {high[1], low[1]};
    }
}

DoubleDoubleSigns::Sized DoubleDoubleSigns::between(std::size_t from, std::size_t to) const {
    Sized result;
    for (std::size_t k = 0; k < 3; ++k) {
        const DoubleDouble& start = corners_[from][k];
        const DoubleDouble& end = corners_[to][k];
        const DoubleDouble high = exact_sum(end.high, -start.high);
        result.value[k] = exact_sum(high.high, high.low + (end.low - start.low));
        result.size = std::max(result.size, std::abs(result.value[k].high));
    }
    result.size += error_;
    return result;
}

double DoubleDoubleSigns::volume_bound(const Sized& x, const Sized& y, const Sized& z) const {
    return scale_ * 9 * error_ * (x.size * y.size + y.size * z.size + z.size * x.size);
}

/// Stops at the first unproven sign: without it the other signs decide nothing.
PlaneSides
DoubleDoubleSigns::sides(PlaneSides known, std::size_t plane, std::size_t corners) const {
    if (!is_any_unknown(known)) {
        return known;
    }
    const Sized x = between(plane, plane + 1);
    const Sized y = between(plane, plane + 2);
    const DoubleDoubleVec normal = cross(x.value, y.value);
    for (std::size_t i = 0; i < 3; ++i) {
        if (known[i] == unknown_sign) {
            const Sized z = between(plane, corners + i);
            known[i] = proven_sign(dot(normal, z.value), volume_bound(x, y, z));
            if (known[i] == unknown_sign) {
                return known;
            }
        }
    }
    return known;
}

int DoubleDoubleSigns::edge_side(std::size_t i,
                                 std::size_t i_to,
                                 std::size_t j,
                                 std::size_t j_to) const {
    // det(i' - i, j - i, j' - i) = det(i' - i, j - i, j' - j).
    const Sized x = between(i, i_to);
    const Sized y = between(i, j);
    const Sized z = between(j, j_to);
    return proven_sign(dot(cross(x.value, y.value), z.value), volume_bound(x, y, z));
}

int DoubleDoubleSigns::turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const {
    const Sized x = between(i, j);
    const Sized y = between(i, k);
    const std::size_t first = (axis + 1) % 3;
    const std::size_t second = (axis + 2) % 3;
    const DoubleDouble value =
        determinant(x.value[first], x.value[second], y.value[first], y.value[second]);
    return proven_sign(value.high + value.low, scale_ * 3 * error_ * (x.size + y.size));
}

int DoubleDoubleSigns::difference(std::size_t i, std::size_t j, std::size_t axis) const {
    return proven_sign(between(j, i).value[axis].high, scale_ * 1.01 * error_);
}

DoubleDoubleTrianglePair::DoubleDoubleTrianglePair(const PosePair& poses, double bound_scale)
    : poses_(plain_poses(poses)), bound_scale_(bound_scale) {}

std::optional<PairClass> DoubleDoubleTrianglePair::classify(const Corners& a,
                                                            const Corners& b) const {
    const DoubleDoubleSigns signs(poses_, a, b, bound_scale_);
    ProvenSigns proven(signs);
    const PairClass kind = decide_pair(proven);
    return proven.are_enough() ? std::optional(kind) : std::nullopt;
}

} // namespace cd
