#include "common/solid/exact_frame.hpp"

#include <Eigen/Geometry>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

DyadicVec column(const std::array<DyadicVec, 3>& rows, std::size_t i) {
    return {rows[0][i], rows[1][i], rows[2][i]};
}

} // namespace

DyadicVec to_dyadic(const Vec3& v) {
    return {to_dyadic(v.x()), to_dyadic(v.y()), to_dyadic(v.z())};
}

DyadicVec operator+(const DyadicVec& l, const DyadicVec& r) {
    return {l[0] + r[0], l[1] + r[1], l[2] + r[2]};
}

DyadicVec operator-(const DyadicVec& l, const DyadicVec& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

DyadicVec operator*(const Dyadic& factor, const DyadicVec& v) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}

DyadicVec cross(const DyadicVec& l, const DyadicVec& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

Dyadic dot(const DyadicVec& l, const DyadicVec& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

bool is_zero(const DyadicVec& v) {
    return v[0].mantissa == 0 && v[1].mantissa == 0 && v[2].mantissa == 0;
}

std::optional<int> proven_volume_sign(const std::array<Vec3, 3>& seen, double error) {
    const double size_0 = seen[0].cwiseAbs().maxCoeff();
    const double size_1 = seen[1].cwiseAbs().maxCoeff();
    const double size_2 = seen[2].cwiseAbs().maxCoeff();
    const double pairs = size_0 * size_1 + size_1 * size_2 + size_2 * size_0;
    const double sum = size_0 + size_1 + size_2 + error;
    // The determinant has six products of three, each at most size_0 size_1 size_2. The
    // differences, two products, a difference, a product and two sums round: 8 u to first order;
    // the bound takes twice that to cover higher orders. An error in each component moves a product
    // by error * pairs, and its powers by less.
    const double bound = 96 * unit_roundoff * size_0 * size_1 * size_2 +
                         8 * error * (pairs + error * sum) + 0x1p-1000 * (1 + sum);
    return proven_sign(seen[2].dot(seen[0].cross(seen[1])), bound);
}

ExactFrame::ExactFrame(const Pose& outer, const Pose& inner) {
    const ExactPose o = to_exact(outer);
    const ExactPose i = to_exact(inner);
    // With world = (L x + t) / n of either body, the inner point x lies at
    //     y = Lo^-1 ((no / ni) (Li x + ti) - to)
    // in outer's coordinates. The frame's coordinates are |det(Lo)| ni y. The adjugate adj(Lo),
    // whose rows are cross products of Lo's columns, replaces the inverse.
    std::array<DyadicVec, 3> adjugate{cross(column(o.linear, 1), column(o.linear, 2)),
                                      cross(column(o.linear, 2), column(o.linear, 0)),
                                      cross(column(o.linear, 0), column(o.linear, 1))};
    const Dyadic determinant = dot(adjugate[0], column(o.linear, 0));
    outer_orientation_ = sign_of(determinant);
    inner_orientation_ = sign_of(dot(cross(i.linear[0], i.linear[1]), i.linear[2]));
    const Dyadic sign{outer_orientation_, 0};
    scale_ = sign * determinant * i.norm;
    const DyadicVec offset = o.norm * i.translation - i.norm * o.translation;
    for (std::size_t row = 0; row < 3; ++row) {
        adjugate[row] = sign * adjugate[row];
        for (std::size_t k = 0; k < 3; ++k) {
            linear_[row][k] = o.norm * dot(adjugate[row], column(i.linear, k));
        }
        translation_[row] = dot(adjugate[row], offset);
    }
}

DyadicVec ExactFrame::of_inner(const Vec3& point) const {
    const DyadicVec x = to_dyadic(point);
    return DyadicVec{dot(linear_[0], x), dot(linear_[1], x), dot(linear_[2], x)} + translation_;
}

DyadicVec ExactFrame::of_outer(const Vec3& point) const {
    return scale_ * to_dyadic(point);
}

} // namespace cd
