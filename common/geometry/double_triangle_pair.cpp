// With the edges p, q of A at a0, the edges r, s of B at b0, d = a0 - b0, NA = p x q and NB = r x
// s, all fifteen determinants of a pair are sums of ten triple products: three sides of A's corners
// against B's plane, three of B's against A's, and nine of A's edges against B's (the Pluecker
// sides). Each is proven positive, proven negative, or neither; only proofs decide.
//
// Bounds, with u = 2^-53. A computed vector has components of at most x, and errs by at most dx in
// each; X = x + dx bounds the true ones too.
//
// Input: a triple product has six terms of three factors, so errors of the input change it by at
// most 6 (XYZ - xyz) <= 6 (dx Y Z + X dy Z + X Y dz).
// Arithmetic: a component of a cross product is at most 2YZ, and 4.01 u YZ off: two products and
// one difference. The dot product has three terms of at most 2XYZ with three roundings each, 18.1 u
// XYZ, and takes over 3 * 4.01 u XYZ: below 31 u XYZ together. A determinant is a sum of up to
// eight triple products of at most 6XYZ, each going through at most six roundings of partial sums:
// 37 u XYZ more for each.
// Together a triple product within a determinant is within
//     6 (dx Y Z + X dy Z + X Y dz) + 68 u XYZ <= fx Y Z + X fy Z + X Y fz, fx = 6.5 dx + 31 u X,
// where 6.5 and 31 (for 6 and 22.7) leave room for the roundings of the bound itself.
//
// Underflow loses at most 2^-1074 a product. What is multiplied with it later is below 2^600 by the
// limit on sizes, so that `underflow` covers all of it, in the bounds as well. NaN and infinity
// come only from sizes beyond that limit or from input near the end of the doubles' range; they
// reach either the sizes, or every determinant that they belong to, and no comparison proves
// anything of NaN.
#include "common/geometry/double_triangle_pair.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff.
constexpr double size_max = 0x1p300;
constexpr double underflow = 0x1p-400;

double largest_of(const Vec3& v) {
    return std::max(std::max(std::abs(v.x()), std::abs(v.y())), std::abs(v.z()));
}

Vec3 times(const Mat3& m, const Vec3& x) {
    return {m(0, 0) * x.x() + m(0, 1) * x.y() + m(0, 2) * x.z(),
            m(1, 0) * x.x() + m(1, 1) * x.y() + m(1, 2) * x.z(),
            m(2, 0) * x.x() + m(2, 1) * x.y() + m(2, 2) * x.z()};
}

struct Rotated {
    Vec3 value;
    double error = 0; ///< Bounds the error of each component.
};

/// R x for components within `relative` of themselves. Each of three products is off by that and by
/// the entry's error, and goes through three roundings.
Rotated rotated(const RoundedRotation& rotation, const Vec3& x, double relative) {
    const double reach = largest_of(x);
    if (rotation.is_identity) {
        return {x, relative * reach};
    }
    const double error =
        3.01 * reach * (rotation.entry_error + rotation.entry_largest * (relative + 4 * u));
    return {times(rotation.matrix, x), error + 0x1p-1000};
}

/// What the bounds need to know of the vectors of one kind: X and fx above.
struct Extent {
    double size = 0;
    double fuzz = 0;

    Extent(double computed_size, double error)
        : size(computed_size + error), fuzz(6.5 * error + 31 * u * size) {}
};

/// A triangle's two edges from its first corner, in the world's directions.
struct Edges {
    Rotated first;
    Rotated second;
    Extent extent;

    // A difference of corners is rounded once.
    Edges(const RoundedRotation& rotation, const Corners& corners)
        : first(rotated(rotation, corners[1] - corners[0], u)),
          second(rotated(rotation, corners[2] - corners[0], u)),
          extent(std::max(largest_of(first.value), largest_of(second.value)),
                 std::max(first.error, second.error)) {}
};

/// The error of one triple product of vectors of these kinds, with its share in a determinant.
double triple_error(const Extent& x, const Extent& y, const Extent& z) {
    return x.fuzz * y.size * z.size + x.size * (y.fuzz * z.size + y.size * z.fuzz);
}

/// Proven signs of several values, one bit each.
struct Signs {
    unsigned positive = 0;
    unsigned negative = 0;

    void add(unsigned place, double value, double error) {
        positive |= static_cast<unsigned>(value > error) << place;
        negative |= static_cast<unsigned>(value < -error) << place;
    }
    [[nodiscard]] bool all_three_agree() const { return positive == 7 || negative == 7; }
    [[nodiscard]] bool is_any_proven() const { return (positive | negative) != 0; }
};

/// Sides of a triangle's corners x_0, x_0 + e, x_0 + f, from the triple products of each.
Signs sides(double of_corner, double of_first, double of_second, double error, double edge_error) {
    Signs signs;
    signs.add(0, of_corner, error);
    signs.add(1, of_corner + of_first, error + edge_error);
    signs.add(2, of_corner + of_second, error + edge_error);
    return signs;
}

/// What is proven of one edge against the other triangle.
struct EdgeVerdict {
    bool misses = false;
    bool pierces = false; ///< Its inside crosses the other's inside.
};

/// `ends` are the two bits of the edge's ends in the sides of its triangle; `across` its sides
/// against the other's three edges, at the bits of `mask`. An edge with both ends on one side of
/// the other's plane misses it, and so does one whose line passes the other's edges on different
/// sides. Where the plane or the line means nothing, the other being degenerate or the edge in its
/// plane, the determinants are zero and nothing is proven.
EdgeVerdict judge_edge(const Signs& side, unsigned ends, const Signs& across, unsigned mask) {
    const bool one_sided = (side.positive & ends) == ends || (side.negative & ends) == ends;
    const bool crosses = (side.positive & ends) != 0 && (side.negative & ends) != 0;
    const bool passes_positive = (across.positive & mask) != 0;
    const bool passes_negative = (across.negative & mask) != 0;
    const bool encircled = (across.positive & mask) == mask || (across.negative & mask) == mask;
    return {one_sided || (passes_positive && passes_negative), crosses && encircled};
}

/// Two triangles meet exactly when an edge of one meets the other. An edge that pierces the other
/// makes the pair proper if its own triangle has area, which any proven side against that
/// triangle's plane shows.
std::optional<PairClass> decide(const Signs& a_side, const Signs& b_side, const Signs& across) {
    constexpr std::array<unsigned, 3> ends{0b011, 0b110, 0b101};
    bool all_miss = true;
    bool any_pierces = false;
    for (unsigned i = 0; i < 3; ++i) {
        const EdgeVerdict of_a = judge_edge(a_side, ends[i], across, 0b000'000'111u << (3 * i));
        const EdgeVerdict of_b = judge_edge(b_side, ends[i], across, 0b001'001'001u << i);
        all_miss = all_miss && of_a.misses && of_b.misses;
        any_pierces = any_pierces || of_a.pierces || of_b.pierces;
    }
    if (any_pierces && a_side.is_any_proven() && b_side.is_any_proven()) {
        return PairClass::Proper;
    }
    return all_miss ? std::optional(PairClass::Separate) : std::nullopt;
}

} // namespace

RoundedRotation::RoundedRotation(const Pose& pose)
    : matrix(pose.rotation()),
      entry_error(pose.rotation_error()),
      entry_largest(matrix.cwiseAbs().maxCoeff() + entry_error),
      is_identity(entry_error == 0 && matrix == Mat3::Identity()) {}

DoubleTrianglePair::DoubleTrianglePair(const PosePair& poses)
    : a_(poses.a), b_(poses.b), offset_(poses.a.translation() - poses.b.translation()) {}

std::optional<PairClass> DoubleTrianglePair::classify(const Corners& ca, const Corners& cb) const {
    const Rotated a0 = rotated(a_, ca[0], 0);
    const Rotated b0 = rotated(b_, cb[0], 0);
    const Vec3 d = (a0.value - b0.value) + offset_;
    // The offset's rounding, and one for each of the two sums.
    const double d_error =
        a0.error + b0.error +
        2.01 * u *
            (largest_of(a0.value) + largest_of(b0.value) + largest_of(offset_) + largest_of(d));
    const Extent extent_d(largest_of(d), d_error);
    const Edges a(a_, ca);
    const Edges b(b_, cb);
    // Each on its own: a maximum may lose NaN.
    if (!(extent_d.size < size_max && a.extent.size < size_max && b.extent.size < size_max)) {
        return std::nullopt;
    }
    const Vec3& p = a.first.value;
    const Vec3& q = a.second.value;
    const Vec3& r = b.first.value;
    const Vec3& s = b.second.value;

    const Vec3 nb = r.cross(s);
    const double nbp = nb.dot(p);
    const double nbq = nb.dot(q);
    const double abb = triple_error(a.extent, b.extent, b.extent);
    const double bbd = triple_error(b.extent, b.extent, extent_d) + underflow;
    const Signs a_side = sides(nb.dot(d), nbp, nbq, bbd, abb);
    if (a_side.all_three_agree()) {
        return PairClass::Separate;
    }

    const Vec3 na = p.cross(q);
    const double nar = na.dot(r);
    const double nas = na.dot(s);
    const double aab = triple_error(a.extent, a.extent, b.extent);
    const double aad = triple_error(a.extent, a.extent, extent_d) + underflow;
    const Signs b_side = sides(-na.dot(d), nar, nas, aad, aab);
    if (b_side.all_three_agree()) {
        return PairClass::Separate;
    }

    const double pr = p.cross(r).dot(d);
    const double ps = p.cross(s).dot(d);
    const double qr = q.cross(r).dot(d);
    const double qs = q.cross(s).dot(d);
    const double abd = triple_error(a.extent, b.extent, extent_d) + underflow;
    Signs across;
    across.add(0, pr, abd);
    across.add(1, ps - pr + nbp, 2 * abd + abb);
    across.add(2, -ps, abd);
    across.add(3, qr - pr + nar, 2 * abd + aab);
    across.add(4, qs - qr - ps + pr + (nas - nar) + (nbq - nbp), 4 * abd + 2 * (aab + abb));
    across.add(5, -(qs - ps + nas), 2 * abd + aab);
    across.add(6, -qr, abd);
    across.add(7, qr - qs - nbq, 2 * abd + abb);
    across.add(8, qs, abd);
    return decide(a_side, b_side, across);
}

} // namespace cd
