#include "tests/support/motion_oracle.hpp"

#include "common/core/check.hpp"

#include <cmath>

namespace cd::tests {

namespace {

/// Returns number * 2^bits, which must be an integer.
Integer as_integer(double number, int bits) {
    const double scaled = std::ldexp(number, bits);
    CD_CHECK(scaled == std::floor(scaled));
    return Integer(scaled);
}

ExactPoint as_integers(const Vec3& point) {
    return {as_integer(point.x(), 128), as_integer(point.y(), 128), as_integer(point.z(), 128)};
}

std::array<Integer, 4> as_integers(const Quaternion& q) {
    return {as_integer(q.w, 64), as_integer(q.x, 64), as_integer(q.y, 64), as_integer(q.z, 64)};
}

/// Returns n times the point turned by a quaternion, where n is the quaternion's square.
ExactPoint turned(const std::array<Integer, 4>& q, const Integer& n, const ExactPoint& p) {
    // Rodrigues: n p + 2 w (v x p) + 2 v x (v x p).
    const ExactPoint v{q[1], q[2], q[3]};
    const ExactPoint once = cross(v, p);
    const ExactPoint twice = cross(v, once);
    ExactPoint result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k] = n * p[k] + 2 * (q[0] * once[k] + twice[k]);
    }
    return result;
}

} // namespace

bool differ_by_at_most(const ExactLength& l, const ExactLength& r, double difference) {
    const Integer most =
        Integer(std::floor(std::ldexp(difference, 128))) * l.denominator * r.denominator;
    const Integer left = l.square * r.denominator * r.denominator;
    const Integer right = r.square * l.denominator * l.denominator;
    const auto exceeds = [&](const Integer& larger, const Integer& smaller) {
        // root(larger) > most + root(smaller), squared twice.
        const Integer rest = larger - smaller - most * most;
        return rest > 0 && rest * rest > 4 * most * most * smaller;
    };
    return !exceeds(left, right) && !exceeds(right, left);
}

OraclePath::OraclePath(const Pose& from, const Pose& to)
    : q0_(as_integers(from.quaternion())),
      q1_(as_integers(to.quaternion())),
      c0_(as_integers(from.translation())),
      c1_(as_integers(to.translation())) {
    Integer product = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        product += q0_[i] * q1_[i];
    }
    for (Integer& component : q1_) {
        component = product < 0 ? Integer(-component) : component;
    }
}

OraclePath::Place OraclePath::place(const Vec3& point, std::uint64_t index, unsigned level) const {
    const Integer whole = Integer(1) << level;
    const Integer done = static_cast<unsigned long>(index);
    const Integer rest = whole - done;
    std::array<Integer, 4> q;
    Integer n = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        q[i] = rest * q0_[i] + done * q1_[i];
        n += q[i] * q[i];
    }
    const ExactPoint about_origin = turned(q, n, as_integers(point));
    Place place;
    for (std::size_t k = 0; k < 3; ++k) {
        place.point[k] = whole * about_origin[k] + n * (rest * c0_[k] + done * c1_[k]);
    }
    place.denominator = n * whole;
    return place;
}

ExactLength distance(const OraclePath::Place& l, const OraclePath::Place& r) {
    ExactPoint between;
    for (std::size_t k = 0; k < 3; ++k) {
        between[k] = l.point[k] * r.denominator - r.point[k] * l.denominator;
    }
    return {dot(between, between), l.denominator * r.denominator};
}

} // namespace cd::tests
