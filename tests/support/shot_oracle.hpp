// Exact reference for lines that meet triangles, in integers and rationals. Shares no code with the
// engine.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/shots/line_hit.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd::tests {

/// A triangle that a segment meets.
struct OracleHit {
    std::uint32_t triangle = 0;
    std::uint8_t flags = 0;
    mpq_class lambda; ///< The share of the segment before the hit.
};

/// Returns the hit of one triangle; nothing if it shares no point with the segment. Finds the first
/// corner of the shared set, and moves the segment by a real number eps to see whether it crosses.
[[nodiscard]] std::optional<OracleHit>
oracle_hit(const Corners& a, const Segment& line, const PosePair& poses);

/// Returns the hits of a line in exact order.
[[nodiscard]] std::vector<OracleHit>
oracle_hits(std::span<const Corners> a, const Segment& line, const PosePair& poses);

/// Returns the hits as the engine should tell them: with rounded depths and ranks.
[[nodiscard]] std::vector<LineHit> rounded_hits(std::span<const OracleHit> hits,
                                                const Segment& line);

/// Returns the length of a segment, rounded to the nearest finite double.
[[nodiscard]] double oracle_length(const Segment& line);

} // namespace cd::tests
