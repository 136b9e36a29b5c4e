#include "tests/support/distance_oracle.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace cd::tests {

namespace {

/// Returns p * scale + direction * by.
ExactPoint
along(const ExactPoint& p, const Integer& scale, const ExactPoint& direction, const Integer& by) {
    return {p[0] * scale + direction[0] * by,
            p[1] * scale + direction[1] * by,
            p[2] * scale + direction[2] * by};
}

const ExactPoint& next(const ExactTriangle& t, std::size_t i) {
    return t[(i + 1) % 3];
}

OracleFeature corners(const ExactPoint& p, const ExactPoint& q) {
    const ExactPoint w = minus(p, q);
    return {{dot(w, w), 1}, {p, 1}, {q, 1}};
}

/// The nearest points of a corner and an edge; that of the corner is first.
std::optional<OracleFeature>
corner_and_edge(const ExactPoint& p, const ExactPoint& from, const ExactPoint& to) {
    const ExactPoint u = minus(to, from);
    const ExactPoint w = minus(p, from);
    const Integer length = dot(u, u);
    const Integer place = dot(w, u);
    if (!(place > 0 && place < length)) {
        return std::nullopt;
    }
    const ExactPoint aside = cross(w, u);
    return OracleFeature{
        {dot(aside, aside), length}, {p, 1}, {along(from, length, u, place), length}};
}

/// The nearest points of a corner and a face; that of the corner is first.
std::optional<OracleFeature> corner_and_face(const ExactPoint& p, const ExactTriangle& face) {
    const ExactPoint n = normal_of(face);
    const Integer length = dot(n, n);
    if (length == 0) {
        return std::nullopt;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const ExactPoint edge = minus(next(face, k), face[k]);
        if (dot(n, cross(edge, minus(p, face[k]))) <= 0) {
            return std::nullopt;
        }
    }
    const Integer height = dot(minus(p, face[0]), n);
    return OracleFeature{{height * height, length}, {p, 1}, {along(p, length, n, -height), length}};
}

std::optional<OracleFeature>
edges(const ExactPoint& p, const ExactPoint& p_to, const ExactPoint& q, const ExactPoint& q_to) {
    const ExactPoint u = minus(p_to, p);
    const ExactPoint v = minus(q_to, q);
    const ExactPoint c = cross(u, v);
    const Integer length = dot(c, c);
    const ExactPoint w = minus(q, p);
    const Integer s = dot(cross(w, v), c);
    const Integer t = dot(cross(w, u), c);
    if (length == 0 || s <= 0 || s >= length || t <= 0 || t >= length) {
        return std::nullopt;
    }
    const Integer height = dot(w, c);
    return OracleFeature{{height * height, length},
                         {along(p, length, u, s), length},
                         {along(q, length, v, t), length}};
}

std::optional<OracleFeature> swapped(std::optional<OracleFeature> found) {
    if (found) {
        std::swap(found->of_a, found->of_b);
    }
    return found;
}

/// The point f / w is the point of least norm in a hull that contains it if the hull lies on the
/// far side of the plane through the point, perpendicular to it.
bool is_least(const ExactPoint& f, const Integer& w, std::span<const ExactPoint> hull) {
    const Integer square = dot(f, f);
    return std::all_of(
        hull.begin(), hull.end(), [&](const ExactPoint& p) { return dot(f, p) * w >= square; });
}

/// The point of least norm on a segment's line, if it is on the segment and is the hull's.
std::optional<SquaredDistance>
least_on_segment(const ExactPoint& p, const ExactPoint& q, std::span<const ExactPoint> hull) {
    const ExactPoint u = minus(q, p);
    const Integer length = dot(u, u);
    const Integer place = -dot(p, u);
    if (length == 0 || place < 0 || place > length) {
        return std::nullopt;
    }
    const ExactPoint foot = along(p, length, u, place);
    return is_least(foot, length, hull)
               ? std::optional(SquaredDistance{dot(foot, foot), length * length})
               : std::nullopt;
}

/// The point of least norm in a triangle's plane, if it is in the triangle and is the hull's.
std::optional<SquaredDistance> least_in_triangle(const ExactTriangle& t,
                                                 std::span<const ExactPoint> hull) {
    const ExactPoint n = normal_of(t);
    const Integer length = dot(n, n);
    if (length == 0) {
        return std::nullopt;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (dot(n, cross(next(t, k), t[k])) >
            0) { // The origin, and so its foot, is beyond an edge.
            return std::nullopt;
        }
    }
    const Integer height = dot(t[0], n);
    const ExactPoint foot = along({}, 0, n, height);
    return is_least(foot, length, hull) ? std::optional(SquaredDistance{height * height, length})
                                        : std::nullopt;
}

/// Rounds an integer, or a number between it and the next one, times 2^unit.
double nearest_of(Integer whole, bool is_more, int unit) {
    constexpr int lowest_unit = -1074;
    const Integer bits = 2 * whole + (is_more ? 1 : 0);
    const int size = static_cast<int>(mpz_sizeinbase(bits.get_mpz_t(), 2));
    const int dropped = std::max({size - 53, lowest_unit - (unit - 1), 0});
    Integer kept;
    Integer rest;
    mpz_fdiv_q_2exp(kept.get_mpz_t(), bits.get_mpz_t(), static_cast<mp_bitcnt_t>(dropped));
    mpz_fdiv_r_2exp(rest.get_mpz_t(), bits.get_mpz_t(), static_cast<mp_bitcnt_t>(dropped));
    Integer half = 1;
    half <<= static_cast<mp_bitcnt_t>(dropped);
    const int order = cmp(2 * rest, half);
    if (dropped > 0 && (order > 0 || (order == 0 && mpz_odd_p(kept.get_mpz_t()) != 0))) {
        ++kept;
    }
    const double value = std::ldexp(kept.get_d(), unit - 1 + dropped);
    return std::min(value, std::numeric_limits<double>::max());
}

/// The shift that leaves a quotient of at least `bits` bits.
int shift_for(const Integer& n, const Integer& d, int bits) {
    const auto size = [](const Integer& of) {
        return static_cast<int>(mpz_sizeinbase(of.get_mpz_t(), 2));
    };
    return bits - size(n) + size(d);
}

struct Quotient {
    Integer whole;
    bool is_more = false;
};

/// Divides n 2^shift by d.
Quotient quotient(Integer n, Integer d, int shift) {
    if (shift >= 0) {
        n <<= static_cast<mp_bitcnt_t>(shift);
    } else {
        d <<= static_cast<mp_bitcnt_t>(-shift);
    }
    Quotient result;
    Integer rest;
    mpz_fdiv_qr(result.whole.get_mpz_t(), rest.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
    result.is_more = rest != 0;
    return result;
}

mpq_class fraction(const SquaredDistance& square) {
    mpq_class result(square.n, square.d);
    result.canonicalize();
    return result;
}

ExactTriangle triangle_at(const std::vector<ExactPoint>& points) {
    return {points[0], points[1], points[2]};
}

mpq_class unit_of(const ExactWorld& world) {
    mpq_class unit(1, world.denominator);
    const auto shift = static_cast<mp_bitcnt_t>(std::abs(world.exponent));
    if (world.exponent >= 0) {
        mpq_mul_2exp(unit.get_mpq_t(), unit.get_mpq_t(), shift);
    } else {
        mpq_div_2exp(unit.get_mpq_t(), unit.get_mpq_t(), shift);
    }
    return unit;
}

} // namespace

std::optional<OracleFeature>
oracle_feature(const ExactTriangle& a, const ExactTriangle& b, std::size_t number) {
    if (number < feature::corner_edge) {
        return corners(a[number / 3], b[number % 3]);
    }
    if (number < feature::edge_corner) {
        const std::size_t at = number - feature::corner_edge;
        return corner_and_edge(a[at / 3], b[at % 3], next(b, at % 3));
    }
    if (number < feature::corner_face) {
        const std::size_t at = number - feature::edge_corner;
        return swapped(corner_and_edge(b[at % 3], a[at / 3], next(a, at / 3)));
    }
    if (number < feature::face_corner) {
        return corner_and_face(a[number - feature::corner_face], b);
    }
    if (number < feature::edge_edge) {
        return swapped(corner_and_face(b[number - feature::face_corner], a));
    }
    const std::size_t at = number - feature::edge_edge;
    return edges(a[at / 3], next(a, at / 3), b[at % 3], next(b, at % 3));
}

SquaredDistance squared_distance(const ExactTriangle& a, const ExactTriangle& b) {
    if (oracle_class(a, b) != PairClass::Separate) {
        return {0, 1};
    }
    std::optional<SquaredDistance> least;
    for (std::size_t i = 0; i < feature::count; ++i) {
        const auto found = oracle_feature(a, b, i);
        if (found && (!least || found->square.compare(*least) < 0)) {
            least = found->square;
        }
    }
    return *least;
}

SquaredDistance squared_norm_of_difference(const ExactTriangle& a, const ExactTriangle& b) {
    std::vector<ExactPoint> hull;
    for (const ExactPoint& p : a) {
        for (const ExactPoint& q : b) {
            hull.push_back(minus(p, q));
        }
    }
    for (std::size_t i = 0; i < hull.size(); ++i) {
        if (is_least(hull[i], 1, hull)) {
            return {dot(hull[i], hull[i]), 1};
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (const auto found = least_on_segment(hull[i], hull[j], hull)) {
                return *found;
            }
            for (std::size_t k = 0; k < j; ++k) {
                if (const auto found = least_in_triangle({hull[i], hull[j], hull[k]}, hull)) {
                    return *found;
                }
            }
        }
    }
    return {0, 1}; // The origin is inside the hull.
}

double oracle_nearest(const mpq_class& exact) {
    if (exact == 0) {
        return 0;
    }
    const Integer n = abs(exact.get_num());
    const int shift = shift_for(n, exact.get_den(), 64);
    const Quotient q = quotient(n, exact.get_den(), shift);
    const double magnitude = nearest_of(q.whole, q.is_more, -shift);
    return exact > 0 ? magnitude : 0 - magnitude;
}

double oracle_nearest_root(const mpq_class& square) {
    if (square == 0) {
        return 0;
    }
    int shift = shift_for(square.get_num(), square.get_den(), 128);
    shift += shift % 2;
    const Quotient q = quotient(square.get_num(), square.get_den(), shift);
    Integer root;
    Integer rest;
    mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), q.whole.get_mpz_t());
    return nearest_of(root, q.is_more || rest != 0, -shift / 2);
}

DistanceOracle::DistanceOracle(const Corners& a, const Corners& b, const PosePair& poses) {
    const ExactWorld world = exact_world(a, b, poses);
    a_ = triangle_at(world.a);
    b_ = triangle_at(world.b);
    unit_ = unit_of(world);
    square_ = fraction(squared_distance(a_, b_)) * unit_ * unit_;
    rounded_ = oracle_nearest_root(square_);
}

bool DistanceOracle::is_within(double d) const {
    return square_ <= mpq_class(d) * mpq_class(d);
}

mpq_class DistanceOracle::coordinate(const WeightedPoint& point, std::size_t k) const {
    mpq_class value(point.p[k], point.weight);
    value.canonicalize();
    return value * unit_;
}

OracleNearest DistanceOracle::exact_nearest() const {
    CD_CHECK(!share_a_point());
    OracleNearest nearest;
    for (; nearest.feature < feature::count; ++nearest.feature) {
        const auto found = oracle_feature(a_, b_, nearest.feature);
        if (!found || oracle_nearest_root(fraction(found->square) * unit_ * unit_) != rounded_) {
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            nearest.points[0][k] = coordinate(found->of_a, k);
            nearest.points[1][k] = coordinate(found->of_b, k);
        }
        break;
    }
    return nearest;
}

NearestPoints DistanceOracle::nearest() const {
    const OracleNearest exact = exact_nearest();
    NearestPoints points;
    points.feature = static_cast<std::uint8_t>(exact.feature);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double from = oracle_nearest(coordinate({a_[0], 1}, k));
        points.origin[axis] = from;
        points.of_a[axis] = oracle_nearest(exact.points[0][k] - mpq_class(from));
        points.of_b[axis] = oracle_nearest(exact.points[1][k] - mpq_class(from));
    }
    return points;
}

} // namespace cd::tests
