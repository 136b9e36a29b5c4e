// Answers a motion's questions by searches of two bodies.
#pragma once

#include "common/motion/cells.hpp"
#include "common/motion/pair_spheres.hpp"
#include "common/search/contact_search.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstddef>
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
                  std::optional<double> clearance)
        : search_(search), pairs_(pairs), spheres_(pairs), clearance_(clearance) {}

    /// Whether the bodies are at most this far apart.
    [[nodiscard]] bool is_within(const PosePair& poses, double distance);
    /// Whether the bodies touch.
    [[nodiscard]] bool is_contact(const PosePair& poses);
    [[nodiscard]] bool is_event(const PosePair& poses) {
        return clearance_ ? is_within(poses, *clearance_) : is_contact(poses);
    }

    /// Returns these questions for `search_cells`, which polls `stop`. This object outlives them.
    [[nodiscard]] CellQuestions for_cells(StopCheck stop = {});

    /// Returns the cost of all answers so far.
    [[nodiscard]] const QueryStatistics& statistics() const { return statistics_; }

  private:
    template <class IsFound>
    bool ask(const PosePair& poses, double clearance, const IsFound& is_found);

    ContactSearch& search_;
    std::span<const SubtreePair> pairs_;
    PairSpheres spheres_; ///< Of `pairs_`.
    std::optional<double> clearance_;
    std::size_t last_ = 0; ///< The pair that answered yes last; it mostly does so again.
    QueryStatistics statistics_;
};

} // namespace cd
