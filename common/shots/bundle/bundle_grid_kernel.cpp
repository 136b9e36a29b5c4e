// A triangle's bounding box holds a rectangle of the grid's lines. Most triangles of a fine mesh
// have few lines: the kernel lists the pairs of all these triangles without branches and decides a
// vector of pairs at a time. It decides other triangles row by row, a vector of lines at a time.
#include "common/shots/bundle/bundle_grid_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>
#include <span>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_grid_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/shots/bundle/bundle_columns-inl.hpp"
#include "common/shots/bundle/bundle_turns-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle_grid {

namespace hn = hwy::HWY_NAMESPACE;

using bundle::Doubles;
using bundle::lanes;
using bundle::Marks;
using bundle::Target;
using bundle::V;

/// A triangle has few lines if its box holds at most this many.
constexpr std::uint32_t few = 4;

/// A range of columns or rows.
struct Span {
    std::uint32_t first;
    std::uint32_t count;
};

/// The lines of each triangle.
class Spans {
  public:
    HWY_INLINE Spans(const BlockAcross& placed, const BundleAcross& bundle) {
        for (std::size_t begin = 0; begin < placed.count; begin += lanes) {
            for (std::size_t which = 0; which < 2; ++which) {
                find(bundle.axes[which],
                     &placed.low[which][begin],
                     &placed.high[which][begin],
                     &first_[which][begin],
                     &count_[which][begin]);
            }
        }
        for (std::uint32_t triangle = 0; triangle < placed.count; ++triangle) {
            const std::uint32_t lines = count_[0][triangle] * count_[1][triangle];
            of_many_ |= static_cast<std::uint32_t>(lines > few) << triangle;
            few_[few_count_] = static_cast<std::uint8_t>(triangle);
            few_count_ += lines - 1 < few ? 1 : 0;
        }
    }

    [[nodiscard]] HWY_INLINE Span columns(std::size_t triangle) const {
        return {first_[0][triangle], count_[0][triangle]};
    }
    [[nodiscard]] HWY_INLINE Span rows(std::size_t triangle) const {
        return {first_[1][triangle], count_[1][triangle]};
    }
    /// Returns a bit mask of the triangles that have more than a few lines.
    [[nodiscard]] HWY_INLINE std::uint32_t of_many() const { return of_many_; }
    /// Returns the triangles that have few lines, but at least one.
    [[nodiscard]] HWY_INLINE std::span<const std::uint8_t> of_few() const {
        return {few_, few_count_};
    }

  private:
    /// Computes the ranges of columns or rows in the boxes of a vector of triangles, on one axis. A
    /// computed number is off by less than the slack, so the ranges hold all lines of the boxes and
    /// perhaps some that are just outside.
    static HWY_INLINE void find(const BundleAcross::Axis& axis,
                                const double* low,
                                const double* high,
                                std::uint32_t* first,
                                std::uint32_t* count) {
        const Doubles d;
        const hn::Rebind<std::int32_t, Doubles> whole;
        const hn::Rebind<std::uint32_t, Doubles> bits;
        const V least = hn::Set(d, axis.least);
        const V per_length = hn::Set(d, axis.steps_per_length);
        const V slack = hn::Set(d, axis.slack);
        const V end = hn::Set(d, axis.last_bin + 1);
        const auto place = [&](const double* of) {
            return hn::Mul(hn::Sub(hn::Load(d, of), least), per_length);
        };
        const V from = hn::Min(hn::Max(hn::Ceil(hn::Sub(place(low), slack)), hn::Zero(d)), end);
        const V to = hn::Min(hn::Floor(hn::Add(hn::Add(place(high), slack), hn::Set(d, 1))), end);
        const auto store = [&](V value, std::uint32_t* at) {
            hn::Store(hn::BitCast(bits, hn::DemoteTo(whole, value)), bits, at);
        };
        store(from, first);
        store(hn::Max(hn::Sub(to, from), hn::Zero(d)), count);
    }

    alignas(64) std::uint32_t first_[2][block_size]; ///< Of columns and of rows.
    alignas(64) std::uint32_t count_[2][block_size];
    std::uint32_t of_many_ = 0;
    std::size_t few_count_ = 0;
    std::uint8_t few_[block_size];
};

/// The pairs of triangles that have few lines, by triangle.
struct Pairs {
    static constexpr std::size_t most = block_size * few;
    /// A write of `few` lines may exceed `count`. The last vector is filled up with a valid
    /// triangle and line.
    static constexpr std::size_t spare = std::max(few, lanes);

    std::uint32_t count = 0;
    alignas(16) std::uint32_t lines[most + spare];
    std::uint8_t triangles[most + spare];

    HWY_INLINE Pairs(const Spans& spans, std::uint32_t columns) {
        // The lines of a triangle relative to its first one, by its number of columns.
        const std::uint32_t from_first[few + 1][few] = {{},
                                                        {0, columns, 2 * columns, 3 * columns},
                                                        {0, 1, columns, columns + 1},
                                                        {0, 1, 2, 3},
                                                        {0, 1, 2, 3}};
        for (const std::uint8_t triangle : spans.of_few()) {
            const Span of_columns = spans.columns(triangle);
            const Span of_rows = spans.rows(triangle);
            const std::uint32_t first = of_rows.first * columns + of_columns.first;
            for (std::uint32_t i = 0; i < few; ++i) {
                lines[count + i] = first + from_first[of_columns.count][i];
                triangles[count + i] = triangle;
            }
            count += of_columns.count * of_rows.count;
        }
        std::fill_n(lines + count, lanes, 0u);
        std::fill_n(triangles + count, lanes, std::uint8_t{0});
    }
};

/// Corners of a block's triangles, projected along the lines, stored triangle by triangle.
struct CornersInTurn {
    alignas(64) bundle::Row first_two[block_size]; ///< Each x and y.
    alignas(64) bundle::Row third[block_size];     ///< Followed by the bound of turns.

    HWY_INLINE explicit CornersInTurn(const BlockAcross& placed) {
        const Doubles d;
        for (std::size_t i = 0; i < placed.count; i += lanes) {
            const auto corner = [&](std::size_t which, std::size_t number) {
                return hn::Load(d, &placed.corners[1 + which][number][i]);
            };
            const V error = hn::Load(d, &placed.turn_error[i]);
            hn::StoreInterleaved4(
                corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1), d, first_two[i]);
            hn::StoreInterleaved4(corner(0, 2), corner(1, 2), error, error, d, third[i]);
        }
    }
    /// Returns a vector of triangles: lane i has the triangle `triangles[i]`.
    [[nodiscard]] HWY_INLINE Target target(const std::uint8_t* triangles) const {
        const bundle::Columns first(Doubles(),
                                    [&](std::size_t i) { return first_two[triangles[i]]; });
        const bundle::Columns second(Doubles(), [&](std::size_t i) { return third[triangles[i]]; });
        Target target;
        target.x[0] = first.at[0];
        target.y[0] = first.at[1];
        target.x[1] = first.at[2];
        target.y[1] = first.at[3];
        target.x[2] = second.at[0];
        target.y[2] = second.at[1];
        target.error = second.at[2];
        return target;
    }
};

/// Bit masks of pairs.
struct FewMarks {
    std::uint64_t left = 0;
    std::uint64_t right = 0;
    std::uint64_t open = 0;
};

HWY_INLINE FewMarks marks_of(const Pairs& pairs, const BlockAcross& placed, const LineRows& lines) {
    static_assert(Pairs::most <= 64);
    const CornersInTurn corners(placed);
    FewMarks marks;
    for (std::uint32_t i = 0; i < pairs.count; i += lanes) {
        const Doubles d;
        const std::uint32_t valid =
            pairs.count - i >= lanes ? (1u << lanes) - 1 : (1u << (pairs.count - i)) - 1;
        const Marks each = bundle::marks_of(corners.target(pairs.triangles + i),
                                            bundle::load_each(d, lines.across[0], pairs.lines + i),
                                            bundle::load_each(d, lines.across[1], pairs.lines + i),
                                            valid);
        marks.left |= std::uint64_t{each.left} << i;
        marks.right |= std::uint64_t{each.right} << i;
        marks.open |= std::uint64_t{each.open} << i;
    }
    return marks;
}

/// Marks the pairs of triangles that have few lines.
void mark_few(const BlockAcross& placed,
              const Spans& spans,
              const LineRows& lines,
              MarkedPairs& to) {
    const Pairs pairs(spans, lines.columns);
    const FewMarks marks = marks_of(pairs, placed, lines);
    to.tested += pairs.count;
    std::uint64_t passing = marks.left | marks.right;
    std::uint64_t open = marks.open;
    if (placed.between != (1u << placed.count) - 1) {
        for (std::uint32_t i = 0; i < pairs.count; ++i) {
            const std::uint64_t is_between = placed.between >> pairs.triangles[i] & 1;
            open |= passing & (is_between ^ 1) << i;
        }
        passing &= ~open;
    }
    std::uint32_t runs = 0;
    std::uint32_t passes = 0;
    MarkedPairs::Run run{block_size, 0, false};
    for (; passing != 0; passing &= passing - 1) {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero64(passing);
        const std::uint32_t triangle = pairs.triangles[i];
        const bool is_new = triangle != run.triangle;
        run = {triangle, is_new ? passes : run.begin, (marks.left >> i & 1) != 0};
        runs += is_new ? 1 : 0;
        to.of_triangles[runs - 1] = run;
        to.passing[passes++] = pairs.lines[i];
    }
    to.runs = runs;
    to.passes = passes;
    for (; open != 0; open &= open - 1) {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero64(open);
        to.open_triangles[to.open] = pairs.triangles[i];
        to.open_lines[to.open++] = pairs.lines[i];
    }
}

/// Appends the selected lines of a vector of consecutive lines to the `passes` lines that pass, and
/// returns their new count. With few lanes a loop without branches is faster than CompressBits,
/// which reads a table.
HWY_INLINE std::uint32_t
add_passing(std::uint32_t which, std::uint32_t first, std::uint32_t passes, MarkedPairs& to) {
    if constexpr (lanes <= 4) {
        for (std::uint32_t i = 0; i < lanes; ++i) {
            to.passing[passes] = first + i;
            passes += which >> i & 1;
        }
        return passes;
    } else {
        const hn::Rebind<std::uint32_t, Doubles> d;
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(which)};
        hn::StoreU(hn::CompressBits(hn::Iota(d, first), bits), d, &to.passing[passes]);
        return passes + static_cast<std::uint32_t>(hwy::PopCount(which));
    }
}

/// Marks the pairs of a triangle that has many lines, from `walk` on. Returns false if there is no
/// more room.
bool mark_many(const BlockAcross& placed,
               const Spans& spans,
               const LineRows& lines,
               LineWalk& walk,
               MarkedPairs& to) {
    const Doubles d;
    const std::uint32_t triangle = walk.triangle;
    const Span columns = spans.columns(triangle);
    const Span rows = spans.rows(triangle);
    const Target target(placed, triangle);
    const std::uint32_t passing_lanes = (placed.between >> triangle & 1) != 0 ? ~0u : 0u;
    // Local counters stay in registers. Members of `to` do not, since writes to it may alias them.
    std::uint32_t row = walk.row;
    std::uint32_t done = walk.line;
    std::uint32_t tested = 0;
    std::uint32_t passes = to.passes;
    std::uint32_t left = 0;
    while (row < rows.count && std::max(passes, to.open) + lanes <= MarkedPairs::most) {
        const std::uint32_t line = (rows.first + row) * lines.columns + columns.first + done;
        const std::uint32_t count = std::min(columns.count - done, lanes);
        tested += count;
        const Marks marks = bundle::marks_of(target,
                                             hn::LoadU(d, lines.across[0] + line),
                                             hn::LoadU(d, lines.across[1] + line),
                                             (1u << count) - 1);
        const std::uint32_t inside = marks.left | marks.right;
        left |= marks.left;
        passes = add_passing(inside & passing_lanes, line, passes, to);
        for (std::uint32_t open = marks.open | (inside & ~passing_lanes); open != 0;
             open &= open - 1) {
            to.open_triangles[to.open] = static_cast<std::uint8_t>(triangle);
            to.open_lines[to.open++] =
                line + static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(open));
        }
        const bool is_row_done = done + count == columns.count;
        done = is_row_done ? 0 : done + count;
        row += is_row_done ? 1 : 0;
    }
    to.of_triangles[to.runs] = {triangle, to.passes, left != 0};
    to.runs += passes > to.passes ? 1 : 0;
    to.passes = passes;
    to.tested += tested;
    walk.row = row;
    walk.line = done;
    return row == rows.count;
}

bool mark_grid_pairs_on(const BlockAcross* placed,
                        const BundleAcross* bundle,
                        const LineRows* lines,
                        LineWalk* walk,
                        MarkedPairs* marked) {
    marked->tested = 0;
    marked->runs = 0;
    marked->passes = 0;
    marked->open = 0;
    const Spans spans(*placed, *bundle);
    if (!walk->are_few_done) {
        mark_few(*placed, spans, *lines, *marked);
        walk->are_few_done = true;
    }
    for (; walk->triangle < placed->count; *walk = {walk->triangle + 1, 0, 0, true}) {
        if ((spans.of_many() >> walk->triangle & 1) != 0 &&
            !mark_many(*placed, spans, *lines, *walk, *marked)) {
            return false;
        }
    }
    return true;
}

} // namespace bundle_grid

bool mark_grid_pairs_on(const BlockAcross* placed,
                        const BundleAcross* bundle,
                        const LineRows* lines,
                        LineWalk* walk,
                        MarkedPairs* marked) {
    return bundle_grid::mark_grid_pairs_on(placed, bundle, lines, walk, marked);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(mark_grid_pairs_on);

bool mark_grid_pairs(const BlockAcross& placed,
                     const BundleAcross& bundle,
                     const LineRows& lines,
                     LineWalk& walk,
                     MarkedPairs& marked) {
    return HWY_DYNAMIC_DISPATCH(mark_grid_pairs_on)(&placed, &bundle, &lines, &walk, &marked);
}

} // namespace cd

#endif
