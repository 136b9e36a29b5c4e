// A triangle's bounding box holds a rectangle of the grid's lines. Most triangles of a fine mesh
// have few lines: the kernel lists their pairs without branches, then decides each pair with all
// three edges in one vector. It decides other triangles row by row, a vector of lines at a time.
#include "common/shots/bundle/bundle_grid_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_grid_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/shots/bundle/bundle_turns-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle_grid {

namespace hn = hwy::HWY_NAMESPACE;

using bundle::bits_of;
using bundle::Doubles;
using bundle::lanes;
using bundle::Marks;
using bundle::Target;
using bundle::V;

/// A triangle has few lines if its box holds at most this many columns and rows.
constexpr std::uint32_t few = 4;

/// A range of columns or rows.
struct Span {
    std::uint32_t first;
    std::uint32_t count;
};

/// Returns the range of columns or rows whose coordinates are in a triangle's box. Each bin of a
/// grid has one column or row.
HWY_INLINE Span span_of(const BlockAcross& placed,
                        const BundleAcross& bundle,
                        std::size_t which,
                        std::size_t triangle) {
    const double* const coordinates = bundle.axes[which].least_of_bins;
    std::int32_t first = placed.first[which][triangle];
    std::int32_t last = placed.last[which][triangle];
    first += coordinates[first] < placed.low[which][triangle] ? 1 : 0;
    last -= coordinates[last] > placed.high[which][triangle] ? 1 : 0;
    return {static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(std::max(last + 1 - first, 0))};
}

/// The lines of each triangle.
struct Spans {
    Span columns[block_size];
    Span rows[block_size];
    std::uint32_t of_many = 0; ///< Bit mask of the triangles that have more than a few lines.

    HWY_INLINE Spans(const BlockAcross& placed, const BundleAcross& bundle) {
        for (std::uint32_t triangle = 0; triangle < placed.count; ++triangle) {
            const Span c = span_of(placed, bundle, 0, triangle);
            const Span r = span_of(placed, bundle, 1, triangle);
            columns[triangle] = c;
            rows[triangle] = r;
            const bool is_of_many =
                (c.count > few || r.count > few) && c.count != 0 && r.count != 0;
            of_many |= static_cast<std::uint32_t>(is_of_many) << triangle;
        }
    }

    [[nodiscard]] HWY_INLINE bool is_of_many(std::uint32_t triangle) const {
        return (of_many >> triangle & 1) != 0;
    }
};

/// The pairs of triangles that have few lines, by triangle.
struct Pairs {
    static constexpr std::size_t most = block_size * few * few;

    std::uint32_t count = 0;
    std::uint32_t end_of[block_size]; ///< The end of each triangle's pairs.
    std::uint32_t lines[most + few];  ///< Writes go in groups of `few`, so they may pass `count`.
    std::uint8_t triangles[most + few];

    HWY_INLINE Pairs(const BlockAcross& placed, const Spans& spans, std::uint32_t columns) {
        for (std::uint32_t triangle = 0; triangle < placed.count; ++triangle) {
            if (!spans.is_of_many(triangle)) {
                add(triangle, spans.columns[triangle], spans.rows[triangle], columns);
            }
            end_of[triangle] = count;
        }
    }

  private:
    /// Adds the pairs of a triangle. Has no branch on the number of rows, which a processor cannot
    /// predict.
    HWY_INLINE void add(std::uint32_t triangle, Span column, Span row, std::uint32_t columns) {
        std::uint32_t line = row.first * columns + column.first;
        for (std::uint32_t i = 0; i < few; ++i) {
            for (std::uint32_t k = 0; k < few; ++k) {
                lines[count + k] = line + k;
                triangles[count + k] = static_cast<std::uint8_t>(triangle);
            }
            count += i < row.count ? column.count : 0;
            line += columns;
        }
    }
};

/// The end points of a triangle's edges, projected along the lines. The fourth edge repeats the
/// first one.
struct Edges {
    alignas(32) double from_x[4];
    alignas(32) double from_y[4];
    alignas(32) double to_x[4];
    alignas(32) double to_y[4];

    HWY_INLINE Edges() {}

    HWY_INLINE void set(const BlockAcross& placed, std::size_t triangle) {
        for (std::size_t i = 0; i < 4; ++i) {
            from_x[i] = placed.corners[1][i % 3][triangle];
            from_y[i] = placed.corners[2][i % 3][triangle];
            to_x[i] = placed.corners[1][(i + 1) % 3][triangle];
            to_y[i] = placed.corners[2][(i + 1) % 3][triangle];
        }
    }
};

/// For each edge of a triangle one bit: whether it certainly turns left, or right, around a line.
struct EdgeSigns {
    std::uint32_t left = 0;
    std::uint32_t right = 0;

    static constexpr std::uint32_t all = 7;

    HWY_INLINE EdgeSigns(const Edges& edges, double error, double line_x, double line_y) {
        const hn::CappedTag<double, 4> d;
        const auto x = hn::Set(d, line_x);
        const auto y = hn::Set(d, line_y);
        for (std::size_t i = 0; i < 4; i += hn::MaxLanes(d)) {
            const auto turns = bundle::turn(hn::Sub(hn::Load(d, edges.from_x + i), x),
                                            hn::Sub(hn::Load(d, edges.from_y + i), y),
                                            hn::Sub(hn::Load(d, edges.to_x + i), x),
                                            hn::Sub(hn::Load(d, edges.to_y + i), y));
            left |= bits_of(d, hn::Gt(turns, hn::Set(d, error))) << i;
            right |= bits_of(d, hn::Lt(turns, hn::Set(d, -error))) << i;
        }
        left &= all;
        right &= all;
    }
};

/// Marks the pairs of triangles that have few lines.
void mark_few(const BlockAcross& placed,
              const Spans& spans,
              const LineRows& lines,
              MarkedPairs& to) {
    const Pairs pairs(placed, spans, lines.columns);
    Edges edges[block_size];
    for (std::uint32_t triangle = 0; triangle < placed.count; ++triangle) {
        edges[triangle].set(placed, triangle);
    }
    to.tested += pairs.count;
    std::uint32_t turning_left = 0;
    std::uint32_t passes[Pairs::most]; // The number of lines that pass, after each pair.
    for (std::uint32_t i = 0; i < pairs.count; ++i) {
        const std::uint32_t triangle = pairs.triangles[i];
        const std::uint32_t line = pairs.lines[i];
        const EdgeSigns signs(edges[triangle],
                              placed.turn_error[triangle],
                              lines.across[0][line],
                              lines.across[1][line]);
        const std::uint32_t is_left = signs.left == EdgeSigns::all ? 1u : 0u;
        const std::uint32_t is_right = signs.right == EdgeSigns::all ? 1u : 0u;
        const std::uint32_t is_inside = is_left | is_right;
        const std::uint32_t is_passing = is_inside & placed.between >> triangle;
        const bool is_missing = (signs.left != 0) & (signs.right != 0);
        turning_left |= is_left << triangle;
        to.passing[to.passes] = line;
        to.passes += is_passing;
        passes[i] = to.passes;
        if (!is_missing && is_passing == 0) {
            to.open_triangles[to.open] = static_cast<std::uint8_t>(triangle);
            to.open_lines[to.open++] = line;
        }
    }
    std::uint32_t begin = 0;
    for (std::uint32_t triangle = 0; triangle < placed.count; ++triangle) {
        const std::uint32_t of = pairs.end_of[triangle];
        const std::uint32_t end = of == 0 ? 0 : passes[of - 1];
        to.of_triangles[to.runs] = {triangle, begin, (turning_left >> triangle & 1) != 0};
        to.runs += end > begin ? 1 : 0;
        begin = end;
    }
}

/// Appends the selected lines of a vector of consecutive lines to those that pass. With few lanes
/// a loop without branches is faster than CompressBits, which reads a table.
HWY_INLINE void add_passing(std::uint32_t which, std::uint32_t first, MarkedPairs& to) {
    if constexpr (lanes <= 4) {
        for (std::uint32_t i = 0; i < lanes; ++i) {
            to.passing[to.passes] = first + i;
            to.passes += which >> i & 1;
        }
    } else {
        const hn::Rebind<std::uint32_t, Doubles> d;
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(which)};
        hn::StoreU(hn::CompressBits(hn::Iota(d, first), bits), d, &to.passing[to.passes]);
        to.passes += static_cast<std::uint32_t>(hwy::PopCount(which));
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
    const Span columns = spans.columns[triangle];
    const Span rows = spans.rows[triangle];
    const Target target(placed, triangle);
    const std::uint32_t passing_lanes = (placed.between >> triangle & 1) != 0 ? ~0u : 0u;
    MarkedPairs::Run& run = to.of_triangles[to.runs];
    run = {triangle, to.passes, false};
    bool has_room = std::max(to.passes, to.open) + lanes <= MarkedPairs::most;
    while (walk.row < rows.count && has_room) {
        const std::uint32_t line =
            (rows.first + walk.row) * lines.columns + columns.first + walk.line;
        const std::uint32_t count = std::min(columns.count - walk.line, lanes);
        to.tested += count;
        const Marks marks = bundle::marks_of(target,
                                             hn::LoadU(d, lines.across[0] + line),
                                             hn::LoadU(d, lines.across[1] + line),
                                             (1u << count) - 1);
        const std::uint32_t inside = marks.left | marks.right;
        run.turns_left |= marks.left != 0;
        add_passing(inside & passing_lanes, line, to);
        for (std::uint32_t open = marks.open | (inside & ~passing_lanes); open != 0;
             open &= open - 1) {
            to.open_triangles[to.open] = static_cast<std::uint8_t>(triangle);
            to.open_lines[to.open++] =
                line + static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(open));
        }
        walk.line += count;
        if (walk.line == columns.count) {
            walk.line = 0;
            ++walk.row;
        }
        has_room = std::max(to.passes, to.open) + lanes <= MarkedPairs::most;
    }
    to.runs += to.passes > run.begin ? 1 : 0;
    return walk.row == rows.count;
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
        if (spans.is_of_many(walk->triangle) &&
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
