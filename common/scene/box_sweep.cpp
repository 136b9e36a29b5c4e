#include "common/scene/box_sweep.hpp"

#include "common/core/check.hpp"
#include "common/geometry/number_sorter.hpp"
#include "common/scene/sorted_boxes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>

namespace cd {

namespace {

using Axes = std::array<std::size_t, 3>;
using Indices = std::vector<std::uint32_t>;

constexpr std::size_t strip_count = 8;

/// Some boxes, spread over all.
class BoxSample {
  public:
    explicit BoxSample(std::span<const WorldBox> boxes)
        : count_(std::min(boxes.size(), std::clamp(boxes.size() / 32, count_min, count_max))) {
        for (std::size_t i = 0; i < count_; ++i) {
            boxes_[i] = boxes[i * boxes.size() / count_];
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            overlaps_[axis] = count_overlaps(axis);
        }
    }

    /// Returns the axes, that on which the fewest pairs overlap first.
    [[nodiscard]] Axes axes() const {
        Axes axes{0, 1, 2};
        std::ranges::stable_sort(axes, {}, [&](std::size_t axis) { return overlaps_[axis]; });
        return axes;
    }
    /// Returns the part of pairs that overlap on an axis. There are at least two boxes.
    [[nodiscard]] double part(std::size_t axis) const {
        return 2.0 * overlaps_[axis] / static_cast<double>(count_ * (count_ - 1));
    }
    /// Returns `parts` - 1 numbers, ascending, between which there are equally many low ends.
    [[nodiscard]] std::vector<float> quantiles(std::size_t axis, std::size_t parts) const {
        std::array<float, count_max> low{};
        for (std::size_t i = 0; i < count_; ++i) {
            low[i] = boxes_[i].low[axis];
        }
        std::ranges::sort(std::span(low).first(count_));
        std::vector<float> quantiles;
        for (std::size_t part = 1; part < parts; ++part) {
            quantiles.push_back(low[part * count_ / parts]);
        }
        return quantiles;
    }

  private:
    static constexpr std::size_t count_min = 16;
    static constexpr std::size_t count_max = 64;

    [[nodiscard]] std::uint32_t count_overlaps(std::size_t axis) const {
        std::uint32_t overlaps = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                overlaps +=
                    static_cast<std::uint32_t>(boxes_[k].low[axis] <= boxes_[i].high[axis]) &
                    static_cast<std::uint32_t>(boxes_[i].low[axis] <= boxes_[k].high[axis]);
            }
        }
        return overlaps;
    }

    std::size_t count_;
    std::array<WorldBox, count_max> boxes_;
    std::array<std::uint32_t, 3> overlaps_{};
};

/// Returns a number that orders as the float does.
std::uint32_t ordered(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

/// Returns the boxes' indices by ascending low end.
Indices sorted_by_low(std::span<const WorldBox> boxes, std::size_t axis) {
    std::vector<std::uint64_t> keys(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        // Adding 0 makes -0 and 0 one key.
        keys[i] = std::uint64_t{ordered(boxes[i].low[axis] + 0.0f)} << 32 | i;
    }
    NumberSorter().sort(keys);
    Indices order(boxes.size());
    std::ranges::transform(
        keys, order.begin(), [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
    return order;
}

/// Boxes that begin in a strip of the second axis, and those that reach into it from an earlier
/// one.
struct Strip {
    Indices begin;
    Indices reach;
};

/// Returns the strips that `ends` divide an axis into, with the boxes in the given order.
///
/// Two boxes that overlap on the axis are both in the strip where the later one begins. In any
/// other strip one of them is missing, or both only reach into it. So each pair is found once among
/// those that have a box which begins in the strip.
std::vector<Strip> make_strips(std::span<const WorldBox> boxes,
                               std::span<const std::uint32_t> order,
                               std::size_t axis,
                               std::span<const float> ends) {
    const auto strip_of = [&](float value) {
        std::size_t strip = 0;
        for (const float end : ends) {
            strip += end <= value ? 1 : 0;
        }
        return strip;
    };
    std::vector<Strip> strips(ends.size() + 1);
    for (Strip& strip : strips) {
        strip.begin.reserve(2 * order.size() / strips.size());
        strip.reach.reserve(2 * order.size() / strips.size());
    }
    for (const std::uint32_t body : order) {
        const std::size_t first = strip_of(boxes[body].low[axis]);
        const std::size_t last = strip_of(boxes[body].high[axis]);
        strips[first].begin.push_back(body);
        for (std::size_t next = first + 1; next <= last; ++next) {
            strips[next].reach.push_back(body);
        }
    }
    return strips;
}

/// Returns true if a box meets so many others on the first axis that comparing it with those of
/// two or three strips saves more than the strips cost.
bool are_strips_worth_it(const BoxSample& sample, const Axes& axes, std::size_t boxes) {
    constexpr double met_min = 500;
    constexpr double part_max = 0.3; // Most boxes reach into several strips above it.
    return sample.part(axes[0]) * static_cast<double>(boxes) > met_min &&
           sample.part(axes[1]) < part_max;
}

/// Adds the pairs of all boxes.
void add_all_pairs(std::span<const WorldBox> boxes,
                   std::span<const std::uint32_t> order,
                   const BoxSample& sample,
                   PairCollector& pairs) {
    const Axes axes = sample.axes();
    if (!are_strips_worth_it(sample, axes, boxes.size())) {
        pairs.add_within(SortedBoxes(boxes, order, axes));
        return;
    }
    for (const Strip& strip :
         make_strips(boxes, order, axes[1], sample.quantiles(axes[1], strip_count))) {
        const SortedBoxes begin(boxes, strip.begin, axes);
        pairs.add_within(begin);
        pairs.add_between(begin, SortedBoxes(boxes, strip.reach, axes));
    }
}

/// Adds the pairs that have a box which moves.
void add_moving_pairs(std::span<const WorldBox> boxes,
                      std::span<const std::uint8_t> is_fixed,
                      std::span<const std::uint32_t> order,
                      const Axes& axes,
                      PairCollector& pairs) {
    Indices moving;
    Indices fixed;
    for (const std::uint32_t body : order) {
        (is_fixed[body] != 0 ? fixed : moving).push_back(body);
    }
    const SortedBoxes of_moving(boxes, moving, axes);
    pairs.add_within(of_moving);
    pairs.add_between(of_moving, SortedBoxes(boxes, fixed, axes));
}

/// Returns the keys of the pairs that overlap, in no order.
std::vector<std::uint32_t> overlapping_keys(std::span<const WorldBox> boxes,
                                            std::span<const std::uint8_t> is_fixed) {
    const BoxSample sample(boxes);
    const Axes axes = sample.axes();
    const Indices order = sorted_by_low(boxes, axes[0]);
    const auto fixed = static_cast<std::size_t>(std::ranges::count_if(is_fixed, std::identity()));
    PairCollector pairs;
    if (fixed > boxes.size() / 4 * 3) {
        add_moving_pairs(boxes, is_fixed, order, axes, pairs);
        return pairs.take();
    }
    add_all_pairs(boxes, order, sample, pairs);
    std::vector<std::uint32_t> keys = pairs.take();
    if (fixed > 1) {
        std::erase_if(keys, [&](std::uint32_t key) {
            return is_fixed[key >> 16] != 0 && is_fixed[key & 0xFFFFu] != 0;
        });
    }
    return keys;
}

} // namespace

std::vector<BodyPair> overlapping_pairs(std::span<const WorldBox> boxes,
                                        std::span<const std::uint8_t> is_fixed) {
    CD_CHECK(boxes.size() <= boxes_max);
    CD_CHECK(is_fixed.empty() || is_fixed.size() == boxes.size());
    if (boxes.size() < 2) {
        return {};
    }
    std::vector<std::uint32_t> keys = overlapping_keys(boxes, is_fixed);
    NumberSorter().sort(keys);
    std::vector<BodyPair> pairs(keys.size());
    std::ranges::transform(keys, pairs.begin(), [](std::uint32_t key) {
        return BodyPair{key >> 16, key & 0xFFFFu};
    });
    return pairs;
}

} // namespace cd
