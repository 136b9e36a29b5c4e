// Finds the contacts of two trees: simultaneous descent, then the exact decision.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/search/contact_pair.hpp"
#include "common/tree/box_test.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/query_statistics.hpp"
#include "common/tree/wide/wide_descent.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// What a search looks for beside the contacts themselves.
struct SearchOptions {
    bool keep_pairs = true;    ///< False: what is found is only counted.
    bool only_touches = false; ///< Once a pair is proper, none are kept any more.
    /// Keeps no more than about twice so many pairs at a time, and the first so many in the end;
    /// all are counted.
    std::uint64_t pairs_max = std::numeric_limits<std::uint64_t>::max();
    /// Keeps the corners of each found pair beside it, for shared points: the subtrees may be gone
    /// by then.
    bool keep_corners = false;
    /// Above 0, two overlapping boxes whose diameters sum to no more than this are left undecided.
    double tolerance = 0;
    PairStage first_stage = PairStage::Float; ///< See TrianglePairTest.
    PairDecision decision = PairDecision::Exact;
    StopCheck stop = {}; ///< Asked every so many steps of the descent.
};

/// One scenario's search, and then the next one's: after a few, `restart`, `any`, `collect` and
/// `sort` allocate nothing where doubles decide in wide trees. Subtrees of A and B, which any
/// number of searches may share, are handed in pair by pair; what they hold in contact gathers in
/// `pairs`, or is counted. One thread at a time.
///
/// The decision of a pair is exact and boxes never reject a touching pair, so what is found does
/// not depend on how the trees were cut into subtrees, nor on which trees are walked: the wide ones
/// where both views have them and there is no tolerance, else the binary ones.
class ContactSearch {
  public:
    /// `ignored` outlives the search.
    ContactSearch(const PosePair& poses,
                  std::span<const IgnoredRange> ignored,
                  const SearchOptions& options = {});

    /// As if made anew with other poses, but keeps scratch memory, and what `any` expects.
    void restart(const PosePair& poses);

    /// True as soon as any two triangles under the two roots are known to touch. Adds nothing to
    /// `pairs`. Expects what it found the last time, under whichever poses: after a contact it
    /// looks at the most promising boxes first, after none it goes as `collect` does. So the
    /// statistics depend on what was asked before, the answer never does.
    [[nodiscard]] bool any(const TreeView& a, const TreeView& b);

    /// Adds every contact under the two roots to `pairs`, but for those in boxes that the tolerance
    /// leaves undecided.
    void collect(const TreeView& a, const TreeView& b);

    /// Whether any boxes were left undecided so far, and then a bound on the distance of the two
    /// bodies in the world, which is always true; infinite where the poses are far from rigid. The
    /// same bits on every host: one sequence of operations, never fused.
    [[nodiscard]] std::optional<double> undecided_distance() const { return undecided_; }

    /// True when the search was told to stop: what was found by then is not the answer.
    [[nodiscard]] bool is_stopped() const { return is_stopped_; }

    /// B's coordinates in A's, under the poses at hand.
    [[nodiscard]] const RelativePose& b_to_a() const { return relative_; }

    /// How many pairs `collect` has found, and whether any of them is proper.
    [[nodiscard]] std::uint64_t pair_count() const { return pair_count_; }
    [[nodiscard]] bool has_proper() const { return has_proper_; }

    /// Sorts the pairs, each with its corners, and keeps the first `pairs_max`.
    void sort();

    /// As found, until sorted.
    [[nodiscard]] const std::vector<ContactPair>& pairs() const { return pairs_; }
    /// The same, for the caller to keep; then there are none any more.
    [[nodiscard]] std::vector<ContactPair> take_pairs();
    /// One for each of `pairs` if they were to be kept, else none.
    [[nodiscard]] const std::vector<PairCorners>& corners() const { return corners_; }
    [[nodiscard]] TrianglePairTest& test() { return test_; }
    [[nodiscard]] QueryStatistics statistics() const;

  private:
    struct NodePair {
        std::uint32_t a;
        std::uint32_t b;
    };

    template <class OnLeaves>
    bool descend(const TreeView& a, const TreeView& b, const OnLeaves& on_leaves);
    [[nodiscard]] const BoxTest& boxes();
    [[nodiscard]] double stretch_under(const PosePair& poses) const;
    [[nodiscard]] bool must_stop(std::uint32_t steps);
    [[nodiscard]] bool leave_undecided(const ObbNode& a, const ObbNode& b);
    void add_candidates(const TreeView& a, const TreeView& b, const NodePair& leaves);
    [[nodiscard]] bool decide_any(const TreeView& a, const TreeView& b);
    void decide_candidates(const TreeView& a, const TreeView& b);
    [[nodiscard]] bool any_in_wide(const WideView& a, const WideView& b);
    void collect_in_wide(const WideView& a, const WideView& b);
    /// Whether both have wide trees, and these will do.
    [[nodiscard]] bool uses_wide(const TreeView& a, const TreeView& b) const;
    /// The next candidates of the wide trees, without those to be ignored.
    [[nodiscard]] std::span<const Candidate>
    next_candidates(const WideView& a, const WideView& b, std::size_t wanted);
    /// Decides the candidates, whose triangles are a TriangleSpan's or TriangleBlocks.
    template <class Triangles>
    void add_contacts(const Triangles& a,
                      std::span<const std::uint32_t> ids_a,
                      const Triangles& b,
                      std::span<const std::uint32_t> ids_b,
                      std::span<const Candidate> candidates);

    RelativePose relative_;
    std::optional<BoxTest> boxes_; ///< Made when a binary tree is first walked.
    WideDescent descent_;
    std::span<const IgnoredRange> ignored_;
    SearchOptions options_;
    double stretch_; ///< Bounds how many times longer A's pose can make a vector.
    TrianglePairTest test_;
    std::vector<ContactPair> pairs_;
    std::vector<PairCorners> corners_;
    PairSorter sorter_;
    std::vector<NodePair> stack_;
    std::vector<Aabb> bounds_;          ///< Of the triangles of one leaf of B, as A sees them.
    std::vector<Candidate> candidates_; ///< Not yet decided; by places in the trees at hand.
    std::optional<double> undecided_;
    std::uint64_t pair_count_ = 0;
    bool has_proper_ = false;
    bool expects_contact_ = true; ///< What `any` found last.
    bool is_stopped_ = false;
    std::uint32_t steps_unchecked_ = 0; ///< Since `stop` was last asked.
    std::uint64_t box_tests_ = 0;
    std::uint64_t triangle_tests_ = 0;
};

/// All contact pairs of two whole trees, sorted.
[[nodiscard]] std::vector<ContactPair>
contact_pairs(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd
