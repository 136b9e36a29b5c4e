// The length of a segment.
#pragma once

#include "common/shots/line_hit.hpp"

namespace cd {

/// Returns the length in the segment's own coordinates, rounded once to the nearest finite double,
/// ties to even.
[[nodiscard]] double segment_length(const Segment& segment);

} // namespace cd
