// One pair of poses to test.
#pragma once

#include "common/geometry/pose.hpp"

#include <cstdint>

namespace cd {

struct Scenario {
    std::uint64_t index = 0;  ///< Index in the job as submitted, from 0.
    std::uint32_t body_a = 0; ///< Index of body A in the job's list of bodies.
    std::uint32_t body_b = 1;
    PosePair poses;

    friend bool operator==(const Scenario&, const Scenario&) = default;
};

} // namespace cd
