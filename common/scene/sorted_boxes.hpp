// Boxes in the order of a sweep.
#pragma once

#include "common/scene/sweep_kernel.hpp"
#include "common/scene/world_box.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Columns of some boxes, sorted by their low ends on an axis of the sweep.
class SortedBoxes {
  public:
    /// Takes the boxes whose indices are in `order`, which is the order of their low ends on the
    /// first one of `axes`.
    SortedBoxes(std::span<const WorldBox> boxes,
                std::span<const std::uint32_t> order,
                const std::array<std::size_t, 3>& axes);

    [[nodiscard]] SweepColumns columns() const;
    [[nodiscard]] std::size_t count() const { return body_.size() - sweep_padding; }

  private:
    std::array<std::vector<float>, 3> low_;
    std::array<std::vector<float>, 3> high_;
    std::vector<std::uint32_t> body_;
};

/// Collects the pairs of boxes that overlap.
class PairCollector {
  public:
    /// Adds the pairs of boxes of one list.
    void add_within(const SortedBoxes& boxes);
    /// Adds the pairs of a box of one list and a box of the other.
    void add_between(const SortedBoxes& left, const SortedBoxes& right);
    /// Returns the keys of all pairs (`write_overlaps`), in no order.
    [[nodiscard]] std::vector<std::uint32_t> take();

  private:
    void add(const SortedBoxes& rows, const SortedBoxes& others, SweepFrom from);

    std::vector<std::uint32_t> blocks_;
    std::vector<std::uint32_t> keys_;
    std::size_t count_ = 0; ///< Of `keys_`; the rest is room.
};

} // namespace cd
