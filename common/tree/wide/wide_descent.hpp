// Finds the pairs of triangles of two wide trees whose boxes may overlap.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/wide/wide_kernel.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace cd {

/// The descent of two wide trees under one relative pose. Never passes over a pair that touches, in
/// exact terms. Keeps scratch memory between calls; one thread at a time.
class WideDescent {
  public:
    /// `error_scale` multiplies both margins. Only from 1 on is what is passed over proven to be
    /// apart: less is for tests, which show that the margins are needed.
    explicit WideDescent(const RelativePose& b_to_a, double error_scale = 1);

    /// As if made anew with another pose, but keeps scratch memory.
    void restart(const RelativePose& b_to_a);

    /// How the descent goes about it.
    enum class Aim : std::uint8_t {
        All,         ///< Every candidate: many pairs of nodes are looked at together.
        First,       ///< A first contact that may not exist: as All, but finds candidates sooner.
        LikelyFirst, ///< A first contact: the most promising pairs of nodes (`PairBuckets`) one by
                     ///< one, and after `dive_visits` of them as First.
    };

    /// Nearly all contacts that exist are found by then; each of these visits costs more than those
    /// that follow.
    static constexpr std::uint32_t dive_visits = 16;

    /// Begins at the roots. The trees have nodes and outlive the descent.
    void start(const WideView& a, const WideView& b, Aim aim = Aim::All);
    [[nodiscard]] bool is_done() const {
        return walk_.waiting_count + walk_.leaf_count + walk_.ranked.size() == 0;
    }
    /// More candidates: as places in the blocks, `wanted` or some more, or fewer after much work
    /// without finding so many. Valid until the next call.
    [[nodiscard]] std::span<Candidate> next(std::size_t wanted);

    /// Tests of boxes so far.
    [[nodiscard]] std::uint64_t box_tests() const { return walk_.box_tests; }
    /// Pairs of nodes looked at so far.
    [[nodiscard]] std::uint64_t visits() const { return walk_.visits; }

  private:
    void dive();
    void grow();

    std::uint32_t dive_visits_left_ = 0;
    RelativePose b_to_a_;
    double error_scale_;
    WidePose pose_;
    WideWalk walk_;
    // Not vectors, which would set what is written anyway.
    std::unique_ptr<WidePair[]> waiting_;
    std::unique_ptr<Candidate[]> candidates_;
    std::size_t candidates_room_ = 0;
};

} // namespace cd
