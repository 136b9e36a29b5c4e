#include "common/tree/wide/wide_boxes_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/wide/wide_boxes_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;
using Steps = hn::Rebind<std::int32_t, Doubles>;
using V = hn::Vec<Doubles>;

constexpr std::size_t lanes = hn::MaxLanes(Doubles());
static_assert(wide_children_max % lanes == 0);

HWY_INLINE V all(double value) {
    return hn::Set(Doubles(), value);
}

struct Vectors {
    V x;
    V y;
    V z;
};

HWY_INLINE Vectors load(const double* from) {
    Vectors v;
    hn::LoadInterleaved3(Doubles(), from, v.x, v.y, v.z);
    return v;
}

HWY_INLINE Vectors load(const float* from) {
    hn::Vec<Floats> x;
    hn::Vec<Floats> y;
    hn::Vec<Floats> z;
    hn::LoadInterleaved3(Floats(), from, x, y, z);
    const Doubles d;
    return {hn::PromoteTo(d, x), hn::PromoteTo(d, y), hn::PromoteTo(d, z)};
}

struct Frame {
    explicit Frame(const SeenFrame& frame)
        : center{all(frame.center[0]), all(frame.center[1]), all(frame.center[2])},
          row_x{all(frame.rows[0]), all(frame.rows[1]), all(frame.rows[2])},
          row_y{all(frame.rows[3]), all(frame.rows[4]), all(frame.rows[5])},
          row_z{all(frame.rows[6]), all(frame.rows[7]), all(frame.rows[8])} {}

    Vectors center;
    Vectors row_x;
    Vectors row_y;
    Vectors row_z;
};

HWY_INLINE V dot(const Vectors& a, const Vectors& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The least and greatest coordinates in a frame, and the reach, of the vertices in each lane.
struct Spreads {
    HWY_INLINE Spreads()
        : low{all(HUGE_VAL), all(HUGE_VAL), all(HUGE_VAL)},
          high{all(-HUGE_VAL), all(-HUGE_VAL), all(-HUGE_VAL)},
          reach(hn::Zero(Doubles())) {}

    HWY_INLINE void add(const Vectors& at, V distance) {
        low = {hn::Min(low.x, at.x), hn::Min(low.y, at.y), hn::Min(low.z, at.z)};
        high = {hn::Max(high.x, at.x), hn::Max(high.y, at.y), hn::Max(high.z, at.z)};
        reach = hn::Max(reach, distance);
    }
    HWY_INLINE Spread over_lanes() const {
        const Doubles d;
        const auto least = [&](V v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
        const auto most = [&](V v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
        return {{least(low.x), least(low.y), least(low.z)},
                {most(high.x), most(high.y), most(high.z)},
                most(reach)};
    }

    Vectors low;
    Vectors high;
    V reach;
};

/// Writes the spread of `count` vertices to `spread`, and their coordinates to `coordinates` unless
/// that is null. Lanes after the last vertex repeat the first vertex.
template <class T>
HWY_INLINE void measure(const T* from,
                        std::size_t count,
                        const SeenFrame& seen,
                        BlockCoordinates* coordinates,
                        Spread* spread) {
    const Doubles d;
    const Frame frame(seen);
    const Vectors first{all(static_cast<double>(from[0])),
                        all(static_cast<double>(from[1])),
                        all(static_cast<double>(from[2]))};
    Spreads spreads;
    for (std::size_t i = 0; i < count; i += lanes) {
        Vectors v = load(from + 3 * i);
        if (i + lanes > count) {
            const auto mask = hn::FirstN(d, count - i);
            v = {hn::IfThenElse(mask, v.x, first.x),
                 hn::IfThenElse(mask, v.y, first.y),
                 hn::IfThenElse(mask, v.z, first.z)};
        }
        const Vectors from_center{v.x - frame.center.x, v.y - frame.center.y, v.z - frame.center.z};
        const Vectors at{dot(frame.row_x, from_center),
                         dot(frame.row_y, from_center),
                         dot(frame.row_z, from_center)};
        spreads.add(at, hn::Abs(from_center.x) + hn::Abs(from_center.y) + hn::Abs(from_center.z));
        if (coordinates != nullptr) {
            hn::Store(at.x, d, &coordinates->along[0][i]);
            hn::Store(at.y, d, &coordinates->along[1][i]);
            hn::Store(at.z, d, &coordinates->along[2][i]);
        }
    }
    *spread = spreads.over_lanes();
}

void measure_floats(const float* from,
                    std::size_t count,
                    const SeenFrame& frame,
                    BlockCoordinates* coordinates,
                    Spread* spread) {
    measure(from, count, frame, coordinates, spread);
}

void measure_doubles(const double* from,
                     std::size_t count,
                     const SeenFrame& frame,
                     BlockCoordinates* coordinates,
                     Spread* spread) {
    measure(from, count, frame, coordinates, spread);
}

/// The bounds of a vertex on all axes as bytes: its low steps, and 255 less its high steps. The
/// bytewise minimum over a triangle's vertices bounds the triangle.
using VertexBounds = std::array<std::uint8_t, 8>;

/// Rounds a coordinate down to whole steps. Both the quotient and its factor are rounded, so the
/// result is corrected by one step if it is above the coordinate. Steps are floats and their
/// numbers bytes, so that products are exact.
HWY_INLINE V steps_below(V coordinate, V step, V per_step) {
    const V steps = hn::Floor(coordinate * per_step);
    return steps - hn::IfThenElseZero(hn::Gt(steps * step, coordinate), all(1));
}

/// Rounds a coordinate up to whole steps, corrected as in `steps_below`.
HWY_INLINE V steps_above(V coordinate, V step, V per_step) {
    const V steps = hn::Ceil(coordinate * per_step);
    return steps + hn::IfThenElseZero(hn::Lt(steps * step, coordinate), all(1));
}

/// The numbers of a StepAxis, broadcast to all lanes.
struct StepVectors {
    HWY_INLINE explicit StepVectors(const StepAxis& axis)
        : origin(all(axis.origin)),
          error(all(axis.error)),
          step(all(axis.step)),
          per_step(all(1 / axis.step)) {}

    HWY_INLINE hn::Vec<Steps> below(V coordinate) const {
        return hn::DemoteTo(Steps(), steps_below(coordinate - origin - error, step, per_step));
    }
    HWY_INLINE hn::Vec<Steps> above(V coordinate) const {
        return hn::DemoteTo(Steps(), steps_above(coordinate - origin + error, step, per_step));
    }

    V origin;
    V error;
    V step;
    V per_step;
};

void child_boxes(const ChildSpreads* spreads, const StepAxis* axes, WideNode* node) {
    const Doubles d;
    for (std::size_t k = 0; k < 3; ++k) {
        const StepVectors steps(axes[k]);
        alignas(64) std::array<std::int32_t, wide_children_max> low;
        alignas(64) std::array<std::int32_t, wide_children_max> high;
        for (std::size_t i = 0; i < wide_children_max; i += lanes) {
            hn::Store(steps.below(hn::Load(d, &spreads->low[k][i])), Steps(), &low[i]);
            hn::Store(steps.above(hn::Load(d, &spreads->high[k][i])), Steps(), &high[i]);
        }
        for (std::size_t i = 0; i < node->count; ++i) {
            node->low[k][i] = static_cast<std::uint8_t>(low[i]);
            node->high[k][i] = static_cast<std::uint8_t>(high[i]);
        }
    }
}

void triangle_boxes(const BlockCoordinates* coordinates,
                    std::size_t vertices,
                    const BlockCorners* corners,
                    const StepAxis* axes,
                    WideNode* node) {
    const Doubles d;
    const Steps whole;
    const StepVectors steps[3] = {StepVectors(axes[0]), StepVectors(axes[1]), StepVectors(axes[2])};
    alignas(64) std::array<VertexBounds, block_vertices_max + 16> bounds;
    for (std::size_t i = 0; i < vertices; i += lanes) {
        hn::Vec<Steps> low[3];
        hn::Vec<Steps> high[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const V coordinate = hn::Load(d, &coordinates->along[k][i]);
            low[k] = steps[k].below(coordinate);
            high[k] = steps[k].above(coordinate);
        }
        const auto most = hn::Set(whole, 255);
        const auto first =
            hn::Or(hn::Or(low[0], hn::ShiftLeft<8>(low[1])),
                   hn::Or(hn::ShiftLeft<16>(low[2]), hn::ShiftLeft<24>(hn::Sub(most, high[0]))));
        const auto second =
            hn::Or(hn::Sub(most, high[1]), hn::ShiftLeft<8>(hn::Sub(most, high[2])));
        hn::StoreInterleaved2(
            first, second, whole, reinterpret_cast<std::int32_t*>(bounds.data() + i));
    }
    const hn::CappedTag<std::uint8_t, 8> bytes;
    for (std::size_t i = 0; i < node->count; ++i) {
        VertexBounds least;
        for (std::size_t j = 0; j < least.size(); j += hn::Lanes(bytes)) {
            const auto corner = [&](std::size_t k) {
                return hn::LoadU(bytes, &bounds[corners[i][k]][j]);
            };
            hn::StoreU(hn::Min(hn::Min(corner(0), corner(1)), corner(2)), bytes, &least[j]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            node->low[k][i] = least[k];
            node->high[k][i] = static_cast<std::uint8_t>(255 - least[3 + k]);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(measure_floats);
HWY_EXPORT(measure_doubles);
HWY_EXPORT(child_boxes);
HWY_EXPORT(triangle_boxes);

Spread spread_of(const TriangleBlocks& blocks,
                 std::uint32_t begin,
                 std::uint32_t end,
                 const SeenFrame& frame,
                 BlockCoordinates* coordinates) {
    const std::size_t first = 3 * std::size_t{begin};
    const std::size_t count = end - begin;
    Spread spread;
    if (blocks.doubles.empty()) {
        HWY_DYNAMIC_DISPATCH(measure_floats)
        (&blocks.floats[first], count, frame, coordinates, &spread);
    } else {
        HWY_DYNAMIC_DISPATCH(measure_doubles)
        (&blocks.doubles[first], count, frame, coordinates, &spread);
    }
    return spread;
}

void set_child_boxes(const ChildSpreads& spreads,
                     const std::array<StepAxis, 3>& axes,
                     WideNode& node) {
    HWY_DYNAMIC_DISPATCH(child_boxes)(&spreads, axes.data(), &node);
}

void set_triangle_boxes(const BlockCoordinates& coordinates,
                        std::size_t vertices,
                        const BlockCorners* corners,
                        const std::array<StepAxis, 3>& axes,
                        WideNode& node) {
    HWY_DYNAMIC_DISPATCH(triangle_boxes)(&coordinates, vertices, corners, axes.data(), &node);
}

} // namespace cd

#endif
