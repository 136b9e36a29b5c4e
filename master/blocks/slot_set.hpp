// A set of workers' slots, stored as a bit vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cd {

/// Slots are small numbers that are reused. `insert`, `erase` and `contains` take constant time;
/// `next` and `next_common` scan the bit vector.
class SlotSet {
  public:
    using Slot = std::uint32_t;
    static constexpr Slot none = ~Slot{0};

    /// Returns false if the set has the slot already.
    bool insert(Slot slot);
    /// Returns false if the set does not have the slot.
    bool erase(Slot slot);
    [[nodiscard]] bool contains(Slot slot) const;
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

    /// Returns the least slot that is at least `from`; `none` if there is none.
    [[nodiscard]] Slot next(Slot from) const;
    /// Returns the least slot of both sets that is at least `from`; `none` if there is none.
    [[nodiscard]] Slot next_common(const SlotSet& other, Slot from) const;
    /// Removes all slots that the other set does not have.
    void intersect(const SlotSet& other);

  private:
    std::vector<std::uint64_t> words_;
    std::size_t size_ = 0;
};

} // namespace cd
