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

/// Queues scenarios, and tells which subtrees to ask for and which scenarios are ready.
///
/// Scenarios are admitted in the order in which they came: each as soon as the subtrees of all
/// admitted ones fit the cache's limit, and always if it is the only one. From then until
/// `finished` its subtrees are pinned, so that they stay once they have come. Admitted scenarios do
/// not wait for each other. A missing subtree is asked for once, however many wait for it.
class Fetcher {
  public:
    using Token = std::uint64_t; ///< Names a scenario.

    /// The state of the cache when a scenario was admitted.
    struct Admission {
        Token token = 0;
        std::uint64_t found = 0;       ///< Subtrees in the cache.
        std::vector<SubtreeKey> asked; ///< Subtrees that it is the first to ask for.
    };
    struct Hinted {
        JobId job;
        SubtreeKey key;
    };
    struct Step {
        std::vector<SubtreeKey> want; ///< Ascending.
        std::vector<Hinted> hinted;   ///< The part of `want` that only hints ask for.
        std::vector<Token> ready;     ///< In the order in which they became ready.
        std::vector<Admission> admitted;
    };

    explicit Fetcher(SubtreeCache& cache) : cache_(cache) {}

    /// `roots` are distinct and exist in the cache's trees. The token is new.
    void add(Token token, std::vector<SubtreeKey> roots);
    /// Future scenarios will need the subtree. Asks for it when no scenario waits and little is
    /// under way, if nothing has to leave the cache for it; else forgets the hint, as it does the
    /// oldest of too many. The root exists in the cache's trees.
    void hint(const Hinted& hinted);
    /// Ranges of a tree need its top, which stays once it has come. True if it is asked for now.
    bool want_top(TreeId tree);
    /// The cache holds this block now, or has refused it as unneeded.
    void arrived(const SubtreeKey& key);
    /// The scenario needs its subtrees no longer: it has run, or was given up at any stage.
    void finished(Token token);

    /// Asked for and not here, ascending.
    [[nodiscard]] std::vector<SubtreeKey> awaited() const;

    /// Returns what has become due since the last call.
    [[nodiscard]] Step advance();

    /// Call before the cache removes the tree: subtrees of it no longer come.
    void forget_requests(TreeId tree);

    [[nodiscard]] std::size_t size() const { return needs_.size(); } ///< Not finished.

  private:
    struct Need {
        std::vector<SubtreeKey> roots;
        std::size_t missing = 0;
        bool is_admitted = false;
    };
    struct Request {
        std::set<Token> waiting; ///< May be empty.
        std::uint64_t bytes = 0; ///< Expected.
    };
    struct Use {
        std::uint32_t scenarios = 0;
        std::uint64_t bytes = 0; ///< As expected when first used.
    };

    [[nodiscard]] bool fits(const Need& need) const;
    void admit(Token token, Need& need, Step& step);
    void ask_for_hinted(Step& step);
    /// False if it has been asked for before.
    [[nodiscard]] bool ask_once(const SubtreeKey& key);
    void drop_request(std::map<SubtreeKey, Request>::iterator request);

    SubtreeCache& cache_;
    std::map<Token, Need> needs_;
    std::deque<Token> queue_; ///< Not admitted; may name finished ones.
    std::map<SubtreeKey, Use> used_;
    std::map<SubtreeKey, Request> requested_;
    std::uint64_t requested_bytes_ = 0;
    std::deque<Hinted> hinted_;      ///< Not asked for.
    std::vector<SubtreeKey> wanted_; ///< Tops, since the last step.
    std::uint64_t used_bytes_ = 0;
    std::size_t admitted_ = 0;
    std::vector<Token> ready_;
};

} // namespace cd
