// Random scenarios, which collide.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace cd {

class ObbTree;
class ThreadPool;
struct Scenario;

/// Parameters of the paper's scenarios (section 7). B approaches in a random orientation from a
/// random direction until it first collides with A, then moves further by a random share in
/// [penetration_min, penetration_max] of the diagonal of B's box. Readers of a job check that 0 <=
/// penetration_min <= penetration_max <= 1.
struct RandomPoses {
    std::uint64_t count = 1000;
    std::uint64_t seed = 1;
    double penetration_min = 0.005;
    double penetration_max = 0.05;

    friend bool operator==(const RandomPoses&, const RandomPoses&) = default;
};

/// Computes the job's scenario with a given index. The scenario depends on the index alone. Any
/// thread may call the function.
using ScenarioMaker = std::function<Scenario(std::uint64_t)>;

/// Returns a maker of single random scenarios, equal to those of `make_random_poses`. The trees
/// outlive the maker.
[[nodiscard]] ScenarioMaker
random_scenarios(const RandomPoses& options, const ObbTree& a, const ObbTree& b);

/// Makes random scenarios, equal on every host and for any number of threads. B's poses are
/// quaternions, A's the identity. A scenario depends on the bodies, its index, the seed and the
/// penetration bounds alone, not on `count`.
///
/// B approaches the centre of A's box along a straight line. The first collision is at the first of
/// 32 steps at which the bodies collide, refined to about 1/32,000 of the way. If a line reaches
/// A's centre without a collision, another direction and orientation are drawn; after 64 such lines
/// B stays at the centre.
[[nodiscard]] std::vector<Scenario>
make_random_poses(const RandomPoses& options, const ObbTree& a, const ObbTree& b, ThreadPool& pool);

} // namespace cd
