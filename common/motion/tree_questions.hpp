// Answers a motion's questions by searches of two bodies.
//
// Bodies on a cluster are cut into many subtrees. Where a cell is halved, the pairs of subtrees
// that are far apart in all of it are dropped for its parts. This changes no answer: let such a
// pair be farther apart than d (1 + 2^-21) at the middle of a cell, with d >= M + d0. At the middle
// of a part that k halvings make, the pair has come at most M (1 - 2^-k) nearer, and M' of the part
// is at most M 2^-k. So the pair is farther apart than M' + d0 + d 2^-21 there, more than what
// rounding adds to M' + d0. Nor does the event hold for it at any time of the cell.
#pragma once

#include "common/motion/cells.hpp"
#include "common/search/contact_search.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Asks one search about pairs of subtrees that together hold all pairs of triangles that matter.
class TreeQuestions {
  public:
    /// The options of the search have a clearance. The event is that of `clearance`: without one,
    /// contact. Search and pairs outlive this object.
    TreeQuestions(ContactSearch& search,
                  std::span<const SubtreePair> pairs,
                  std::optional<double> clearance);

    /// Whether the bodies touch.
    [[nodiscard]] bool is_contact(const PosePair& poses);

    /// Returns these questions for `search_cells`, which polls `stop`. This object outlives them.
    [[nodiscard]] CellQuestions for_cells(StopCheck stop = {});

    /// Returns the cost of all answers so far.
    [[nodiscard]] const QueryStatistics& statistics() const { return statistics_; }

  private:
    /// Numbers of pairs. The one that answered yes last is the first: it mostly does so again.
    using Live = std::vector<std::uint32_t>;

    [[nodiscard]] bool is_within(const PosePair& poses, double distance);
    [[nodiscard]] bool is_event(const PosePair& poses);
    void halve(const PosePair& poses, double distance);

    void prepare(const PosePair& poses, double clearance);
    template <class IsFound>
    bool ask(const PosePair& poses, double clearance, Live& live, const IsFound& is_found);

    ContactSearch& search_;
    std::span<const SubtreePair> pairs_;
    std::optional<double> clearance_;
    std::vector<Live> live_; ///< By level: the pairs that may be near in the cell of that level.
    unsigned level_ = 0;     ///< Of the entered cell.
    QueryStatistics statistics_;
};

} // namespace cd
