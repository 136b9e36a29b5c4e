// One pair of poses to test, and the packed blocks in which poses are sent.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

struct Scenario {
    std::uint64_t index = 0;  ///< Index in the job as submitted, from 0.
    std::uint32_t body_a = 0; ///< Index of body A in the job's list of bodies.
    std::uint32_t body_b = 1;
    PosePair poses;

    friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// Packs scenarios: the exact numbers of their poses and no more, little-endian. Only -0 may be
/// unpacked as 0.
///
/// Version (u8, 1) and count, then runs: scenarios with consecutive indices, equal bodies and equal
/// forms of poses. A run: forms (u8: A's in bits 0-1, B's in 2-3), length, first index minus the
/// index that would continue the previous run (zigzag; 0 for the first run), body_a, body_b; then
/// for each scenario the doubles of A's pose and of B's. Forms: 0 identity, 1 translation, 2 matrix
/// (rows, then translation), 3 quaternion (w x y z, then translation). Integers are varints
/// (varint.hpp) unless marked u8. A run in which a scenario has no doubles has length 1.
[[nodiscard]] Bytes pack_scenarios(std::span<const Scenario> scenarios);

/// Unpacks the bytes of `pack_scenarios`, which are untrusted; `count_max` scenarios bound memory.
/// Errors: BadFrame; TooLarge if there are more; BadInput naming the scenario whose pose is not
/// finite or whose quaternion is zero.
[[nodiscard]] Result<std::vector<Scenario>> unpack_scenarios(std::span<const std::byte> bytes,
                                                             std::uint64_t count_max);

} // namespace cd
