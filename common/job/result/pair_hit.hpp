// Where lines meet triangles, as a record has it.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The hit of a pair whose triangle of B is a line (common/shots/line_hit.hpp).
struct PairHit {
    double depth = 0;       ///< From the line's start, in B's unit, rounded once.
    std::uint8_t flags = 0; ///< See `hit_flag`.
    /// Counts the line's distinct exact depths that are less and round to the same depth.
    std::uint8_t rank = 0;

    friend bool operator==(const PairHit&, const PairHit&) = default;
};

/// Encodes depths, then flags, then ranks (result.hpp).
void put_hits(ByteWriter& out, std::span<const PairHit> hits);
/// Decodes the bytes of `put_hits` for `count` hits. Errors: BadFrame.
[[nodiscard]] Status get_hits(ByteReader& in, std::size_t count, std::vector<PairHit>& hits);
/// The number of bytes that `put_hits` writes for a hit.
inline constexpr std::uint64_t hit_bytes = sizeof(double) + 2;

} // namespace cd
