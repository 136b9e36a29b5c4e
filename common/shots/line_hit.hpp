// Where and how a line meets triangles.
#pragma once

#include "common/geometry/types.hpp"

#include <algorithm>
#include <cstdint>

namespace cd {

/// A segment from p to q, in its body's coordinates.
struct Segment {
    Vec3 p;
    Vec3 q;

    /// Returns the triangle without area that the segment is in a mesh.
    [[nodiscard]] Corners corners() const { return {p, q, q}; }
};

/// Bits that tell how a segment meets a triangle. The hit is the first shared point, seen from p.
/// `front` and `back` exclude each other; a segment that lies in the triangle's plane, and one that
/// meets a triangle without area, has neither. So do `edge` and `corner`, which inner points lack.
namespace hit_flag {

inline constexpr std::uint8_t crosses = 1; ///< Counts as a crossing: see SegmentHit.
inline constexpr std::uint8_t front =
    2; ///< The segment meets the face against its normal: it enters.
inline constexpr std::uint8_t back = 4; ///< The segment meets the face along its normal: it leaves.
inline constexpr std::uint8_t edge = 8; ///< The hit is inside an edge of the triangle.
inline constexpr std::uint8_t corner = 16; ///< The hit is a corner of the triangle.
inline constexpr std::uint8_t all = 31;    ///< All bits that are in use.

} // namespace hit_flag

/// Ranks of a line's hits end here: further exact depths that round alike have this one, too.
inline constexpr std::uint8_t hit_rank_most = 255;

/// One triangle that a line meets.
struct LineHit {
    std::uint32_t triangle = 0; ///< Its place among the given triangles.
    std::uint8_t flags = 0;     ///< See `hit_flag`.
    /// Counts the line's distinct exact depths that are less and round to the same depth.
    std::uint8_t rank = 0;
    double depth = 0; ///< The exact distance from p along the segment, rounded once.

    friend bool operator==(const LineHit&, const LineHit&) = default;
};

/// Returns whether two triangles have the same three corners, in any order. A line passes through
/// both at one exact depth.
[[nodiscard]] inline bool are_coincident(const Corners& l, const Corners& r) {
    return std::is_permutation(l.begin(), l.end(), r.begin());
}

/// The order of a line's hits at one exact depth: leaving hits come before entering ones, and these
/// before others.
[[nodiscard]] inline int order_at_one_depth(std::uint8_t flags) {
    return (flags & hit_flag::back) != 0 ? 0 : (flags & hit_flag::front) != 0 ? 1 : 2;
}

} // namespace cd
