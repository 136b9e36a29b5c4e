#include "common/motion/motion_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double more_than_relative_errors = 1 + 0x1p-40;
constexpr double rounding_of_products = 0x1p-40;
constexpr double more_than_underflow = 0x1p-500;

// Eigen leaves the order of sums to the target, so these have their own.

double dot(const Vec3& l, const Vec3& r) {
    return (l.x() * r.x() + l.y() * r.y()) + l.z() * r.z();
}

double length(const Vec3& v) {
    return std::sqrt(dot(v, v));
}

Vec3 cross(const Vec3& l, const Vec3& r) {
    return {l.y() * r.z() - l.z() * r.y(),
            l.z() * r.x() - l.x() * r.z(),
            l.x() * r.y() - l.y() * r.x()};
}

Quaternion minus(const Quaternion& l, const Quaternion& r) {
    return {l.w - r.w, l.x - r.x, l.y - r.y, l.z - r.z};
}

/// Returns the vector part of l conj(r).
Vec3 vector_of_product(const Quaternion& l, const Quaternion& r) {
    return {((l.x * r.w - l.w * r.x) - l.y * r.z) + l.z * r.y,
            ((l.y * r.w - l.w * r.y) - l.z * r.x) + l.x * r.z,
            ((l.z * r.w - l.w * r.z) - l.x * r.y) + l.y * r.x};
}

/// How a body turns in a cell; angles in radians for all of the motion's time.
struct Turning {
    Vec3 omega;           ///< Angular velocity at the cell's middle.
    double omega_max = 0; ///< Bounds |omega| in the cell.
    double eps = 0;       ///< Bounds how far |omega| is from its value at the middle.
    double scale = 0;     ///< O, a bound of |omega| that errors are relative to.
};

Turning turning_in(const TimeCell& cell, const BodyPath& path) {
    const double h = cell.half_width();
    const Quaternion q = pose_at(path, cell.middle()).quaternion();
    const Quaternion rate = minus(path.q1, path.q0);
    const double rate_square = dot(rate, rate);
    if (rate_square == 0) {
        return {Vec3::Zero()};
    }
    const double n = dot(q, q);
    const double slope = std::abs(2 * dot(q, rate));
    const bool is_lowest_inside = slope <= 2 * rate_square * h;
    const double n_low = is_lowest_inside ? n - slope * slope / (4 * rate_square)
                                          : n - h * (slope - h * rate_square);
    const Vec3 w = vector_of_product(rate, path.q0);
    const double w_length = length(w);
    return {w * (2 / n),
            2 * w_length / n_low,
            2 * w_length * h * (slope + h * rate_square) / (n_low * n),
            4 * std::sqrt(rate_square) / n_low};
}

/// How the bodies move against each other in a cell.
struct RelativeMotion {
    double h;
    Vec3 rate;     ///< D'.
    Vec3 distance; ///< D at the cell's middle.
};

double bound_in_world(const RelativeMotion& motion,
                      const Turning& a,
                      const Turning& b,
                      const BodyRadii& radii) {
    const double speed = length(motion.rate) + (a.omega_max * radii.a + b.omega_max * radii.b);
    const double rounding = rounding_of_products * (a.scale * radii.a + b.scale * radii.b);
    return motion.h * (more_than_relative_errors * speed + rounding + more_than_underflow);
}

/// Returns the bound in the frame of a body that turns as `own`, for the points of the other body
/// with this radius.
double bound_in_frame(const RelativeMotion& motion,
                      const Turning& own,
                      const Turning& other,
                      double radius) {
    const double far = length(motion.distance);
    const double drift = motion.h * length(motion.rate);
    const Vec3 carried = cross(own.omega, motion.distance);
    const double speed = length(motion.rate - carried) + own.eps * (far + drift) +
                         length(own.omega) * drift +
                         (length(other.omega - own.omega) + (own.eps + other.eps)) * radius;
    const double rounding = rounding_of_products * (own.scale + other.scale) * (far + radius);
    return motion.h * (more_than_relative_errors * speed + rounding + more_than_underflow);
}

} // namespace

double TimeCell::middle() const {
    return std::ldexp(2.0 * index + 1, -static_cast<int>(level) - 1);
}

double TimeCell::half_width() const {
    return std::ldexp(1.0, -static_cast<int>(level) - 1);
}

double body_radius(std::span<const Vec3> vertices) {
    double radius = 0;
    for (const Vec3& vertex : vertices) {
        if (vertex != Vec3::Zero()) {
            radius = std::max({radius, 0x1p-500, length(vertex)});
        }
    }
    return radius * (1 + 0x1p-51);
}

double cell_bound(const BodyPath& a,
                  const BodyPath& b,
                  const BodyRadii& radii,
                  const TimeCell& cell,
                  double bound_of_parent) {
    const double tau = cell.middle();
    const RelativeMotion motion{cell.half_width(),
                                Vec3(b.c1 - b.c0) - Vec3(a.c1 - a.c0),
                                pose_at(b, tau).translation() - pose_at(a, tau).translation()};
    const Turning of_a = turning_in(cell, a);
    const Turning of_b = turning_in(cell, b);
    double bound = 0.5 * bound_of_parent;
    for (const double each : {bound_in_world(motion, of_a, of_b, radii),
                              bound_in_frame(motion, of_a, of_b, radii.b),
                              bound_in_frame(motion, of_b, of_a, radii.a)}) {
        bound = each < bound ? each : bound; // Never NaN.
    }
    return bound;
}

double movement_bound(const BodyPath& path, double radius) {
    // The bound in the world of this body and a point at rest.
    const TimeCell whole;
    const RelativeMotion motion{whole.half_width(), path.c1 - path.c0, Vec3::Zero()};
    const double bound =
        bound_in_world(motion, turning_in(whole, path), {Vec3::Zero()}, {radius, 0});
    return std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound;
}

} // namespace cd
