// The parameters of random poses.
#pragma once

#include <cstdint>

namespace cd {

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

} // namespace cd
