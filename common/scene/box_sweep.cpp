#include "common/scene/box_sweep.hpp"

#include "common/geometry/highway_targets.hpp"
#include "common/geometry/number_sorter.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/scene/box_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef CD_COMMON_SCENE_BOX_SWEEP_CPP
#define CD_COMMON_SCENE_BOX_SWEEP_CPP

namespace cd {

/// Columns of sorted boxes: the axis of the sweep first. Each has `sweep_padding` more values at
/// its end, which overlap nothing.
struct SweepColumns {
    std::array<const float*, 3> low;
    std::array<const float*, 3> high;
    std::uint32_t count;
};

inline constexpr std::size_t sweep_padding = 16;

} // namespace cd

#endif

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, sweep_padding>;
constexpr std::size_t lanes = hn::MaxLanes(Floats());

/// Appends the positions of the boxes behind `first` that overlap it, to at least `count + lanes`
/// places in `found`. Returns how many there are.
std::uint32_t
overlaps_behind(const SweepColumns& boxes, std::uint32_t first, std::uint32_t* found) {
    const Floats d;
    const hn::RebindToUnsigned<Floats> du;
    const auto end = hn::Set(d, boxes.high[0][first]);
    const auto low_1 = hn::Set(d, boxes.low[1][first]);
    const auto high_1 = hn::Set(d, boxes.high[1][first]);
    const auto low_2 = hn::Set(d, boxes.low[2][first]);
    const auto high_2 = hn::Set(d, boxes.high[2][first]);
    std::uint32_t count = 0;
    for (std::uint32_t at = first + 1; at < boxes.count; at += static_cast<std::uint32_t>(lanes)) {
        const auto begins = hn::Le(hn::LoadU(d, boxes.low[0] + at), end);
        if (hn::AllFalse(d, begins)) {
            break;
        }
        const auto on_1 = hn::And(hn::Le(hn::LoadU(d, boxes.low[1] + at), high_1),
                                  hn::Ge(hn::LoadU(d, boxes.high[1] + at), low_1));
        const auto on_2 = hn::And(hn::Le(hn::LoadU(d, boxes.low[2] + at), high_2),
                                  hn::Ge(hn::LoadU(d, boxes.high[2] + at), low_2));
        const auto overlap = hn::And(begins, hn::And(on_1, on_2));
        if (!hn::AllFalse(d, overlap)) {
            const auto positions = hn::Iota(du, at);
            count += static_cast<std::uint32_t>(
                hn::CompressStore(positions, hn::RebindMask(du, overlap), du, found + count));
        }
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cd {

namespace {

HWY_EXPORT(overlaps_behind);

/// Returns the axis on which a box overlaps the smallest part of the others: the sum of the sizes
/// by the range of the boxes is least.
std::size_t sweep_axis(std::span<const WorldBox> boxes) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double size = 0;
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
        for (const WorldBox& box : boxes) {
            size += double{box.high[axis]} - double{box.low[axis]};
            low = std::min(low, double{box.low[axis]});
            high = std::max(high, double{box.high[axis]});
        }
        const double part = size / (high - low);
        if (part < least) {
            least = part;
            best = axis;
        }
    }
    return best;
}

/// Returns a number that orders as the float does.
std::uint32_t ordered(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

/// Returns the boxes' indices by ascending low end.
std::vector<std::uint32_t> sorted_by_low(std::span<const WorldBox> boxes, std::size_t axis) {
    std::vector<std::uint64_t> keys(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        // Adding 0 makes -0 and 0 one key.
        keys[i] = std::uint64_t{ordered(boxes[i].low[axis] + 0.0f)} << 32 | i;
    }
    NumberSorter().sort(keys);
    std::vector<std::uint32_t> order(boxes.size());
    std::ranges::transform(
        keys, order.begin(), [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
    return order;
}

/// The boxes in the order of the sweep.
class SortedBoxes {
  public:
    SortedBoxes(std::span<const WorldBox> boxes, std::size_t axis)
        : order_(sorted_by_low(boxes, axis)) {
        const std::size_t size = boxes.size() + sweep_padding;
        for (std::size_t k = 0; k < 3; ++k) {
            low_[k].assign(size, std::numeric_limits<float>::quiet_NaN());
            high_[k].assign(size, std::numeric_limits<float>::quiet_NaN());
            for (std::size_t i = 0; i < order_.size(); ++i) {
                low_[k][i] = boxes[order_[i]].low[(axis + k) % 3];
                high_[k][i] = boxes[order_[i]].high[(axis + k) % 3];
            }
        }
    }

    [[nodiscard]] SweepColumns columns() const {
        return {{low_[0].data(), low_[1].data(), low_[2].data()},
                {high_[0].data(), high_[1].data(), high_[2].data()},
                static_cast<std::uint32_t>(order_.size())};
    }
    /// Returns a key that sorts as the pair does.
    [[nodiscard]] std::uint64_t pair_key(std::uint32_t one, std::uint32_t other) const {
        const auto [a, b] = std::minmax(order_[one], order_[other]);
        return std::uint64_t{a} << 32 | b;
    }

  private:
    std::vector<std::uint32_t> order_;
    std::array<std::vector<float>, 3> low_;
    std::array<std::vector<float>, 3> high_;
};

} // namespace

std::vector<BodyPair> overlapping_pairs(std::span<const WorldBox> boxes) {
    if (boxes.size() < 2) {
        return {};
    }
    const SortedBoxes sorted(boxes, sweep_axis(boxes));
    const SweepColumns columns = sorted.columns();
    std::vector<std::uint32_t> found(boxes.size() + sweep_padding);
    std::vector<std::uint64_t> keys;
    for (std::uint32_t i = 0; i + 1 < columns.count; ++i) {
        const std::uint32_t count = HWY_DYNAMIC_DISPATCH(overlaps_behind)(columns, i, found.data());
        for (std::uint32_t k = 0; k < count; ++k) {
            keys.push_back(sorted.pair_key(i, found[k]));
        }
    }
    NumberSorter().sort(keys);
    std::vector<BodyPair> pairs(keys.size());
    std::ranges::transform(keys, pairs.begin(), [](std::uint64_t key) {
        return BodyPair{static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
    });
    return pairs;
}

} // namespace cd
#endif
