#include "master/blocks/slot_set.hpp"

#include <algorithm>
#include <bit>

namespace cd {

namespace {

constexpr std::uint64_t bit_of(SlotSet::Slot slot) {
    return std::uint64_t{1} << slot % 64;
}

/// Returns the position of the first set bit at or after `from`. `word(i)` returns word i.
template <class Word>
SlotSet::Slot first_bit(std::size_t words, SlotSet::Slot from, const Word& word) {
    std::uint64_t keep = ~std::uint64_t{0} << from % 64;
    for (std::size_t i = from / 64; i < words; ++i, keep = ~std::uint64_t{0}) {
        if (const std::uint64_t bits = word(i) & keep; bits != 0) {
            return static_cast<SlotSet::Slot>(64 * i + std::countr_zero(bits));
        }
    }
    return SlotSet::none;
}

} // namespace

bool SlotSet::insert(Slot slot) {
    if (contains(slot)) {
        return false;
    }
    words_.resize(std::max<std::size_t>(words_.size(), slot / 64 + 1));
    words_[slot / 64] |= bit_of(slot);
    ++size_;
    return true;
}

bool SlotSet::erase(Slot slot) {
    if (!contains(slot)) {
        return false;
    }
    words_[slot / 64] &= ~bit_of(slot);
    --size_;
    return true;
}

bool SlotSet::contains(Slot slot) const {
    return slot / 64 < words_.size() && (words_[slot / 64] & bit_of(slot)) != 0;
}

SlotSet::Slot SlotSet::next(Slot from) const {
    return first_bit(words_.size(), from, [&](std::size_t i) { return words_[i]; });
}

SlotSet::Slot SlotSet::next_common(const SlotSet& other, Slot from) const {
    return first_bit(std::min(words_.size(), other.words_.size()), from, [&](std::size_t i) {
        return words_[i] & other.words_[i];
    });
}

void SlotSet::intersect(const SlotSet& other) {
    words_.resize(std::min(words_.size(), other.words_.size()));
    size_ = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        words_[i] &= other.words_[i];
        size_ += static_cast<std::size_t>(std::popcount(words_[i]));
    }
}

} // namespace cd
