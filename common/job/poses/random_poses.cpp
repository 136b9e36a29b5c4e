#include "common/core/check.hpp"
#include "common/core/split_mix.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/made_poses.hpp"
#include "common/search/contact_search.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace cd {

namespace {

/// Number of steps along a line of approach that are tested for a collision.
constexpr int approach_steps = 32;
/// Number of halvings of the step in which the first collision lies.
constexpr int bisection_steps = 10;
/// Number of lines tried for one scenario. Bodies that collide on none can hardly collide at all.
constexpr int lines_max = 64;

/// The random numbers of one scenario, which depend on the seed and the index alone.
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t index) : state_(seed) {
        state_ = split_mix(state_) ^ index;
        state_ = split_mix(state_);
    }

    /// Returns a number in [0, 1) with 53 random bits.
    double unit() { return static_cast<double>(split_mix(state_) >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }

  private:
    std::uint64_t state_;
};

template <std::size_t Size>
struct BallPoint {
    std::array<double, Size> at{};
    double squared = 0; ///< Squared distance from the origin.
};

/// Returns a uniformly random point of the unit disk or ball, more than 0.001 from the centre.
template <std::size_t Size>
BallPoint<Size> random_in_ball(Random& random) {
    while (true) {
        BallPoint<Size> point;
        for (double& coordinate : point.at) {
            coordinate = random.between(-1, 1);
            point.squared += coordinate * coordinate;
        }
        if (point.squared <= 1 && point.squared > 1e-6) {
            return point;
        }
    }
}

Vec3 random_direction(Random& random) {
    const auto point = random_in_ball<3>(random);
    const double length = std::sqrt(point.squared);
    return {point.at[0] / length, point.at[1] / length, point.at[2] / length};
}

/// Returns a uniformly random rotation. Marsaglia, Choosing a point from the surface of a sphere
/// (1972).
Quaternion random_rotation(Random& random) {
    const auto first = random_in_ball<2>(random);
    const auto second = random_in_ball<2>(random);
    const double scale = std::sqrt((1 - first.squared) / second.squared);
    return {first.at[0], first.at[1], second.at[0] * scale, second.at[1] * scale};
}

/// The trees and boxes of both bodies, which all scenarios of a job share.
struct Bodies {
    const ObbTree& a;
    const ObbTree& b;
    Aabb box_a;
    Aabb box_b;
    double reach = 0; ///< Distance of the boxes' centres beyond which the bodies cannot touch.
};

Bodies measure(const ObbTree& a, const ObbTree& b) {
    Bodies bodies{a, b, bounding_box(a.mesh().vertices()), bounding_box(b.mesh().vertices()), 0};
    bodies.reach = 0.5 * 1.001 * (bodies.box_a.diagonal() + bodies.box_b.diagonal());
    return bodies;
}

/// An approach of B in a random orientation, along a random ray to the centre of A's box.
class Approach {
  public:
    Approach(const Bodies& bodies, Random& random)
        : bodies_(bodies),
          direction_(random_direction(random)),
          turn_(random_rotation(random)),
          center_b_(Pose::from_quaternion(turn_, Vec3::Zero()).apply(bodies.box_b.center())) {}

    /// Returns B's pose when the centres of the boxes have this distance.
    [[nodiscard]] Pose at(double distance) const {
        const Vec3 center = bodies_.box_a.center() + direction_ * distance;
        return Pose::from_quaternion(turn_, center - center_b_);
    }

    /// Returns the distance of the first collision on the way in, or nothing when there is none.
    [[nodiscard]] std::optional<double> first_collision() const {
        const double step = bodies_.reach / approach_steps;
        for (int i = approach_steps - 1; i >= 0; --i) {
            if (!collides(i * step)) {
                continue;
            }
            double colliding = i * step;
            double free = (i + 1) * step;
            for (int k = 0; k < bisection_steps; ++k) {
                const double middle = 0.5 * (colliding + free);
                (collides(middle) ? colliding : free) = middle;
            }
            return colliding;
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool collides(double distance) const {
        const TreeView a = bodies_.a.view();
        const TreeView b = bodies_.b.view();
        return make_search(a, b, {Pose{}, at(distance)})->any(a, b);
    }

    const Bodies& bodies_;
    Vec3 direction_;
    Quaternion turn_;
    Vec3 center_b_; ///< Centre of B's box, rotated but not translated.
};

Pose random_pose(const RandomPoses& options, const Bodies& bodies, std::uint64_t index) {
    Random random(options.seed, index);
    for (int line = 0; line < lines_max; ++line) {
        const Approach approach(bodies, random);
        if (const auto first = approach.first_collision()) {
            const double share = random.between(options.penetration_min, options.penetration_max);
            return approach.at(*first - share * bodies.box_b.diagonal());
        }
    }
    // B collides on none of the lines, so B stays at A's centre.
    return Approach(bodies, random).at(0);
}

} // namespace

ScenarioMaker random_scenarios(const RandomPoses& options, const ObbTree& a, const ObbTree& b) {
    CD_CHECK(options.penetration_min >= 0);
    CD_CHECK(options.penetration_max >= options.penetration_min);
    CD_CHECK(options.penetration_max <= 1);
    return [options, bodies = measure(a, b)](std::uint64_t index) {
        Scenario scenario;
        scenario.index = index;
        scenario.poses.b = random_pose(options, bodies, index);
        return scenario;
    };
}

std::vector<Scenario> make_random_poses(const RandomPoses& options,
                                        const ObbTree& a,
                                        const ObbTree& b,
                                        ThreadPool& pool) {
    const ScenarioMaker make = random_scenarios(options, a, b);
    std::vector<Scenario> scenarios(options.count);
    parallel_for(
        pool, scenarios.size(), [&](std::size_t index) { scenarios[index] = make(index); });
    return scenarios;
}

} // namespace cd
