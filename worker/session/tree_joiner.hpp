// Joins the blocks of the trees that a session's descents use, on the worker's threads.
#pragma once

#include "worker/cache/joined_trees.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/walk.hpp"
#include "worker/session/session_hub.hpp"

namespace cd {

class TreeJoiner {
  public:
    /// Both arguments outlive this object. Joined trees use the memory that the cache does not.
    TreeJoiner(SessionHub& hub, const SubtreeCache& cache) : hub_(hub), cache_(cache) {}

    /// Passes the existing joined trees to a descent, and starts the steps that are due.
    void prepare(Walk& walk);

  private:
    void start(const JoinedTrees::Step& step);

    SessionHub& hub_;
    const SubtreeCache& cache_;
    JoinedTrees trees_;
};

} // namespace cd
