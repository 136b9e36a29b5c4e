// Answers a motion's questions by searches of two bodies.
#pragma once

#include "common/motion/cells.hpp"
#include "common/motion/cut_bodies.hpp"
#include "common/search/contact_search.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/query_statistics.hpp"

#include <optional>
#include <variant>

namespace cd {

/// The bodies of a motion: whole trees or cut ones. The caller keeps them alive.
using MovingTrees = std::variant<SubtreePair, const CutBodies*>;

class TreeQuestions {
  public:
    /// The options of the search have a clearance. The event is that of `clearance`: without one,
    /// contact. The search outlives this object.
    TreeQuestions(ContactSearch& search, const MovingTrees& trees, std::optional<double> clearance)
        : search_(search), trees_(trees), clearance_(clearance) {}

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
    template <class IsFound>
    bool ask_roots(const CutBodies& bodies,
                   const PosePair& poses,
                   double distance,
                   const IsFound& is_found);

    ContactSearch& search_;
    MovingTrees trees_;
    std::optional<double> clearance_;
    std::optional<RootPair> last_; ///< The last pair that answered yes; the first one to try.
    QueryStatistics statistics_;
};

} // namespace cd
