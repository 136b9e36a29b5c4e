// Poses corners, one pair per SIMD lane, by the same operations as ExactCorners and PosedCorners of
// double_signs.hpp. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_DOUBLE_PAIRS_FRAME_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_DOUBLE_PAIRS_FRAME_INL_HPP
#undef CD_DOUBLE_PAIRS_FRAME_INL_HPP
#else
#define CD_DOUBLE_PAIRS_FRAME_INL_HPP
#endif

#include "common/pair/stages/double/double_signs.hpp"
#include "common/pair/stages/double_batch/double_pairs_kernel.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace double_pairs {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using V = hn::Vec<Doubles>;
using M = hn::Mask<Doubles>;

constexpr std::size_t lanes = hn::MaxLanes(Doubles());
static_assert(CornersOfMany::pairs % lanes == 0);

// Where GCC gives vectors a default constructor, as on NEON, only code compiled for the target may
// call that. So structures that are filled later declare a default constructor of their own.

/// A coordinate that is exactly a double.
struct ExactComponent {
    V at;

    HWY_INLINE ExactComponent() {}
    HWY_INLINE explicit ExactComponent(V given) : at(given) {}
};

/// A coordinate, and the contribution of the coordinate's error to sizes (see double_signs.hpp).
struct Component {
    V at;
    V error;

    HWY_INLINE Component() {}
    HWY_INLINE Component(V given, V its_error) : at(given), error(its_error) {}
};

/// A component of a difference, and the component's size (see double_signs.hpp).
struct Sized {
    V value;
    V size;

    HWY_INLINE Sized() {}
    HWY_INLINE Sized(V given, V its_size) : value(given), size(its_size) {}
};

HWY_INLINE Sized between(const Component& from, const Component& to) {
    const V value = hn::Sub(to.at, from.at);
    return {value, hn::Add(hn::Abs(value), hn::Add(to.error, from.error))};
}

HWY_INLINE Sized between(const ExactComponent& from, const ExactComponent& to) {
    const V value = hn::Sub(to.at, from.at);
    return {value, hn::Abs(value)};
}

/// World coordinates by corner and axis, as in ExactCorners or PosedCorners.
template <class C>
struct Frame {
    C a[3][3];
    C b[3][3];        ///< B's corners for differences within B.
    C b_across[3][3]; ///< B's corners for differences from A.
    M one[3][3];      ///< Lanes in which corners i of A and j of B provably coincide.
    M is_tame;

    HWY_INLINE Frame() {}
};
using ExactFrame = Frame<ExactComponent>;
using PosedFrame = Frame<Component>;

/// The unposed coordinates, by corner and axis.
struct Given {
    V a[3][3];
    V b[3][3];

    HWY_INLINE Given() {}
};

HWY_INLINE Given load(const CornersOfMany& corners, std::size_t first) {
    const Doubles d;
    Given given;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            given.a[i][k] = hn::Load(d, corners.a[i][k].data() + first);
            given.b[i][k] = hn::Load(d, corners.b[i][k].data() + first);
        }
    }
    return given;
}

HWY_INLINE M are_tame(const V (&x)[3][3], M so_far) {
    const Doubles d;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const V size = hn::Abs(x[i][k]);
            const M is_fit =
                hn::Or(hn::Ge(size, hn::Set(d, tame_least)), hn::Eq(size, hn::Zero(d)));
            so_far = hn::And(so_far, hn::And(is_fit, hn::Le(size, hn::Set(d, tame_most))));
        }
    }
    return so_far;
}

HWY_INLINE V as_error(V error) {
    return hn::Mul(hn::Set(Doubles(), double_signs::size_of_error), error);
}

struct Sums {
    V high;
    V low;

    HWY_INLINE Sums() {}
    HWY_INLINE Sums(V of_all, V of_rest) : high(of_all), low(of_rest) {}
};

/// Returns left + right without any error, as `exact_sum` of double_double.hpp does.
HWY_INLINE Sums exact_sum(V left, V right) {
    const V sum = hn::Add(left, right);
    const V right_part = hn::Sub(sum, left);
    const V left_part = hn::Sub(sum, right_part);
    return {sum, hn::Add(hn::Sub(left, left_part), hn::Sub(right, right_part))};
}

/// Returns a corner's world coordinates along an axis onto which the pose maps one of the body's
/// axes, in either direction.
HWY_INLINE Sums placed(const RoundedPoses::Body& body, const V (&corner)[3], std::size_t axis) {
    const Doubles d;
    const RoundedPoses::Row& row = body.rows[axis];
    return exact_sum(hn::Mul(hn::Set(d, row.sign), corner[row.source]),
                     hn::Set(d, body.translation[static_cast<int>(axis)]));
}

/// One coordinate of both bodies' corners, by corner.
struct BothSums {
    Sums a[3];
    Sums b[3];

    HWY_INLINE BothSums() {}
};

/// Returns all corners' coordinates along one axis, and clears `to.one` where those of two corners
/// differ: equal numbers have equal high and low parts.
HWY_INLINE BothSums place_both(const RoundedPoses& poses,
                               const Given& given,
                               std::size_t axis,
                               PosedFrame& to) {
    BothSums sums;
    for (std::size_t i = 0; i < 3; ++i) {
        sums.a[i] = placed(poses.bodies[0], given.a[i], axis);
        sums.b[i] = placed(poses.bodies[1], given.b[i], axis);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const M is_one = hn::And(hn::Eq(sums.a[i].high, sums.b[j].high),
                                     hn::Eq(sums.a[i].low, sums.b[j].low));
            to.one[i][j] = hn::And(to.one[i][j], is_one);
        }
    }
    return sums;
}

/// Stores the coordinates along an axis that both poses keep. Between the triangles a difference
/// errs by both corners' errors and the difference of the first corners' low parts.
HWY_INLINE void place_exact(const BothSums& sums, std::size_t axis, PosedFrame& to) {
    const auto& [a, b] = sums;
    const V apart = as_error(hn::Abs(hn::Sub(b[0].low, a[0].low)));
    for (std::size_t i = 0; i < 3; ++i) {
        to.a[i][axis] = {a[i].high, as_error(hn::Abs(hn::Sub(a[i].low, a[0].low)))};
        to.b[i][axis] = {b[i].high, as_error(hn::Abs(hn::Sub(b[i].low, b[0].low)))};
        to.b_across[i][axis] = {b[i].high, hn::Add(to.b[i][axis].error, apart)};
    }
}

/// A first corner, or another corner minus the first, with the size of each coordinate.
struct Offset {
    V at[3];
    V size[3];

    HWY_INLINE Offset() {}
};

struct Offsets {
    Offset a[3];
    Offset b[3];

    HWY_INLINE Offsets() {}
};

HWY_INLINE void set_sizes(Offset& offset) {
    const Doubles d;
    for (std::size_t k = 0; k < 3; ++k) {
        const V x = offset.at[k];
        const V raised = hn::IfThenZeroElse(hn::Eq(x, hn::Zero(d)), hn::Set(d, 0x1p-700));
        offset.size[k] = hn::Add(hn::Abs(x), raised);
    }
}

HWY_INLINE void set_offsets(const V (&corners)[3][3], Offset (&to)[3]) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            to[i].at[k] = i == 0 ? corners[0][k] : hn::Sub(corners[i][k], corners[0][k]);
        }
        set_sizes(to[i]);
    }
}

/// Multiplies a row of a body's rotation, or of its weights, with a vector.
HWY_INLINE V row_times(const std::array<BothBodies, 3>& row,
                       std::size_t body,
                       const V (&vector)[3]) {
    const Doubles d;
    return hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0][body]), vector[0]),
                           hn::Mul(hn::Set(d, row[1][body]), vector[1])),
                   hn::Mul(hn::Set(d, row[2][body]), vector[2]));
}

HWY_INLINE void
place_rotated(const RoundedPoses& poses, const Offsets& offsets, std::size_t k, PosedFrame& to) {
    const Doubles d;
    Component a[3];
    Component b[3];
    for (std::size_t i = 0; i < 3; ++i) {
        a[i] = {row_times(poses.entries[k], 0, offsets.a[i].at),
                row_times(poses.weights[k], 0, offsets.a[i].size)};
        b[i] = {row_times(poses.entries[k], 1, offsets.b[i].at),
                row_times(poses.weights[k], 1, offsets.b[i].size)};
    }
    const V u = hn::Set(d, 1.01 * double_signs::u);
    const V first = hn::Sub(b[0].at, a[0].at);
    const V apart = hn::Sub(first, hn::Set(d, poses.offset[k]));
    const V apart_error =
        hn::Add(hn::Add(hn::Add(a[0].error, b[0].error), hn::Set(d, poses.offset_error[k])),
                hn::Mul(u, hn::Add(hn::Abs(first), hn::Abs(apart))));
    a[0] = b[0] = {hn::Zero(d), hn::Zero(d)};
    for (std::size_t i = 0; i < 3; ++i) {
        const V from_a = hn::Add(b[i].at, apart);
        const V across = hn::Add(hn::Add(b[i].error, apart_error), hn::Mul(u, hn::Abs(from_a)));
        to.a[i][k] = {a[i].at, as_error(a[i].error)};
        to.b[i][k] = {b[i].at, as_error(b[i].error)};
        to.b_across[i][k] = {from_a, as_error(across)};
    }
}

/// Tests whether a posed corner is exactly known: all coordinates that enter inexact rows are 0.
HWY_INLINE M is_known(const RoundedPoses::Body& body, const V (&corner)[3]) {
    const Doubles d;
    M known = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t c = 0; c < 3; ++c) {
        if ((body.rounded_columns >> c & 1) != 0) {
            known = hn::And(known, hn::Eq(corner[c], hn::Zero(d)));
        }
    }
    return known;
}

HWY_INLINE M are_pairs_tame(const RoundedPoses& poses, const Given& given) {
    const Doubles d;
    const V one = hn::Set(d, poses.are_tame ? 1 : 0);
    return are_tame(given.b, are_tame(given.a, hn::Eq(one, hn::Set(d, 1))));
}

/// Fills the frame for bodies without relative rotation. Returns false, with a meaningless frame,
/// if a coordinate is not exactly a double.
HWY_INLINE bool fill(const RoundedPoses& poses, const Given& given, ExactFrame& to) {
    const Doubles d;
    M are_exact = hn::Eq(hn::Zero(d), hn::Zero(d));
    const auto coordinate =
        [&](const RoundedPoses::Body& body, const V(&corner)[3], std::size_t axis) {
            if (body.is_none) {
                return corner[axis];
            }
            const Sums sums = placed(body, corner, axis);
            are_exact = hn::And(are_exact, hn::Eq(sums.low, hn::Zero(d)));
            return sums.high;
        };
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            to.a[i][axis] = ExactComponent(coordinate(poses.bodies[0], given.a[i], axis));
            to.b[i][axis] = to.b_across[i][axis] =
                ExactComponent(coordinate(poses.bodies[1], given.b[i], axis));
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            to.one[i][j] = hn::And(
                hn::And(hn::Eq(to.a[i][0].at, to.b[j][0].at), hn::Eq(to.a[i][1].at, to.b[j][1].at)),
                hn::Eq(to.a[i][2].at, to.b[j][2].at));
        }
    }
    to.is_tame = are_pairs_tame(poses, given);
    return hn::AllTrue(d, are_exact);
}

HWY_INLINE void fill(const RoundedPoses& poses, const Given& given, PosedFrame& to) {
    to.is_tame = are_pairs_tame(poses, given);
    for (std::size_t i = 0; i < 3; ++i) {
        const M known = is_known(poses.bodies[0], given.a[i]);
        for (std::size_t j = 0; j < 3; ++j) {
            to.one[i][j] = hn::And(known, is_known(poses.bodies[1], given.b[j]));
        }
    }
    Offsets offsets;
    if (poses.are_rotated) {
        set_offsets(given.a, offsets.a);
        set_offsets(given.b, offsets.b);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const BothSums sums = place_both(poses, given, axis, to);
        if (poses.bodies[0].rows[axis].sign != 0 && poses.bodies[1].rows[axis].sign != 0) {
            place_exact(sums, axis, to);
        } else {
            place_rotated(poses, offsets, axis, to);
        }
    }
}

} // namespace double_pairs
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
