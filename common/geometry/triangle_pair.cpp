#include "common/geometry/triangle_pair.hpp"

#include "common/geometry/exact_triangle_pair.hpp"
#include "common/geometry/shared_points.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff.

/// A pose in doubles, with a bound on the error of each entry of its rotation.
struct RoundedPose {
    Mat3 rotation;
    double entry_error = 0; ///< Quaternions: 16 u (pose.cpp). Matrices are exact.
    double largest = 0;     ///< Bounds every entry.

    explicit RoundedPose(const Pose& pose)
        : rotation(pose.rotation()),
          entry_error(pose.kind() == Pose::Kind::Quaternion ? 16 * u : 0),
          largest(rotation.cwiseAbs().maxCoeff() + entry_error) {}
};

/// A vector with bounds on its components' size and error.
struct Bounded {
    Vec3 value;
    double size = 0;  ///< Bounds each |component|.
    double error = 0; ///< Bounds the error of each component.
};

double largest_of(const Vec3& v) {
    return std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

/// R x for an x whose components are within `relative` of themselves: three products of entries,
/// each with its error, and three roundings of the sum.
Bounded rotated(const RoundedPose& pose, const Vec3& x, double relative) {
    Bounded out;
    out.value = pose.rotation * x;
    const double reach = largest_of(x);
    out.error = 3.01 * reach * (pose.entry_error + pose.largest * (relative + 4 * u)) + 0x1p-1000;
    out.size = largest_of(out.value);
    return out;
}

/// One triangle's edges from its first corner, in the world's directions.
struct Edges {
    Bounded first;
    Bounded second;
    double size = 0;
    double error = 0;
};

Edges edges_of(const RoundedPose& pose, const Corners& corners) {
    Edges edges;
    // A difference is rounded once.
    edges.first = rotated(pose, corners[1] - corners[0], u);
    edges.second = rotated(pose, corners[2] - corners[0], u);
    edges.size = std::max(edges.first.size, edges.second.size);
    edges.error = std::max(edges.first.error, edges.second.error);
    return edges;
}

/// The fifteen determinants of a pair, from ten triple products (NUMERICS, section 2): with the
/// edges p, q of A at a0, r, s of B at b0, d = a0 - b0, NA = p x q and NB = r x s.
struct Determinants {
    std::array<double, 3> a_side{}; ///< NB.(a_i - b0)
    std::array<double, 3> b_side{}; ///< NA.(b_j - a0)
    std::array<double, 9> across{}; ///< Edge i of A against edge j of B, at 3 i + j.
};

/// Bounds on the errors of the determinants.
struct ErrorBounds {
    std::array<double, 3> a_side{};
    std::array<double, 3> b_side{};
    std::array<double, 9> across{};
};

Determinants
determinants(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, const Vec3& d) {
    const Vec3 na = p.cross(q);
    const Vec3 nb = r.cross(s);
    const double nbd = nb.dot(d);
    const double nbp = nb.dot(p);
    const double nbq = nb.dot(q);
    const double nad = na.dot(d);
    const double nar = na.dot(r);
    const double nas = na.dot(s);
    const double c11 = p.cross(r).dot(d);
    const double c12 = p.cross(s).dot(d);
    const double c21 = q.cross(r).dot(d);
    const double c22 = q.cross(s).dot(d);
    Determinants out;
    out.a_side = {nbd, nbd + nbp, nbd + nbq};
    out.b_side = {-nad, nar - nad, nas - nad};
    out.across = {c11,
                  c12 - c11 + nbp,
                  -c12,
                  c21 - c11 + nar,
                  c22 - c21 - c12 + c11 + (nas - nar) + (nbq - nbp),
                  -(c22 - c12 + nas),
                  -c21,
                  c21 - c22 - nbq,
                  c22};
    return out;
}

/// A triple product of computed vectors with components of size x, y, z and errors dx, dy, dz.
///
/// Arithmetic: a component of a cross product is at most 2yz and within 2u of that sum of two terms
/// plus a rounding each, below 4.01u yz in all; the dot product of three terms of at most 2xyz has
/// three roundings on each, 18.1u xyz, and carries 3 * 4.01u xyz over: together below 31u xyz.
/// Input: six terms of three factors, so 6 (dx y z + x dy z + x y dz), with second-order terms far
/// below the slack as errors are far below sizes; 42 and 6.5 leave room for the rounding of the
/// bound itself.
double triple_error(double x, double dx, double y, double dy, double z, double dz) {
    return 42 * u * x * y * z + 6.5 * (dx * y * z + x * dy * z + x * y * dz + dx * dy * z +
                                       dx * y * dz + x * dy * dz + dx * dy * dz);
}

/// Each sum of triple products adds at most seven roundings of partial sums that are at most the
/// sum of all terms' sizes, 6xyz a term: 50u xyz a term covers them.
ErrorBounds bounds(const Edges& a, const Edges& b, const Bounded& d) {
    const double k = 50 * u;
    const double c = triple_error(a.size, a.error, b.size, b.error, d.size, d.error) +
                     k * a.size * b.size * d.size;
    const double nbd = triple_error(b.size, b.error, b.size, b.error, d.size, d.error) +
                       k * b.size * b.size * d.size;
    const double nad = triple_error(a.size, a.error, a.size, a.error, d.size, d.error) +
                       k * a.size * a.size * d.size;
    const double abb = triple_error(b.size, b.error, b.size, b.error, a.size, a.error) +
                       k * a.size * b.size * b.size;
    const double aab = triple_error(a.size, a.error, a.size, a.error, b.size, b.error) +
                       k * a.size * a.size * b.size;
    // What underflows is below 2^-1022 a product; a factor after it may be large, so sizes above
    // 2^300 are left to the exact stage, and 2^-400 covers the rest.
    constexpr double tiny = 0x1p-400;
    ErrorBounds out;
    out.a_side = {nbd + tiny, nbd + abb + tiny, nbd + abb + tiny};
    out.b_side = {nad + tiny, nad + aab + tiny, nad + aab + tiny};
    const double one = c + tiny;
    const double with_b = 2 * c + abb + tiny;
    const double with_a = 2 * c + aab + tiny;
    const double with_both = 4 * c + 2 * aab + 2 * abb + tiny;
    out.across = {one, with_b, one, with_a, with_both, with_a, one, with_b, one};
    return out;
}

/// 1, -1, or 0 where the sign is not proven. A bound that is not a number proves nothing.
int proven_sign(double value, double bound) {
    return value > bound ? 1 : value < -bound ? -1 : 0;
}

struct Signs {
    std::array<int, 3> a_side{};
    std::array<int, 3> b_side{};
    std::array<int, 9> across{};
};

Signs proven_signs(const Determinants& value, const ErrorBounds& bound) {
    Signs signs;
    for (std::size_t i = 0; i < 3; ++i) {
        signs.a_side[i] = proven_sign(value.a_side[i], bound.a_side[i]);
        signs.b_side[i] = proven_sign(value.b_side[i], bound.b_side[i]);
    }
    for (std::size_t i = 0; i < 9; ++i) {
        signs.across[i] = proven_sign(value.across[i], bound.across[i]);
    }
    return signs;
}

bool all_on_one_side(const std::array<int, 3>& side) {
    return side[0] != 0 && side[0] == side[1] && side[1] == side[2];
}

/// One edge against the other triangle: the sides of its ends, and of the edge against the three
/// edges.
enum class EdgeVerdict { Misses, Pierces, Unknown };

EdgeVerdict judge_edge(int from, int to, int first, int second, int third) {
    if (from != 0 && from == to) {
        return EdgeVerdict::Misses;
    }
    const bool has_positive = first > 0 || second > 0 || third > 0;
    const bool has_negative = first < 0 || second < 0 || third < 0;
    if (has_positive && has_negative) {
        return EdgeVerdict::Misses;
    }
    if (from * to < 0 && first != 0 && second != 0 && third != 0) {
        return EdgeVerdict::Pierces;
    }
    return EdgeVerdict::Unknown;
}

bool is_any_proven(const std::array<int, 3>& side) {
    return side[0] != 0 || side[1] != 0 || side[2] != 0;
}

/// What the proven signs prove. Two triangles meet exactly when an edge of one meets the other, and
/// an edge whose line passes the other's edges on different sides misses it. An edge that pierces
/// the other's interior strictly makes the pair proper when its own triangle has area, which one
/// proven distance of a corner of the other from its plane shows.
std::optional<PairClass> decide(const Signs& signs) {
    if (all_on_one_side(signs.a_side) || all_on_one_side(signs.b_side)) {
        return PairClass::Separate;
    }
    bool all_miss = true;
    bool pierced = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const auto& o = signs.across;
        const EdgeVerdict of_a =
            judge_edge(signs.a_side[i], signs.a_side[j], o[3 * i], o[3 * i + 1], o[3 * i + 2]);
        const EdgeVerdict of_b =
            judge_edge(signs.b_side[i], signs.b_side[j], o[i], o[i + 3], o[i + 6]);
        all_miss = all_miss && of_a == EdgeVerdict::Misses && of_b == EdgeVerdict::Misses;
        pierced = pierced || of_a == EdgeVerdict::Pierces || of_b == EdgeVerdict::Pierces;
    }
    if (pierced && is_any_proven(signs.a_side) && is_any_proven(signs.b_side)) {
        return PairClass::Proper;
    }
    return all_miss ? std::optional(PairClass::Separate) : std::nullopt;
}

} // namespace

PairStatistics& PairStatistics::operator+=(const PairStatistics& other) {
    by_double += other.by_double;
    by_exact += other.by_exact;
    return *this;
}

struct TrianglePairTest::State {
    PosePair poses;
    RoundedPose a;
    RoundedPose b;
    Vec3 offset; ///< ta - tb, rounded once.
    ExactTrianglePair exact;
    PairStatistics statistics;

    explicit State(const PosePair& given)
        : poses(given),
          a(given.a),
          b(given.b),
          offset(given.a.translation() - given.b.translation()),
          exact(given) {}

    [[nodiscard]] std::optional<PairClass> decide_in_double(const Corners& ca,
                                                            const Corners& cb) const {
        const Edges edges_a = edges_of(a, ca);
        const Edges edges_b = edges_of(b, cb);
        const Bounded a0 = rotated(a, ca[0], 0);
        const Bounded b0 = rotated(b, cb[0], 0);
        Bounded d;
        d.value = (a0.value - b0.value) + offset;
        d.size = largest_of(d.value);
        // The offset's rounding, and one for each of the two sums.
        d.error =
            a0.error + b0.error + 2.01 * u * (a0.size + b0.size + largest_of(offset) + d.size);
        const double reach = std::max({edges_a.size, edges_b.size, d.size});
        if (!(reach < 0x1p300)) {
            return std::nullopt;
        }
        return decide(proven_signs(determinants(edges_a.first.value,
                                                edges_a.second.value,
                                                edges_b.first.value,
                                                edges_b.second.value,
                                                d.value),
                                   bounds(edges_a, edges_b, d)));
    }
};

TrianglePairTest::TrianglePairTest(const PosePair& poses)
    : state_(std::make_unique<State>(poses)) {}
TrianglePairTest::TrianglePairTest(TrianglePairTest&&) noexcept = default;
TrianglePairTest& TrianglePairTest::operator=(TrianglePairTest&&) noexcept = default;
TrianglePairTest::~TrianglePairTest() = default;

bool TrianglePairTest::touches(const Corners& a, const Corners& b) {
    return classify(a, b) != PairClass::Separate;
}

PairClass TrianglePairTest::classify(const Corners& a, const Corners& b) {
    if (const auto decided = state_->decide_in_double(a, b)) {
        ++state_->statistics.by_double;
        return *decided;
    }
    ++state_->statistics.by_exact;
    return state_->exact.classify(a, b);
}

std::vector<Vec3>
TrianglePairTest::shared_points(const Corners& a, const Corners& b, PairClass kind) {
    const Vec3 d = (state_->b.rotation * b[0] - state_->a.rotation * a[0]) - state_->offset;
    Corners local_a;
    Corners local_b;
    for (std::size_t i = 0; i < 3; ++i) {
        local_a[i] = state_->a.rotation * (a[i] - a[0]);
        local_b[i] = state_->b.rotation * (b[i] - b[0]) + d;
    }
    return approximate_shared_points(local_a, local_b, kind);
}

Vec3 TrianglePairTest::point_origin(const Corners& a) const {
    return state_->a.rotation * a[0] + state_->poses.a.translation();
}

const PairStatistics& TrianglePairTest::statistics() const {
    return state_->statistics;
}

} // namespace cd
