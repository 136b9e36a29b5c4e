// Pairs of triangles with their true classes, in the engines' input form.
#pragma once

#include "bench/peers/engines/engine.hpp"
#include "common/tree/wide/candidates_at_once.hpp"
#include "tests/support/hard_pairs.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace cd::bench {

/// Decides a group as the product does, and calls `on_kinds` with the classes of consecutive
/// candidates.
template <class OnKinds>
void decide_as_product(TrianglePairTest& test, const PairGroup& group, const OnKinds& on_kinds) {
    const auto decide = [&](const auto& a, const auto& b, std::span<const Candidate> all) {
        for (std::size_t i = 0; i < all.size(); i += candidates_at_once) {
            const std::size_t size = std::min(candidates_at_once, all.size() - i);
            on_kinds(test.classify(a, b, all.subspan(i, size)));
        }
    };
    if (group.in_blocks.candidates.empty()) {
        decide(group.a, group.b, group.candidates);
    } else {
        decide(group.in_blocks.a, group.in_blocks.b, group.in_blocks.candidates);
    }
}

/// Returns the first `count` candidates of a group, or all if there are fewer.
[[nodiscard]] PairGroup first_candidates(PairGroup group, std::size_t count);

/// Groups with the data they refer to. Neighbours under equal poses share a group, like the
/// candidates of a scenario.
class PairBatch {
  public:
    /// Takes independent pairs.
    explicit PairBatch(std::span<const tests::PosedPair> pairs);
    /// Takes groups whose triangles the caller keeps.
    explicit PairBatch(std::vector<PairGroup> groups);
    PairBatch(const PairBatch&) = delete;
    PairBatch& operator=(const PairBatch&) = delete;
    PairBatch(PairBatch&&) = default;
    PairBatch& operator=(PairBatch&&) = default;
    ~PairBatch() = default;

    [[nodiscard]] std::span<const PairGroup> groups() const { return groups_; }
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Returns the batch with A and B swapped.
    [[nodiscard]] PairBatch swapped() const;
    /// Returns the batch with the corners of A rotated and those of B mirrored.
    [[nodiscard]] PairBatch reordered() const;

    /// Returns the oracle's class of each pair, using `threads` threads, which have ended on
    /// return.
    [[nodiscard]] std::vector<PairClass> truth(unsigned threads) const;

  private:
    PairBatch() = default;
    void count();

    // A deque keeps its vectors in place when the batch moves or grows.
    std::deque<std::vector<Vec3>> vertices_;
    std::deque<std::vector<Triangle>> triangles_;
    std::deque<std::vector<Candidate>> candidates_;
    std::vector<PairGroup> groups_;
    std::size_t size_ = 0;
};

} // namespace cd::bench
