// The arithmetic is that of `world_box`, operation by operation, and so is the proof. Rotations are
// those of `Pose::rotation`.
#include "common/scene/world_boxes.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/scene/world_boxes.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include <hwy/highway.h>

#ifndef CD_COMMON_SCENE_WORLD_BOXES_CPP
#define CD_COMMON_SCENE_WORLD_BOXES_CPP

namespace cd {

inline constexpr std::size_t box_block = 32; ///< Bodies whose boxes are computed at once.

/// Numbers of a block of bodies, and their boxes.
struct PosedBoxColumns {
    template <class T>
    using Column = std::array<T, box_block>;

    alignas(64) std::array<Column<double>, 4> quaternion; ///< w, x, y, z.
    std::array<Column<double>, 9> rotation;               ///< Row by row.
    std::array<Column<double>, 3> translation;
    std::array<Column<double>, 3> low; ///< Of the box in the body's coordinates.
    std::array<Column<double>, 3> high;
    Column<double> margin;
    Column<double> rotation_error;
    std::array<Column<float>, 3> world_low;
    std::array<Column<float>, 3> world_high;
    std::size_t count = 0;
    /// Bodies whose rotation does not come from their quaternion's column, and these rotations.
    Column<std::pair<std::size_t, Mat3>> given;
    std::size_t given_count = 0;
};

} // namespace cd

#endif

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;
using V = hn::Vec<Doubles>;

constexpr std::size_t lanes = hn::MaxLanes(Doubles());
static_assert(box_block % lanes == 0);

HWY_INLINE V all(double value) {
    return hn::Set(Doubles(), value);
}

struct Vectors {
    V x;
    V y;
    V z;
};

HWY_INLINE Vectors load(const std::array<PosedBoxColumns::Column<double>, 3>& from,
                        std::size_t at) {
    const Doubles d;
    return {hn::Load(d, &from[0][at]), hn::Load(d, &from[1][at]), hn::Load(d, &from[2][at])};
}

HWY_INLINE Vectors absolute(const Vectors& v) {
    return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}

/// Adds in the order of the scalar code.
HWY_INLINE V dot(const Vectors& a, const Vectors& b) {
    return a.x * b.x + (a.y * b.y + a.z * b.z);
}

void rotations(PosedBoxColumns* columns) {
    const Doubles d;
    const auto two = all(2);
    for (std::size_t at = 0; at < columns->count; at += lanes) {
        const auto w = hn::Load(d, &columns->quaternion[0][at]);
        const auto x = hn::Load(d, &columns->quaternion[1][at]);
        const auto y = hn::Load(d, &columns->quaternion[2][at]);
        const auto z = hn::Load(d, &columns->quaternion[3][at]);
        const auto n = w * w + x * x + y * y + z * z;
        const auto put = [&](std::size_t entry, V value) {
            hn::Store(value / n, d, &columns->rotation[entry][at]);
        };
        put(0, w * w + x * x - y * y - z * z);
        put(1, two * (x * y - w * z));
        put(2, two * (x * z + w * y));
        put(3, two * (x * y + w * z));
        put(4, w * w - x * x + y * y - z * z);
        put(5, two * (y * z - w * x));
        put(6, two * (x * z - w * y));
        put(7, two * (y * z + w * x));
        put(8, w * w - x * x - y * y + z * z);
    }
}

/// Returns the greatest float that is at most the value; minus infinity for NaN.
HWY_INLINE hn::Vec<Floats> floats_below(V value) {
    const Doubles d;
    const Floats f;
    const hn::RebindToSigned<Floats> steps;
    constexpr double largest = std::numeric_limits<float>::max();
    // A value that is not a number compares as false, and becomes the lowest float, which the last
    // step then lowers to minus infinity.
    const auto is_in_range = hn::Ge(value, all(-largest));
    const auto clamped = hn::IfThenElse(is_in_range, hn::Min(value, all(largest)), all(-largest));
    const auto nearest = hn::DemoteTo(f, clamped);
    const auto is_above = hn::Or(hn::Gt(hn::PromoteTo(d, nearest), clamped), hn::Not(is_in_range));
    // Where the nearest float is above the value, takes the next lower float: the bits as an
    // integer, minus 1 if the float is positive, plus 1 if it is negative. The float is not +0
    // there, because negative values round to -0.
    const auto moves = hn::Neg(hn::DemoteTo(steps, hn::IfThenElseZero(is_above, all(1))));
    const auto bits = hn::BitCast(steps, nearest);
    const auto down = hn::Or(hn::BroadcastSignBit(bits), hn::Set(steps, 1));
    return hn::BitCast(f, hn::Sub(bits, hn::And(down, moves)));
}

void boxes(PosedBoxColumns* columns) {
    const Doubles d;
    const Floats f;
    constexpr double roundoff = 0x1p-53;
    const auto half_size = [](V low, V high, V center) {
        return all(1 + 4 * roundoff) * hn::Max(high - center, center - low) +
               all(std::numeric_limits<double>::denorm_min());
    };
    for (std::size_t at = 0; at < columns->count; at += lanes) {
        const Vectors low = load(columns->low, at);
        const Vectors high = load(columns->high, at);
        const auto one_half = all(0.5);
        const Vectors center{one_half * low.x + one_half * high.x,
                             one_half * low.y + one_half * high.y,
                             one_half * low.z + one_half * high.z};
        const Vectors half{half_size(low.x, high.x, center.x),
                           half_size(low.y, high.y, center.y),
                           half_size(low.z, high.z, center.z)};
        const Vectors from_zero = absolute(center);
        const auto size = (from_zero.x + from_zero.y + from_zero.z) + (half.x + half.y + half.z);
        const auto margin = hn::Load(d, &columns->margin[at]);
        const auto turn_error = all(2) * hn::Load(d, &columns->rotation_error[at]) * size;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vectors row{hn::Load(d, &columns->rotation[3 * i][at]),
                              hn::Load(d, &columns->rotation[3 * i + 1][at]),
                              hn::Load(d, &columns->rotation[3 * i + 2][at])};
            const auto translation = hn::Load(d, &columns->translation[i][at]);
            const auto middle = dot(row, center) + translation;
            const auto radius = dot(absolute(row), half);
            const auto largest =
                dot(absolute(row), from_zero) + hn::Abs(translation) + radius + margin;
            const auto error =
                all(8 * roundoff) * largest + turn_error + all(std::numeric_limits<double>::min());
            const auto reach = radius + error + margin;
            hn::Store(floats_below(middle - reach), f, &columns->world_low[i][at]);
            hn::Store(
                hn::Neg(floats_below(hn::Neg(middle + reach))), f, &columns->world_high[i][at]);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cd {

namespace {

HWY_EXPORT(rotations);
HWY_EXPORT(boxes);

/// Returns true if `Pose::rotation` divides by the norm of the quaternion as it is.
bool is_plain(const Pose& pose) {
    if (pose.kind() != Pose::Kind::Quaternion) {
        return false;
    }
    const Quaternion& q = pose.quaternion();
    const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    return largest >= 0.5 && largest <= 1;
}

} // namespace

WorldBoxes::WorldBoxes(std::size_t count) : columns_(std::make_unique<PosedBoxColumns>()) {
    boxes_.reserve(count);
}

WorldBoxes::~WorldBoxes() = default;

void WorldBoxes::add(const Aabb& body, const Pose& pose, double margin) {
    PosedBoxColumns& to = *columns_;
    const std::size_t at = to.count++;
    Quaternion quaternion;
    if (is_plain(pose)) {
        quaternion = pose.quaternion();
    } else {
        to.given[to.given_count++] = {at, pose.rotation()};
    }
    to.quaternion[0][at] = quaternion.w;
    to.quaternion[1][at] = quaternion.x;
    to.quaternion[2][at] = quaternion.y;
    to.quaternion[3][at] = quaternion.z;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        to.translation[k][at] = pose.translation()[axis];
        to.low[k][at] = body.min[axis];
        to.high[k][at] = body.max[axis];
    }
    to.margin[at] = margin;
    to.rotation_error[at] = pose.rotation_error();
    if (to.count == box_block) {
        flush();
    }
}

std::vector<WorldBox> WorldBoxes::take() {
    flush();
    return std::move(boxes_);
}

/// Computes the boxes of the bodies in the columns.
void WorldBoxes::flush() {
    PosedBoxColumns& columns = *columns_;
    HWY_DYNAMIC_DISPATCH(rotations)(&columns);
    for (std::size_t i = 0; i < columns.given_count; ++i) {
        const auto& [at, rotation] = columns.given[i];
        for (std::size_t entry = 0; entry < 9; ++entry) {
            columns.rotation[entry][at] = rotation(static_cast<Eigen::Index>(entry / 3),
                                                   static_cast<Eigen::Index>(entry % 3));
        }
    }
    HWY_DYNAMIC_DISPATCH(boxes)(&columns);
    for (std::size_t at = 0; at < columns.count; ++at) {
        WorldBox& box = boxes_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = columns.world_low[k][at];
            box.high[k] = columns.world_high[k][at];
        }
    }
    columns.count = 0;
    columns.given_count = 0;
}

} // namespace cd
#endif
