// Converts coordinates between the frames of two wide nodes. Compiled for every target;
// wide_kernel.cpp derives the margins and defines M, N and T.

// Highway's include guard: it admits the file once for each target.
#if defined(CD_WIDE_MEETING_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_WIDE_MEETING_INL_HPP
#undef CD_WIDE_MEETING_INL_HPP
#else
#define CD_WIDE_MEETING_INL_HPP
#endif

#include "common/tree/wide/wide_rows-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

using VRow = hn::Vec<Row>;
constexpr std::size_t row_lanes = hn::MaxLanes(Row());

/// Returns the lanes from `i` on of the weighted sum of three columns of four floats.
HWY_INLINE VRow combined(const float* columns, const float* weights, std::size_t i) {
    const Row d;
    VRow sum = hn::Mul(hn::Load(d, columns + i), hn::Set(d, weights[0]));
    sum = hn::MulAdd(hn::Load(d, columns + 4 + i), hn::Set(d, weights[1]), sum);
    return hn::MulAdd(hn::Load(d, columns + 8 + i), hn::Set(d, weights[2]), sum);
}

HWY_INLINE float absolute(float value) {
    return value < 0 ? -value : value;
}

/// Sets `change` to the map from one node's steps to the other's. `columns` are the columns of M
/// or, if `kByAxis`, the rows of M'. `steps` belong to the first node, and `per_step`, the
/// reciprocals of steps, to the other; each has 4 floats.
template <bool kByAxis>
HWY_INLINE void finish_change(const float* columns,
                              const float* offset,
                              float margin,
                              const float* steps,
                              const float* per_step,
                              Change<kByAxis>& change) {
    const Row d;
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < 4; i += row_lanes) {
        const VRow scale = hn::Load(d, per_step + i);
        const VRow half = hn::Mul(hn::LoadU(d, steps + i), hn::Set(d, 0.5F));
        HWY_UNROLL(3)
        for (std::size_t c = 0; c < 3; ++c) {
            const VRow column = hn::Load(d, columns + 4 * c + i);
            const VRow entry = kByAxis
                                   ? hn::Mul(hn::Mul(column, hn::Set(d, per_step[c])), half)
                                   : hn::Mul(hn::Mul(column, scale), hn::Set(d, 0.5F * steps[c]));
            hn::Store(entry, d, change.entries[c] + i);
            hn::Store(hn::Abs(entry), d, change.sizes[c] + i);
        }
        hn::Store(hn::Mul(hn::Load(d, offset + i), scale), d, change.offset + i);
        hn::Store(hn::Mul(hn::Set(d, margin), scale), d, change.margin + i);
    }
}

/// A pair of nodes of a batch, with the transforms between their frames.
struct Meeting {
    alignas(16) float columns[3][4]; ///< M, which maps B's coordinates to A's.
    alignas(16) float offset_a[4];   ///< -N^-1 T: the origin of A's node in the frame of B's.
    alignas(16) float offset_b[4];   ///< T: the origin of B's node in the frame of A's.
    alignas(16) float per_step_a[4]; ///< The reciprocals of A's steps.
    alignas(16) float per_step_b[4]; ///< The reciprocals of B's steps.
    float along;                     ///< How far B's node is from A's along the pose's direction.
    float margin; ///< The length that is added to each interval for rounding errors.
    WidePair nodes;
};

HWY_INLINE void
meet(const WidePose& pose, const WideNode& a, const WideNode& b, WidePair nodes, Meeting& to) {
    const Row d;
    to.nodes = nodes;
    float w[3];
    HWY_UNROLL(3)
    for (std::size_t i = 0; i < 3; ++i) {
        const double* row = &pose.rotation[3 * i];
        w[i] = static_cast<float>((row[0] * b.origin[0] + row[1] * b.origin[1]) +
                                  (row[2] * b.origin[2] + (pose.translation[i] - a.origin[i])));
    }
    to.along = pose.along[0] * w[0] + pose.along[1] * w[1] + pose.along[2] * w[2];
    const float back[3] = {-w[0], -w[1], -w[2]};
    const float* frame_a = a.columns[0].data();
    alignas(16) float turned_back[4];
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < 4; i += row_lanes) {
        hn::Store(combined(pose.rows[0].data(), back, i), d, turned_back + i);
        hn::Store(combined(frame_a, w, i), d, to.offset_b + i);
        hn::Store(hn::Div(hn::Set(d, 1), hn::LoadU(d, a.steps.data() + i)), d, to.per_step_a + i);
        hn::Store(hn::Div(hn::Set(d, 1), hn::LoadU(d, b.steps.data() + i)), d, to.per_step_b + i);
    }
    alignas(16) float turned[3][4];
    HWY_UNROLL(3)
    for (std::size_t k = 0; k < 3; ++k) {
        const float row[3] = {b.columns[0][k], b.columns[1][k], b.columns[2][k]};
        HWY_UNROLL(4)
        for (std::size_t i = 0; i < 4; i += row_lanes) {
            hn::Store(combined(pose.columns[0].data(), row, i), d, turned[k] + i);
        }
    }
    HWY_UNROLL(3)
    for (std::size_t k = 0; k < 3; ++k) {
        HWY_UNROLL(4)
        for (std::size_t i = 0; i < 4; i += row_lanes) {
            hn::Store(combined(frame_a, turned[k], i), d, to.columns[k] + i);
        }
    }
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < 4; i += row_lanes) {
        hn::Store(combined(b.columns[0].data(), turned_back, i), d, to.offset_a + i);
    }
    const float steps =
        (a.steps[0] + a.steps[1] + a.steps[2]) + (b.steps[0] + b.steps[1] + b.steps[2]);
    const float apart = absolute(w[0]) + absolute(w[1]) + absolute(w[2]);
    to.margin = pose.relative_margin * (apart + whole_steps * steps) + pose.absolute_margin;
}

/// Sets `to` to the map from a body's coordinates, turned by `rotation`, to steps of the frame
/// whose columns are `frame`.
HWY_INLINE void
make_turn(const float* frame, const float* rotation, const float* per_step, Turn& to) {
    const Row d;
    HWY_UNROLL(3)
    for (std::size_t c = 0; c < 3; ++c) {
        HWY_UNROLL(4)
        for (std::size_t i = 0; i < 4; i += row_lanes) {
            const VRow column = combined(frame, rotation + 4 * c, i);
            hn::Store(hn::Mul(column, hn::Load(d, per_step + i)), d, to.entries[c] + i);
        }
    }
}

/// Computes how far each child of a node reaches against a direction: the least product of it and a
/// point relative to the node's origin, plus `offset`. The direction is one of the body's own.
template <bool kBothLeaves>
HWY_INLINE void project(
    const WideBody& body, const Side& side, const float* direction, float offset, float* least) {
    if constexpr (kBothLeaves) {
        if (project_triangles(body, side, direction, offset, least)) {
            return;
        }
    }
    const Floats d;
    const float* frame = side.node->columns[0].data();
    float entry[3];
    HWY_UNROLL(3)
    for (std::size_t k = 0; k < 3; ++k) {
        entry[k] =
            0.5F * side.node->steps[k] *
            (frame[k] * direction[0] + frame[4 + k] * direction[1] + frame[8 + k] * direction[2]);
    }
    HWY_UNROLL(4)
    for (std::size_t lane = 0; lane < children; lane += lanes) {
        V at = hn::Set(d, offset);
        HWY_UNROLL(3)
        for (std::size_t k = 0; k < 3; ++k) {
            const V low = low_of(side, k, lane);
            const V high = high_of(side, k, lane);
            at = hn::MulAdd(hn::Set(d, entry[k]), hn::Add(low, high), at);
            at = hn::NegMulAdd(hn::Set(d, absolute(entry[k])), hn::Sub(high, low), at);
        }
        hn::Store(at, d, least + lane);
    }
}

template <bool kBothLeaves>
HWY_INLINE std::uint32_t see_b(const WidePose& pose,
                               const WideBody& body,
                               const WideNode& a,
                               const Side& side_b,
                               const Meeting& meeting,
                               Intervals& seen) {
    Change<false> change;
    finish_change(meeting.columns[0],
                  meeting.offset_b,
                  meeting.margin,
                  side_b.node->steps.data(),
                  meeting.per_step_a,
                  change);
    if constexpr (!kBothLeaves) {
        return side_b.is_whole ? see_whole(change, seen) : see(side_b, change, seen);
    }
    Turn turn;
    make_turn(a.columns[0].data(), pose.columns[0].data(), meeting.per_step_a, turn);
    return see_triangles(body, side_b, turn, change, seen);
}

template <bool kBothLeaves>
HWY_INLINE std::uint32_t see_a(const WidePose& pose,
                               const WideBody& body,
                               const WideNode& b,
                               const Side& side_a,
                               const Meeting& meeting,
                               Intervals& seen) {
    Change<true> change;
    finish_change(meeting.columns[0],
                  meeting.offset_a,
                  meeting.margin,
                  side_a.node->steps.data(),
                  meeting.per_step_b,
                  change);
    if constexpr (!kBothLeaves) {
        return side_a.is_whole ? see_whole(change, seen) : see(side_a, change, seen);
    }
    Turn turn;
    make_turn(b.columns[0].data(), pose.rows[0].data(), meeting.per_step_b, turn);
    return see_triangles(body, side_a, turn, change, seen);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
