#include "common/tree/root_holders.hpp"

#include "common/core/check.hpp"
#include "common/tree/row_sums.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t bit_of(std::uint32_t holder) {
    return std::uint64_t{1} << (holder % 64);
}

} // namespace

RootHolders::RootHolders(std::uint32_t root_count, std::uint32_t holder_count)
    : root_count_(root_count), counts_(root_count, 0) {
    grow(holder_count);
}

void RootHolders::grow(std::uint32_t holder_count) {
    CD_CHECK(holder_count >= holder_count_);
    holder_count_ = holder_count;
    roots_.resize(holder_count, 0);
    const std::size_t needed = (std::size_t{holder_count} + 63) / 64;
    if (needed <= row_words_) {
        return;
    }
    // Rows grow by an eighth: holders join one by one by the thousand, and each growth copies all
    // rows. A row's length depends only on the number of holders, so that the sums of two trees
    // have equal lengths.
    std::size_t words = 0;
    while (words < needed) {
        words += std::max<std::size_t>(1, words / 8);
    }
    std::vector<std::uint64_t> wider(words * root_count_, 0);
    for (std::size_t root = 0; root < root_count_; ++root) {
        std::copy_n(bits_.begin() + static_cast<std::ptrdiff_t>(root * row_words_),
                    row_words_,
                    wider.begin() + static_cast<std::ptrdiff_t>(root * words));
    }
    bits_ = std::move(wider);
    row_words_ = words;
}

bool RootHolders::holds(std::uint32_t holder, RootIndex root) const {
    return (bits_[word_of(holder, root)] & bit_of(holder)) != 0;
}

bool RootHolders::set(std::uint32_t holder, RootIndex root) {
    if (holds(holder, root)) {
        return false;
    }
    bits_[word_of(holder, root)] |= bit_of(holder);
    ++counts_[root];
    ++roots_[holder];
    ++set_count_;
    return true;
}

bool RootHolders::clear(std::uint32_t holder, RootIndex root) {
    if (!holds(holder, root)) {
        return false;
    }
    bits_[word_of(holder, root)] &= ~bit_of(holder);
    --counts_[root];
    --roots_[holder];
    --set_count_;
    return true;
}

void RootHolders::clear_all(std::uint32_t holder) {
    for (RootIndex root = 0; root < root_count_; ++root) {
        clear(holder, root);
    }
}

void RootHolders::add_held(std::span<const WeightedRoot> roots,
                           std::span<std::uint64_t> sums) const {
    CD_CHECK(sums.size() == sum_count());
    add_row_sums(roots, bits_.data(), row_words_, sums);
}

std::uint64_t RootHolders::held(std::uint32_t holder, std::span<const WeightedRoot> roots) const {
    std::uint64_t sum = 0;
    for (const WeightedRoot& root : roots) {
        sum += holds(holder, root.root) ? root.weight : 0;
    }
    return sum;
}

} // namespace cd
