#include "common/solid/posed_triangle.hpp"

#include "common/solid/exact_double.hpp"
#include "common/solid/posed_point.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// A vector without its component `drop`. The cross product of two such vectors is the component
/// `drop` of the cross product in space.
struct Planar {
    double x;
    double y;

    Planar(const Vec3& v, std::size_t drop)
        : x(v[static_cast<Eigen::Index>((drop + 1) % 3)]),
          y(v[static_cast<Eigen::Index>((drop + 2) % 3)]) {}

    [[nodiscard]] double size() const { return std::max(std::abs(x), std::abs(y)); }
};

double cross(const Planar& l, const Planar& r) {
    return l.x * r.y - l.y * r.x;
}

Dyadic cross(const DyadicVec& l, const DyadicVec& r, std::size_t drop) {
    const std::size_t i = (drop + 1) % 3;
    const std::size_t j = (drop + 2) % 3;
    return l[i] * r[j] - l[j] * r[i];
}

using ExactDoubles = std::array<ExactDouble, 3>;

ExactDoubles difference(const Vec3& l, const Vec3& r) {
    return {ExactDouble{l.x()} - ExactDouble{r.x()},
            ExactDouble{l.y()} - ExactDouble{r.y()},
            ExactDouble{l.z()} - ExactDouble{r.z()}};
}

ExactDouble cross(const ExactDoubles& l, const ExactDoubles& r, std::size_t drop) {
    const std::size_t i = (drop + 1) % 3;
    const std::size_t j = (drop + 2) % 3;
    return l[i] * r[j] - l[j] * r[i];
}

/// Bounds the error of `cross` for two rounded differences with components of at most `l` and `r`,
/// whose terms err by `error`. The differences, the products and the last difference round: 4 u of
/// two products to first order, each at most l r; the terms move a product by 2 error (l + r + 2
/// error).
double cross_error(double l, double r, double error) {
    return 16 * unit_roundoff * l * r + 5 * error * (l + r + 2 * error) + 0x1p-1000;
}

} // namespace

PosedTriangle::PosedTriangle(const ExactFrame& frame,
                             const RelativePose& inner_to_outer,
                             const Corners& corners)
    : frame_(frame), inner_(corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        const RoundedPoint corner = posed(inner_to_outer, corners[i]);
        rounded_[i] = corner.value;
        // With a bound that is not finite, doubles prove nothing and exact numbers decide.
        error_ = corner.error > error_ || !std::isfinite(corner.error) ? corner.error : error_;
    }
    choose_projection();
}

void PosedTriangle::choose_projection() {
    const Vec3 edge_1 = rounded_[1] - rounded_[0];
    const Vec3 edge_2 = rounded_[2] - rounded_[0];
    const Vec3 normal = edge_1.cross(edge_2);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    const double error =
        cross_error(edge_1.cwiseAbs().maxCoeff(), edge_2.cwiseAbs().maxCoeff(), error_);
    if (const auto sign = proven_sign(normal[largest], error)) {
        drop_ = static_cast<std::size_t>(largest);
        orientation_ = *sign;
        return;
    }
    const DyadicVec exact = exact_normal();
    for (std::size_t i = 0; i < 3 && drop_ == 3; ++i) {
        if (sign_of(exact[i]) != 0) {
            drop_ = i;
            orientation_ = sign_of(exact[i]);
        }
    }
}

const std::array<DyadicVec, 3>& PosedTriangle::exact_corners() {
    if (!exact_) {
        exact_ = {
            frame_.of_inner(inner_[0]), frame_.of_inner(inner_[1]), frame_.of_inner(inner_[2])};
    }
    return *exact_;
}

DyadicVec PosedTriangle::exact_normal() {
    if (!exact_normal_) {
        const auto& c = exact_corners();
        exact_normal_ = cross(c[1] - c[0], c[2] - c[0]);
    }
    return *exact_normal_;
}

bool PosedTriangle::is_rounding_exact() {
    if (!is_rounding_exact_) {
        const auto& exact = exact_corners();
        is_rounding_exact_ = true;
        for (std::size_t i = 0; i < 3; ++i) {
            is_rounding_exact_ = *is_rounding_exact_ && rounded_[i].allFinite() &&
                                 is_zero(frame_.of_outer(rounded_[i]) - exact[i]);
        }
    }
    return *is_rounding_exact_;
}

std::optional<int> PosedTriangle::proven_plane_side(const Vec3& point) const {
    return proven_volume_sign({rounded_[0] - point, rounded_[1] - point, rounded_[2] - point},
                              error_);
}

int PosedTriangle::forward(const Vec3& direction) {
    const Vec3 edge_1 = rounded_[1] - rounded_[0];
    const Vec3 edge_2 = rounded_[2] - rounded_[0];
    // `error` bounds the error of each component of the normal, plus the rounding of the dot
    // product.
    const double largest = edge_1.cwiseAbs().maxCoeff() * edge_2.cwiseAbs().maxCoeff();
    const double error =
        cross_error(edge_1.cwiseAbs().maxCoeff(), edge_2.cwiseAbs().maxCoeff(), error_) +
        16 * unit_roundoff * largest;
    if (const auto sign = proven_sign(direction.dot(edge_1.cross(edge_2)),
                                      1.01 * direction.cwiseAbs().sum() * error)) {
        return *sign;
    }
    return sign_of(dot(to_dyadic(direction), exact_normal()));
}

int PosedTriangle::plane_side(const Vec3& point) {
    if (const auto sign = proven_plane_side(point)) {
        return *sign;
    }
    if (is_rounding_exact()) {
        const ExactDoubles from = difference(rounded_[0], point);
        const ExactDoubles edge_1 = difference(rounded_[1], rounded_[0]);
        const ExactDoubles edge_2 = difference(rounded_[2], rounded_[0]);
        const ExactDouble volume = from[0] * cross(edge_1, edge_2, 0) +
                                   from[1] * cross(edge_1, edge_2, 1) +
                                   from[2] * cross(edge_1, edge_2, 2);
        if (const auto sign = volume.sign()) {
            return *sign;
        }
    }
    return sign_of(dot(exact_normal(), exact_corners()[0] - frame_.of_outer(point)));
}

std::optional<int> PosedTriangle::proven_edge_side(std::size_t k, const Vec3& point) const {
    const Planar edge(rounded_[(k + 1) % 3] - rounded_[k], drop_);
    const Planar to_point(point - rounded_[k], drop_);
    const auto sign =
        proven_sign(cross(edge, to_point), cross_error(edge.size(), to_point.size(), error_));
    return sign ? std::optional(*sign * orientation_) : std::nullopt;
}

int PosedTriangle::edge_side(std::size_t k, const Vec3& point) {
    if (const auto sign = proven_edge_side(k, point)) {
        return *sign;
    }
    if (is_rounding_exact()) {
        const auto sign = cross(difference(rounded_[(k + 1) % 3], rounded_[k]),
                                difference(point, rounded_[k]),
                                drop_)
                              .sign();
        if (sign) {
            return orientation_ * *sign;
        }
    }
    const auto& c = exact_corners();
    const DyadicVec to_point = frame_.of_outer(point) - c[k];
    return orientation_ * sign_of(cross(c[(k + 1) % 3] - c[k], to_point, drop_));
}

int PosedTriangle::line_side(const Vec3& from, const Vec3& to, std::size_t k) {
    const Planar line(to - from, drop_);
    const Planar to_corner(rounded_[k] - from, drop_);
    const double error = cross_error(line.size(), to_corner.size(), error_);
    if (const auto sign = proven_sign(cross(line, to_corner), error)) {
        return *sign;
    }
    if (is_rounding_exact()) {
        const auto sign = cross(difference(to, from), difference(rounded_[k], from), drop_).sign();
        if (sign) {
            return *sign;
        }
    }
    const DyadicVec origin = frame_.of_outer(from);
    return sign_of(cross(frame_.of_outer(to) - origin, exact_corners()[k] - origin, drop_));
}

int PosedTriangle::winding(const Corners& coplanar) const {
    // The normals are parallel, so one nonzero component decides.
    const Planar edge_1(coplanar[1] - coplanar[0], drop_);
    const Planar edge_2(coplanar[2] - coplanar[0], drop_);
    if (const auto sign =
            proven_sign(cross(edge_1, edge_2), cross_error(edge_1.size(), edge_2.size(), 0))) {
        return *sign * orientation_;
    }
    const DyadicVec origin = to_dyadic(coplanar[0]);
    return orientation_ *
           sign_of(cross(to_dyadic(coplanar[1]) - origin, to_dyadic(coplanar[2]) - origin, drop_));
}

SolidPoint PosedTriangle::centroid() {
    double size = 0;
    for (const Vec3& corner : rounded_) {
        size = std::max(size, corner.cwiseAbs().maxCoeff());
    }
    return {(rounded_[0] + rounded_[1] + rounded_[2]) / 3,
            1.01 * error_ + 8 * unit_roundoff * size + 0x1p-1000,
            [this] {
                const auto& c = exact_corners();
                return ExactPoint{c[0] + c[1] + c[2], Dyadic{3, 0} * frame_.scale()};
            }};
}

} // namespace cd
