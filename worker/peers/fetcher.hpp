// Decides which scenarios wait for which subtrees and which may run: a state machine without I/O.
#pragma once

#include "common/core/id.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

namespace cd {

/// Queues scenarios and reports which subtrees to request and which scenarios are ready.
///
/// Admits scenarios in order of arrival, each as soon as its subtrees and the subtrees of all
/// admitted scenarios fit into the cache. A single scenario is always admitted. Subtrees stay
/// pinned from a scenario's admission to `finished`. Admitted scenarios do not wait for each other.
/// A missing subtree is requested once, even if several scenarios wait for it.
class Fetcher {
  public:
    using Token = std::uint64_t; ///< Identifies a scenario.

    /// The state of the cache when a scenario was admitted.
    struct Admission {
        JobId job;
        std::uint64_t found = 0;       ///< How many of the scenario's subtrees were cached.
        std::vector<SubtreeKey> asked; ///< Subtrees that this scenario is the first to request.
    };
    /// A subtree that a Hint named, and the job of that Hint.
    struct Hinted {
        JobId job;
        SubtreeKey key;
    };
    struct Step {
        std::vector<SubtreeKey> want; ///< Blocks to request now, ascending.
        std::vector<Hinted> hinted;   ///< The part of `want` that only hints request.
        std::vector<Token> ready;     ///< Scenarios in the order in which they became ready.
        std::vector<Admission> admitted;
    };

    explicit Fetcher(SubtreeCache& cache) : cache_(cache) {}

    /// Queues a scenario that needs `roots`, which are distinct and exist in the cache's trees;
    /// `top_root` names an upper tree. The token is new.
    void add(Token token, JobId job, std::vector<SubtreeKey> roots);
    /// Announces a subtree that future scenarios will need. The subtree is requested when no
    /// scenario waits for a subtree and requests are below `limits::hinted_bytes_max`. The hint is
    /// dropped if the cache would have to evict for the subtree from a tree that is not parked, or
    /// once `limits::hints_max` newer hints wait. The root must exist in the cache's trees.
    void hint(const Hinted& hinted);
    /// Requests the upper tree, which ranges need and the cache never evicts. Returns false if the
    /// upper tree is cached or requested already.
    bool want_top(TreeId tree);
    /// Records that this block has arrived, even if the cache has evicted the block at once.
    void arrived(const SubtreeKey& key);
    /// Releases a scenario's subtrees after it has run or was dropped, at any stage.
    void finished(Token token);

    /// Returns the blocks requested and not received, ascending.
    [[nodiscard]] std::vector<SubtreeKey> awaited() const;

    /// Returns the requests and ready scenarios since the last call.
    [[nodiscard]] Step advance();

    /// Drops all requests for the tree. Call it before the cache parks the tree.
    void forget_requests(TreeId tree);

    [[nodiscard]] std::size_t size() const { return needs_.size(); } ///< Unfinished scenarios.

  private:
    /// An unfinished scenario.
    struct Need {
        JobId job;
        std::vector<SubtreeKey> roots;
        std::size_t missing = 0; ///< Number of `roots` that have not arrived; 0 until admission.
        bool is_admitted = false;
    };
    /// A block requested and not received.
    struct Request {
        std::set<Token> waiting; ///< Scenarios that wait for the block; none if only hints name it.
        std::uint64_t bytes = 0; ///< Expected size in memory.
    };
    /// A subtree that admitted scenarios need.
    struct Use {
        std::uint32_t scenarios = 0;
        std::uint64_t bytes = 0; ///< Expected size in memory, at first use.
    };

    [[nodiscard]] bool fits(const Need& need) const;
    void admit(Token token, Need& need, Step& step);
    void ask_for_hinted(Step& step);
    /// Adds a request. Returns false if the block is requested already.
    [[nodiscard]] bool ask_once(const SubtreeKey& key);
    void drop_request(std::map<SubtreeKey, Request>::iterator request);

    SubtreeCache& cache_;
    std::map<Token, Need> needs_;
    std::deque<Token> queue_; ///< Scenarios not admitted; may include finished ones.
    std::map<SubtreeKey, Use> used_;
    std::map<SubtreeKey, Request> requested_;
    std::uint64_t requested_bytes_ = 0;
    std::deque<Hinted> hinted_;      ///< Hinted subtrees that are not requested yet.
    std::vector<SubtreeKey> wanted_; ///< Upper trees requested since the last step.
    std::uint64_t used_bytes_ = 0;
    std::size_t admitted_ = 0;
    std::vector<Token> ready_;
};

} // namespace cd
