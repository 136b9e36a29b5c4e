// Pairs whose points are as near the midpoint of two doubles as a translation can bring them, and
// the number of them that a path to shared points answers wrongly.
#pragma once

#include "tests/support/brink_boxes.hpp"
#include "tests/support/clipping_oracle.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/pair_points.hpp"
#include "tests/support/rounds.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace cd::tests {

/// Returns the midpoint of two adjacent doubles that is nearest to a number.
[[nodiscard]] inline Rational middle_near(const Rational& exact) {
    const auto nearest = exact.convert_to<double>();
    const double towards = Rational(nearest) < exact ? std::numeric_limits<double>::infinity()
                                                     : -std::numeric_limits<double>::infinity();
    return (Rational(nearest) + Rational(std::nextafter(nearest, towards))) / 2;
}

/// Returns the pair with both bodies translated to the same place.
[[nodiscard]] inline PosedPair moved(PosedPair c, const Vec3& by) {
    c.poses = {with_translation(c.poses.a, by), with_translation(c.poses.b, by)};
    return c;
}

/// Translates the pair, by far less than a coordinate's ulp, so that a component of one of its
/// points, relative to the origin, is near a midpoint.
[[nodiscard]] inline PosedPair
brought_to_middle(const PosedPair& c, const Vec3& origin, std::mt19937_64& random) {
    const std::vector<RationalPoint> points = clipping_oracle_points(c.a, c.b, c.poses);
    if (points.empty()) {
        return c;
    }
    const RationalPoint& point = points[random() % points.size()];
    const std::size_t k = random() % 3;
    const auto axis = static_cast<Eigen::Index>(k);
    const Rational value = point[k] - Rational(origin[axis]);
    Vec3 by = Vec3::Zero();
    by[axis] = Rational(middle_near(value) - value).convert_to<double>();
    return moved(c, by);
}

[[nodiscard]] inline bool is_right(const PairPoints& found, const PosedPair& c) {
    const std::vector<RationalPoint> expected = clipping_oracle_points(c.a, c.b, c.poses);
    if (found.points.size() != expected.size()) {
        return false;
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            if (!is_nearest_double(found.points[i][axis],
                                   expected[i][k] - Rational(found.origin[axis]))) {
                return false;
            }
        }
    }
    return true;
}

/// Returns the number of wrong answers of `answer(pair, origin)`, which returns nothing or
/// PairPoints. `origin` is rightly rounded before the pair is brought to the middle.
template <class Answer>
[[nodiscard]] int
wrong_answers_of(const PairMaker& make, const Answer& answer, std::uint64_t rounds) {
    int wrong = 0;
    for (SeededRandom random : seeds(rounds)) {
        const PosedPair base = make(random);
        const RationalPoint first = clipping_oracle_world(base.poses.a, base.a[0]);
        const Vec3 origin(first[0].convert_to<double>(),
                          first[1].convert_to<double>(),
                          first[2].convert_to<double>());
        const PosedPair c = brought_to_middle(base, origin, random);
        const std::optional<PairPoints> found = answer(c, origin);
        wrong += !found || found->points.empty() || is_right(*found, c) ? 0 : 1;
    }
    return wrong;
}

} // namespace cd::tests
