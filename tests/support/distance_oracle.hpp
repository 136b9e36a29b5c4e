// Exact reference for the distance of two triangles, in integers and rationals. Shares no code with
// the engine.
#pragma once

#include "common/distance/nearest_points.hpp"
#include "tests/support/exact_world.hpp"
#include "tests/support/oracle.hpp"

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>

namespace cd::tests {

/// The square of a distance, n / d, with d > 0.
struct SquaredDistance {
    Integer n;
    Integer d = 1;

    [[nodiscard]] int compare(const SquaredDistance& other) const {
        return cmp(n * other.d, other.n * d);
    }
};

/// A corner, edge or face of A and one of B, with the unique nearest points of both.
struct OracleFeature {
    SquaredDistance square;
    WeightedPoint of_a;
    WeightedPoint of_b;
};

/// Returns a feature by its number (see `feature`); nothing if it has no nearest points in its
/// relative interiors.
[[nodiscard]] std::optional<OracleFeature>
oracle_feature(const ExactTriangle& a, const ExactTriangle& b, std::size_t number);

/// Returns the squared distance as the least of all features; 0 for triangles that share a point.
[[nodiscard]] SquaredDistance squared_distance(const ExactTriangle& a, const ExactTriangle& b);

/// Returns the squared distance as the least square of the Minkowski difference, the convex hull of
/// nine points: another method than `squared_distance`.
[[nodiscard]] SquaredDistance squared_norm_of_difference(const ExactTriangle& a,
                                                         const ExactTriangle& b);

/// Returns the finite double nearest to a number, ties to even; +0 for 0.
[[nodiscard]] double oracle_nearest(const mpq_class& exact);
/// Returns the finite double nearest to the square root of a number, ties to even.
[[nodiscard]] double oracle_nearest_root(const mpq_class& square);

/// The nearest points of A and B in the world, and their feature.
struct OracleNearest {
    std::size_t feature = 0;
    std::array<std::array<mpq_class, 3>, 2> points;
};

/// Answers what TriangleDistance answers, about one pair. Takes some 100 microseconds.
class DistanceOracle {
  public:
    DistanceOracle(const Corners& a, const Corners& b, const PosePair& poses);

    /// The square of the distance.
    [[nodiscard]] const mpq_class& square() const { return square_; }
    [[nodiscard]] bool share_a_point() const { return square_ == 0; }
    [[nodiscard]] bool is_within(double d) const;
    [[nodiscard]] double rounded() const { return rounded_; }
    /// The triangles must share no point.
    [[nodiscard]] OracleNearest exact_nearest() const;
    /// Rounds `exact_nearest`.
    [[nodiscard]] NearestPoints nearest() const;

  private:
    [[nodiscard]] mpq_class coordinate(const WeightedPoint& point, std::size_t k) const;

    ExactTriangle a_;
    ExactTriangle b_;
    mpq_class unit_; ///< The coordinates in the world are those of a_ and b_ times this.
    mpq_class square_;
    double rounded_;
};

} // namespace cd::tests
