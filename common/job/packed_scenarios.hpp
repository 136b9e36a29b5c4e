// The packed form in which scenarios are sent and stored. A part of a packed list can be sent
// without unpacking it.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/job/scenario.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Packs scenarios: their indices and the exact numbers of their poses, little-endian. Only -0 may
/// be unpacked as 0.
///
/// Version (u8, 2) and count, then runs: scenarios with equal bodies and equal forms of poses,
/// whose indices differ by less than 2^32. A run: forms (u8: A's in bits 0-1, B's in 2-3; bit 4: of
/// a scene; bit 5: motions; bit 6: motions in which A rests), length, body_a, body_b and the least
/// index; then for each scenario its index minus the least (u32), in a scene its step (u64), the
/// doubles of A's pose and of B's, and of a motion those of A's pose at its end, unless A rests,
/// and of B's. Forms: 0 identity, 1 translation, 2 matrix (rows, then translation), 3 quaternion (w
/// x y z, then translation); motions have quaternions. Integers are varints (varint.hpp) unless
/// marked u8 or u32.
[[nodiscard]] Bytes pack_scenarios(std::span<const Scenario> scenarios);

/// Returns the number of bytes that the scenario takes in a run of `pack_scenarios`.
[[nodiscard]] std::size_t packed_bytes(const Scenario& scenario);

/// Unpacks the bytes of `pack_scenarios`, which are untrusted; `count_max` scenarios bound memory.
/// Errors: BadFrame; TooLarge if there are more; BadInput naming the scenario whose pose is not
/// finite or whose quaternion is zero.
[[nodiscard]] Result<std::vector<Scenario>> unpack_scenarios(std::span<const std::byte> bytes,
                                                             std::uint64_t count_max);

/// The bodies and step of a packed scenario, which are found without unpacking its poses.
struct ScenarioBodies {
    std::uint32_t a = 0;
    std::uint32_t b = 1;
    std::optional<std::uint64_t> step = {};

    friend bool operator==(const ScenarioBodies&, const ScenarioBodies&) = default;
};

/// A packed list whose runs are known, so that each scenario is found by its place in the list. A
/// pose is checked when it is read.
class PackedScenarios {
  public:
    /// `bytes` are those of `pack_scenarios`, untrusted. Errors: BadFrame; TooLarge for more than
    /// `count_max` scenarios.
    [[nodiscard]] static Result<PackedScenarios> open(Bytes bytes, std::uint64_t count_max);

    [[nodiscard]] std::uint64_t count() const {
        return runs_.empty() ? 0 : runs_.back().first + runs_.back().count;
    }
    [[nodiscard]] const Bytes& bytes() const { return bytes_; }
    /// The index, as submitted, of scenario number i of the list, which must exist.
    [[nodiscard]] std::uint64_t index_at(std::uint64_t i) const;
    /// The bodies and step of scenario number i of the list, which must exist.
    [[nodiscard]] ScenarioBodies bodies_at(std::uint64_t i) const;
    /// Unpacks scenario number i of the list, which must exist. Errors: BadInput naming a scenario
    /// whose pose is not finite or whose quaternion is zero.
    [[nodiscard]] Result<Scenario> at(std::uint64_t i) const;

    /// Scenarios [first, first + count) of a list, which must exist.
    struct Slice {
        const PackedScenarios* list = nullptr;
        std::uint64_t first = 0;
        std::uint64_t count = 0;
    };
    /// Packs the scenarios of the slices in turn, without unpacking them.
    [[nodiscard]] static Bytes join(std::span<const Slice> slices);

  private:
    /// The properties that the scenarios of a run share, and its position in the bytes.
    struct Run {
        std::uint8_t forms = 0;
        std::uint32_t body_a = 0;
        std::uint32_t body_b = 0;
        std::uint64_t index_least = 0;
        std::uint64_t first = 0; ///< Number of scenarios in the runs before this one.
        std::uint64_t count = 0;
        std::size_t offset = 0; ///< Offset of the first scenario in the bytes.
    };
    [[nodiscard]] static std::optional<Run> get_run(ByteReader& in);
    [[nodiscard]] std::size_t run_of(std::uint64_t i) const;
    [[nodiscard]] std::span<const std::byte>
    bytes_of(const Run& run, std::uint64_t i, std::uint64_t count) const;

    Bytes bytes_;
    std::vector<Run> runs_;
};

} // namespace cd
