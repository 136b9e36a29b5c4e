// One pair of poses to test, or one motion between two pairs of poses.
#pragma once

#include "common/geometry/pose.hpp"

#include <cstdint>
#include <optional>

namespace cd {

struct Scenario {
    std::uint64_t index = 0;  ///< Index in the job as submitted, from 0.
    std::uint32_t body_a = 0; ///< Index of body A in the job's list of bodies.
    std::uint32_t body_b = 1; ///< Is above `body_a`.
    PosePair poses;           ///< With Question::Motion: at the motion's begin.
    /// In a scene of many bodies, the number of the step; nothing in other jobs.
    std::optional<std::uint64_t> step = {};
    /// With Question::Motion, the poses at the motion's end; these and `poses` are keys on one grid
    /// (motion_keys.hpp). Else nothing.
    std::optional<PosePair> to = {};

    friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// Whether a scenario of a job with so many bodies may have these two: both exist, and A comes
/// before B.
[[nodiscard]] inline bool
are_bodies_of_job(std::uint32_t body_a, std::uint32_t body_b, std::uint64_t bodies) {
    return body_a < body_b && body_b < bodies;
}

} // namespace cd
