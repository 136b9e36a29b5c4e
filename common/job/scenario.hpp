// One pose of two bodies to be tested, and the blocks in which poses travel.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

struct Scenario {
    std::uint64_t index = 0;  ///< Place in the job as submitted, from 0.
    std::uint32_t body_a = 0; ///< Places in the job's list of bodies.
    std::uint32_t body_b = 1;
    PosePair poses;

    friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// Scenarios as bytes: the exact numbers of their poses and no more, little-endian.
[[nodiscard]] Bytes pack_scenarios(std::span<const Scenario> scenarios);

/// The inverse. The bytes may be hostile. Errors: BadFrame; BadInput naming the scenario whose pose
/// is not finite or whose quaternion is zero.
[[nodiscard]] Result<std::vector<Scenario>> unpack_scenarios(std::span<const std::byte> bytes);

} // namespace cd
