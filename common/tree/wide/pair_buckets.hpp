// Pairs of nodes that wait to be looked at, the most promising first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace cd {

/// A node of A and one of B, by their indices.
struct WidePair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

/// A priority queue of pairs of boxes that overlap. Their rank: on each axis of both frames the
/// distance of their middles by the sum of half their sizes, the largest of the six, which is 0
/// where one sits in the middle of the other and 1 where they barely meet; times `count`, cut off.
/// Of equal ranks the last to come is the first to go, so that a search goes on where it is.
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

    /// Any rank: one out of range counts as the nearest in it.
    void push(WidePair pair, std::int32_t rank) {
        const auto bucket = static_cast<std::size_t>(std::clamp(rank, 0, count - 1));
        const std::uint32_t entry = take_entry();
        const bool is_filled = (filled_ >> bucket & 1) != 0;
        entries_[entry] = {pair, is_filled ? heads_[bucket] : none};
        heads_[bucket] = entry;
        filled_ |= std::uint64_t{1} << bucket;
        ++size_;
    }

    /// Takes the most promising. There is one.
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
        std::uint32_t next; ///< In the same bucket, or of those that are free.
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

    std::uint64_t filled_ = 0; ///< Which buckets hold pairs.
    std::array<std::uint32_t, count> heads_{};
    std::unique_ptr<Entry[]> entries_; // Not a vector, which would set what is written anyway.
    std::uint32_t room_ = 0;
    std::uint32_t used_ = 0; ///< The entries from there on were never used.
    std::uint32_t free_ = none;
    std::size_t size_ = 0;
};

} // namespace cd
