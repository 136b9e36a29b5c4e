// Bounds, with u = 2^-53. A computed vector x has sizes X with |x_k| <= X_k and errors of at most
// 2.01 u X_k: a difference of two doubles is rounded once, so that X_k = |x_k| does (and X_k = 0
// says that the true component is 0); an error of up to e makes it X_k = |x_k| + e / 2u.
//
// A determinant of x, y, z is a sum of six products x_i y_j z_k; its permanent P is the same sum of
// X_i Y_j Z_k. Errors of the input change it by at most ((1 + 2.01 u)^3 - 1) P <= 6.1 u P, where
// the true components are bounded by (1 + 2.01 u) X_k too. Arithmetic: each term goes through one
// rounding in its cross product's products, one in the difference, one in the product with the
// third vector and two in the sum of three: 5.1 u P. The computed permanent may be 6 u of itself
// too small. So 12 u P bounds the error; likewise 8 u P for determinants of two rows: 4.1 u from
// the input and two roundings.
//
// Underflow: a product loses at most 2^-1075. In a cross product's component that is 2^-1074, which
// is then multiplied with a component of z; products and sums lose little more, and the permanent
// no more than that. 2^-1000 (1 + |z_1| + |z_2| + |z_3|) covers it all, with sizes for components.
// Overflow makes infinities or NaN, of which no comparison proves anything: a value that is
// infinite comes with a permanent that is.
//
// Zeros: a permanent that is 0 has a true factor 0 in each term, unless something underflowed,
// which sizes of 0 or of 2^-300 and more rule out. Then the determinant is 0, and that is proven.
// On designed parts, whose faces follow the axes, most ties are seen like this.
#include "common/geometry/double_triangle_pair.hpp"

#include "common/geometry/double_double.hpp"
#include "common/geometry/plain_poses.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff.
constexpr double underflow = 0x1p-1000;
constexpr double volume_bound = 12 * u;
constexpr double area_bound = 8 * u;

double largest_of(const Vec3& v) {
    return std::max(std::max(std::abs(v.x()), std::abs(v.y())), std::abs(v.z()));
}

Vec3 times(const Mat3& m, const Vec3& x) {
    return {m(0, 0) * x.x() + m(0, 1) * x.y() + m(0, 2) * x.z(),
            m(1, 0) * x.x() + m(1, 1) * x.y() + m(1, 2) * x.z(),
            m(2, 0) * x.x() + m(2, 1) * x.y() + m(2, 2) * x.z()};
}

Vec3 sizes_of(const Vec3& v) {
    return {std::abs(v.x()), std::abs(v.y()), std::abs(v.z())};
}

/// The cross product, and for sizes the sums of the sizes of its terms.
RoundedVec cross(const RoundedVec& l, const RoundedVec& r) {
    const Vec3& x = l.value;
    const Vec3& y = r.value;
    const Vec3& s = l.size;
    const Vec3& t = r.size;
    return {{x.y() * y.z() - x.z() * y.y(),
             x.z() * y.x() - x.x() * y.z(),
             x.x() * y.y() - x.y() * y.x()},
            {s.y() * t.z() + s.z() * t.y(),
             s.z() * t.x() + s.x() * t.z(),
             s.x() * t.y() + s.y() * t.x()}};
}

double dot(const Vec3& l, const Vec3& r) {
    return l.x() * r.x() + l.y() * r.y() + l.z() * r.z();
}

bool cannot_underflow(double size) {
    return size == 0 || size >= 0x1p-300;
}

bool cannot_underflow(const RoundedVec& v) {
    return cannot_underflow(v.size.x()) && cannot_underflow(v.size.y()) &&
           cannot_underflow(v.size.z());
}

/// x . z for a cross product x, without the proof that it is 0.
int volume_sign(const RoundedVec& x, const RoundedVec& z, double scale, double& permanent) {
    const double value = dot(x.value, z.value);
    permanent = dot(x.size, z.size);
    const double bound =
        scale * volume_bound * permanent + underflow * (1 + z.size.x() + z.size.y() + z.size.z());
    return value > bound ? 1 : value < -bound ? -1 : unknown_sign;
}

} // namespace

RoundedRotation::RoundedRotation(const Pose& pose)
    : matrix(pose.rotation()),
      entry_error(pose.rotation_error()),
      entry_largest(matrix.cwiseAbs().maxCoeff() + entry_error),
      is_identity(entry_error == 0 && matrix == Mat3::Identity()) {}

RoundedPoses::RoundedPoses(const PosePair& poses)
    : a(poses.a),
      b(poses.b),
      translation_a(poses.a.translation()),
      translation_b(poses.b.translation()),
      offset(translation_a - translation_b),
      are_unrotated(a.is_identity && permutes_axes(poses.b)),
      are_unmoved(are_unrotated && translation_a == translation_b) {}

DoubleSigns::DoubleSigns(const RoundedPoses& poses,
                         const Corners& a,
                         const Corners& b,
                         double bound_scale)
    : poses_(poses), a_(a), b_(b), scale_(bound_scale) {
    if (!poses_.are_unrotated) {
        rotate();
    } else if (!poses_.b.is_identity) {
        for (Vec3& corner : b_) {
            corner = times(poses_.b.matrix, corner);
        }
    }
}

/// R x for components within `relative` of themselves. Each of three products is off by that and by
/// the entry's error, and goes through three roundings.
DoubleSigns::Rotated
DoubleSigns::rotated(const RoundedRotation& rotation, const Vec3& x, double relative) {
    const double reach = largest_of(x);
    if (rotation.is_identity) {
        return {x, relative * reach};
    }
    const double error =
        3.01 * reach * (rotation.entry_error + rotation.entry_largest * (relative + 4 * u));
    return {times(rotation.matrix, x), error + underflow};
}

void DoubleSigns::rotate() {
    const Rotated a0 = rotated(poses_.a, a_[0], 0);
    const Rotated b0 = rotated(poses_.b, b_[0], 0);
    apart_.value = (b0.value - a0.value) - poses_.offset;
    // The offset's rounding, and one for each of the two sums.
    apart_.error = a0.error + b0.error +
                   2.01 * u *
                       (largest_of(a0.value) + largest_of(b0.value) + largest_of(poses_.offset) +
                        largest_of(apart_.value));
    from_first_[0] = from_first_[3] = {Vec3::Zero(), 0};
    for (std::size_t i = 1; i < 3; ++i) {
        // A difference of corners is rounded once.
        from_first_[i] = rotated(poses_.a, a_[i] - a_[0], u);
        from_first_[3 + i] = rotated(poses_.b, b_[i] - b_[0], u);
    }
}

RoundedVec DoubleSigns::between(std::size_t from, std::size_t to) const {
    if (!poses_.are_unrotated) {
        return between_posed(from, to);
    }
    if (!poses_.are_unmoved && (from < 3) != (to < 3)) {
        return between_moved(from, to);
    }
    const Vec3 value = corner(to) - corner(from);
    return {value, sizes_of(value)};
}

RoundedVec DoubleSigns::between_posed(std::size_t from, std::size_t to) const {
    const Rotated& start = from_first_[from];
    const Rotated& end = from_first_[to];
    Vec3 value = end.value - start.value;
    double error = start.error + end.error;
    if (from < 3 && to >= 3) {
        error += apart_.error + u * largest_of(value);
        value += apart_.value;
    } else if (from >= 3 && to < 3) {
        error += apart_.error + u * largest_of(value);
        value -= apart_.value;
    }
    // The last sum is rounded as any difference is.
    const double added = 1.01 * error / (2 * u);
    return {value, sizes_of(value) + Vec3(added, added, added)};
}

/// Between bodies that are moved without rotation: x + t is held exactly in two doubles, and so is
/// the difference of the high ones, h + e. With l the difference of the low ones, rounded once, and
/// e + l rounded once when neither is 0, the result is off by at most u (|l| + |e + l|) and its own
/// rounding. Corners that are nominally on one height have h = e = l = 0 there.
RoundedVec DoubleSigns::between_moved(std::size_t from, std::size_t to) const {
    const Vec3& from_offset = from < 3 ? poses_.translation_a : poses_.translation_b;
    const Vec3& to_offset = to < 3 ? poses_.translation_a : poses_.translation_b;
    RoundedVec between;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble start = exact_sum(corner(from)[k], from_offset[k]);
        const DoubleDouble end = exact_sum(corner(to)[k], to_offset[k]);
        const DoubleDouble high = exact_sum(end.high, -start.high);
        const double low = end.low - start.low;
        const double value = high.high + (high.low + low);
        between.value[k] = value;
        between.size[k] = std::abs(value) + std::abs(low) + (low == 0 ? 0 : std::abs(high.low));
    }
    return between;
}

PlaneSides DoubleSigns::sides_of_a() const {
    const RoundedVec r = between(3, 4);
    const RoundedVec s = between(3, 5);
    const RoundedVec normal = cross(r, s);
    PlaneSides sides{};
    for (std::size_t i = 0; i < 3; ++i) {
        const RoundedVec to_corner = between(3, i);
        double permanent = 0;
        sides[i] = volume_sign(normal, to_corner, scale_, permanent);
        if (permanent == 0 && cannot_underflow(r) && cannot_underflow(s) &&
            cannot_underflow(to_corner)) {
            sides[i] = 0;
        }
    }
    return sides;
}

PlaneSides DoubleSigns::sides_of_b() const {
    const RoundedVec p = between(0, 1);
    const RoundedVec q = between(0, 2);
    const RoundedVec normal = cross(p, q);
    PlaneSides sides{};
    for (std::size_t i = 0; i < 3; ++i) {
        const RoundedVec to_corner = between(0, 3 + i);
        double permanent = 0;
        sides[i] = volume_sign(normal, to_corner, scale_, permanent);
        if (permanent == 0 && cannot_underflow(p) && cannot_underflow(q) &&
            cannot_underflow(to_corner)) {
            sides[i] = 0;
        }
    }
    return sides;
}

int DoubleSigns::edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const {
    // det(i' - i, j - i, j' - i) = det(i' - i, j - i, j' - j).
    const RoundedVec along_a = between(i, i_to);
    const RoundedVec across = between(i, j);
    const RoundedVec along_b = between(j, j_to);
    double permanent = 0;
    const int sign = volume_sign(cross(along_a, across), along_b, scale_, permanent);
    const bool is_zero = permanent == 0 && cannot_underflow(along_a) && cannot_underflow(across) &&
                         cannot_underflow(along_b);
    return is_zero ? 0 : sign;
}

int DoubleSigns::turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const {
    const RoundedVec along = between(i, j);
    const RoundedVec aside = between(i, k);
    const int x = static_cast<int>((axis + 1) % 3);
    const int y = static_cast<int>((axis + 2) % 3);
    const double value = along.value[x] * aside.value[y] - along.value[y] * aside.value[x];
    const double permanent = along.size[x] * aside.size[y] + along.size[y] * aside.size[x];
    const double bound = scale_ * area_bound * permanent + underflow;
    if (permanent == 0 && cannot_underflow(along) && cannot_underflow(aside)) {
        return 0;
    }
    return value > bound ? 1 : value < -bound ? -1 : unknown_sign;
}

int DoubleSigns::difference(std::size_t i, std::size_t j, std::size_t axis) const {
    const RoundedVec apart = between(j, i);
    const double value = apart.value[static_cast<int>(axis)];
    const double size = apart.size[static_cast<int>(axis)];
    const double bound = scale_ * 2.01 * u * size;
    return size == 0 ? 0 : value > bound ? 1 : value < -bound ? -1 : unknown_sign;
}

DoubleTrianglePair::DoubleTrianglePair(const PosePair& poses, double bound_scale)
    : poses_(plain_poses(poses)), bound_scale_(bound_scale) {}

DoubleSigns DoubleTrianglePair::signs(const Corners& a, const Corners& b) const {
    return {poses_, a, b, bound_scale_};
}

std::optional<PairClass> DoubleTrianglePair::classify(const Corners& a, const Corners& b) const {
    const DoubleSigns in_double = signs(a, b);
    ProvenSigns proven(in_double);
    const PairClass kind = decide_pair(proven);
    return proven.are_enough() ? std::optional(kind) : std::nullopt;
}

} // namespace cd
