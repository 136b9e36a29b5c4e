// A priority queue of node pairs, the most promising pair first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace cd {

/// Indices of a node of A and a node of B.
struct WidePair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;

    friend bool operator==(const WidePair&, const WidePair&) = default;
};

/// A priority queue of pairs of boxes that overlap. The rank of a pair is computed as follows: on
/// each axis of both frames, divide the distance of the boxes' centres by the sum of their half
/// sizes. Take the largest of the six quotients, which is 0 where the centres coincide and 1 where
/// the boxes barely meet; multiply it by `count` and truncate. Among equal ranks the last pair
/// pushed is popped first, so that a search continues locally.
class PairBuckets {
  public:
    static constexpr std::int32_t count = 64;

    void clear() {
        filled_ = 0;
        size_ = 0;
        free_ = none;
        used_ = 0;
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    /// Returns the least rank of all pairs. The queue is not empty.
    [[nodiscard]] std::int32_t least_rank() const { return __builtin_ctzll(filled_); }

    /// Accepts any rank and clamps it to 0 to `count` - 1.
    void push(WidePair pair, std::int32_t rank) {
        const auto bucket = static_cast<std::size_t>(std::clamp(rank, 0, count - 1));
        const std::uint32_t entry = take_entry();
        const bool is_filled = (filled_ >> bucket & 1) != 0;
        entries_[entry] = {pair, is_filled ? heads_[bucket] : none};
        heads_[bucket] = entry;
        filled_ |= std::uint64_t{1} << bucket;
        ++size_;
    }

    /// Removes and returns the most promising pair. The queue is not empty.
    [[nodiscard]] WidePair pop() {
        const auto bucket = static_cast<std::size_t>(__builtin_ctzll(filled_));
        const std::uint32_t entry = heads_[bucket];
        const Entry taken = entries_[entry];
        heads_[bucket] = taken.next;
        if (taken.next == none) {
            filled_ &= filled_ - 1;
        }
        entries_[entry].next = free_;
        free_ = entry;
        --size_;
        return taken.pair;
    }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    struct Entry {
        WidePair pair;
        std::uint32_t next; ///< Index of the next entry in the same bucket or in the free list.
    };

    std::uint32_t take_entry() {
        if (free_ != none) {
            const std::uint32_t entry = free_;
            free_ = entries_[entry].next;
            return entry;
        }
        if (used_ == room_) {
            grow();
        }
        return used_++;
    }

    void grow() {
        const std::uint32_t room = std::max(2 * room_, 1024u);
        auto larger = std::make_unique_for_overwrite<Entry[]>(room);
        std::copy_n(entries_.get(), used_, larger.get());
        entries_ = std::move(larger);
        room_ = room;
    }

    std::uint64_t filled_ = 0; ///< Bit i is set if bucket i holds pairs.
    std::array<std::uint32_t, count> heads_{};
    std::unique_ptr<Entry[]>
        entries_; // A vector would initialise entries that are written before they are read.
    std::uint32_t room_ = 0;
    std::uint32_t used_ = 0; ///< Entries from this index on were never used.
    std::uint32_t free_ = none;
    std::size_t size_ = 0;
};

} // namespace cd
