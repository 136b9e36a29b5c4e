#include "common/shots/bundle/bundle_marks_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_marks_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/shots/bundle/bundle_turns-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle_marks {

namespace hn = hwy::HWY_NAMESPACE;

using bundle::Doubles;
using bundle::lanes;
using bundle::Marks;
using bundle::Target;
using bundle::V;

/// Lines that follow each other in one row.
struct Piece {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

// A row of a small triangle's box has few lines, so that a vector of many lanes takes two pieces.
#if HWY_MAX_BYTES >= 32
constexpr std::uint32_t pieces = 2;

HWY_INLINE V load(const double* from, const Piece& low, const Piece& high) {
    const hn::Half<Doubles> half;
    return hn::Combine(
        Doubles(), hn::LoadU(half, from + high.first), hn::LoadU(half, from + low.first));
}
#else
constexpr std::uint32_t pieces = 1;

HWY_INLINE V load(const double* from, const Piece& low, const Piece&) {
    return hn::LoadU(Doubles(), from + low.first);
}
#endif

constexpr std::uint32_t piece_most = lanes / pieces;

/// The lines of a vector.
struct Pieces {
    Piece low;
    Piece high; ///< Empty if vectors take one piece.

    [[nodiscard]] HWY_INLINE std::uint32_t valid() const {
        return ((1u << low.count) - 1) | ((1u << high.count) - 1) << piece_most;
    }
    [[nodiscard]] HWY_INLINE std::uint32_t line_of(std::uint32_t lane) const {
        return lane < piece_most ? low.first + lane : high.first + (lane - piece_most);
    }
};

/// Adds the lines of a vector to those that pass through the present triangle, without a branch:
/// whether a small triangle is hit is hard to predict. Writes a whole vector, and counts the
/// lanes `which`.
HWY_INLINE void add_passing(std::uint32_t which, const Pieces& of, MarkedPairs& to) {
    const hn::Rebind<std::uint32_t, Doubles> d;
    const auto lines = hn::IfThenElse(hn::FirstN(d, piece_most),
                                      hn::Iota(d, of.low.first),
                                      hn::Iota(d, of.high.first - piece_most));
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(which)};
    hn::StoreU(hn::CompressBits(lines, bits), d, &to.passing[to.passes]);
    to.passes += static_cast<std::uint32_t>(hwy::PopCount(which));
}

HWY_INLINE void
add_open(std::uint32_t which, std::uint32_t triangle, const Pieces& of, MarkedPairs& to) {
    for (; which != 0; which &= which - 1) {
        to.open_triangles[to.open] = static_cast<std::uint8_t>(triangle);
        to.open_lines[to.open++] =
            of.line_of(static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(which)));
    }
}

/// The bins of a triangle's box.
struct BinRange {
    std::uint32_t column;
    std::uint32_t column_end;
    std::uint32_t row;
    std::uint32_t rows;

    HWY_INLINE BinRange(const BlockAcross& placed, std::size_t triangle)
        : column(static_cast<std::uint32_t>(placed.first[0][triangle])),
          column_end(static_cast<std::uint32_t>(placed.last[0][triangle]) + 1),
          row(static_cast<std::uint32_t>(placed.first[1][triangle])),
          rows(static_cast<std::uint32_t>(placed.last[1][triangle]) + 1 - row) {}

    /// Advances the walk by a piece, and returns that; an empty one at the end.
    [[nodiscard]] HWY_INLINE Piece next(const LineRows& lines, LineWalk& walk) const {
        for (; walk.row < rows; ++walk.row, walk.line = 0) {
            const std::uint32_t begin = lines.begin_of(column, row + walk.row) + walk.line;
            const std::uint32_t left = lines.begin_of(column_end, row + walk.row) - begin;
            if (left > piece_most) {
                walk.line += piece_most;
                return {begin, piece_most};
            }
            if (left > 0) {
                ++walk.row;
                walk.line = 0;
                return {begin, left};
            }
        }
        return {};
    }
};

/// Returns whether some line may have a coordinate in a triangle's box on one axis. A line in the
/// first bin does if the box begins before the bin's last line, one in the last bin if the box ends
/// behind its first line, and any line between these bins does.
HWY_INLINE bool holds_coordinate(const BlockAcross& placed,
                                 const BundleAcross& bundle,
                                 std::size_t which,
                                 std::size_t triangle) {
    const BundleAcross::Axis& axis = bundle.axes[which];
    const std::int32_t first = placed.first[which][triangle];
    const std::int32_t last = placed.last[which][triangle];
    const bool is_below = placed.low[which][triangle] <= axis.most_of_bins[first];
    const bool is_above = placed.high[which][triangle] >= axis.least_of_bins[last];
    return first == last ? is_below & is_above : is_below | is_above | (last - first > 1);
}

bool mark_pairs_on(const BlockAcross* placed,
                   const BundleAcross* bundle,
                   const LineRows* lines,
                   LineWalk* walk,
                   MarkedPairs* marked) {
    marked->tested = 0;
    marked->runs = 0;
    marked->passes = 0;
    marked->open = 0;
    for (; walk->triangle < placed->count; *walk = {walk->triangle + 1}) {
        const std::uint32_t triangle = walk->triangle;
        if (!(holds_coordinate(*placed, *bundle, 0, triangle) &
              holds_coordinate(*placed, *bundle, 1, triangle))) {
            continue;
        }
        const Target target(*placed, triangle);
        const std::uint32_t passing_lanes = (placed->between >> triangle & 1) != 0 ? ~0u : 0u;
        const BinRange bins(*placed, triangle);
        MarkedPairs::Run& run = marked->of_triangles[marked->runs];
        run = {triangle, marked->passes, false};
        LineWalk in_triangle = *walk;
        bool has_room = true;
        while (in_triangle.row < bins.rows && has_room) {
            Pieces of{bins.next(*lines, in_triangle), {}};
            if (pieces == 2) {
                of.high = bins.next(*lines, in_triangle);
            }
            marked->tested += of.low.count + of.high.count;
            const Marks marks = bundle::marks_of(target,
                                                 load(lines->across[0], of.low, of.high),
                                                 load(lines->across[1], of.low, of.high),
                                                 of.valid());
            const std::uint32_t inside = marks.left | marks.right;
            run.turns_left |= marks.left != 0;
            add_passing(inside & passing_lanes, of, *marked);
            add_open(marks.open | (inside & ~passing_lanes), triangle, of, *marked);
            has_room = std::max(marked->passes, marked->open) + lanes <= MarkedPairs::most;
        }
        marked->runs += marked->passes > run.begin ? 1 : 0;
        if (!has_room) {
            *walk = in_triangle;
            return false;
        }
    }
    return true;
}

} // namespace bundle_marks

bool mark_pairs_on(const BlockAcross* placed,
                   const BundleAcross* bundle,
                   const LineRows* lines,
                   LineWalk* walk,
                   MarkedPairs* marked) {
    return bundle_marks::mark_pairs_on(placed, bundle, lines, walk, marked);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(mark_pairs_on);

bool mark_pairs(const BlockAcross& placed,
                const BundleAcross& bundle,
                const LineRows& lines,
                LineWalk& walk,
                MarkedPairs& marked) {
    return HWY_DYNAMIC_DISPATCH(mark_pairs_on)(&placed, &bundle, &lines, &walk, &marked);
}

} // namespace cd

#endif
