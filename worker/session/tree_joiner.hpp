// Joins the blocks of trees that a session's descents use, on its threads.
#pragma once

#include "worker/cache/joined_trees.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/walk.hpp"
#include "worker/session/session_hub.hpp"

namespace cd {

class TreeJoiner {
  public:
    /// Both outlive this object. Joined trees take the room that the cache leaves of its limit.
    TreeJoiner(SessionHub& hub, const SubtreeCache& cache) : hub_(hub), cache_(cache) {}

    /// Gives a descent the joined trees that there are, and starts the steps that are due.
    void prepare(Walk& walk);

  private:
    void start(const JoinedTrees::Step& step);

    SessionHub& hub_;
    const SubtreeCache& cache_;
    JoinedTrees trees_;
};

} // namespace cd
