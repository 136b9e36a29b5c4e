// Which scenarios wait for which subtrees, and which may run: a state machine without I/O.
#pragma once

#include "common/core/id.hpp"
#include "worker/subtree_cache.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

namespace cd {

/// Takes scenarios in, says which subtrees to ask for and which scenarios are ready.
///
/// A scenario is admitted in the order of coming, as soon as what all admitted ones need fits the
/// cache's limit, and always when it is the only one. From then until `finished` its subtrees are
/// pinned, so what has come for it stays. Admitted scenarios do not wait for each other. A missing
/// subtree is asked for once, however many wait for it.
class Fetcher {
  public:
    using Token = std::uint64_t; ///< Names a scenario.

    /// What a scenario met when it was admitted.
    struct Admission {
        Token token = 0;
        std::uint64_t found = 0;       ///< Of its subtrees, in the cache.
        std::vector<SubtreeKey> asked; ///< It is the first to lack them.
    };
    struct Hinted {
        JobId job;
        SubtreeKey key;
    };
    struct Step {
        std::vector<SubtreeKey> want; ///< Ascending.
        std::vector<Hinted> hinted;   ///< Of these, before a scenario needs them.
        std::vector<Token> ready;     ///< In the order in which they became so.
        std::vector<Admission> admitted;
    };

    explicit Fetcher(SubtreeCache& cache) : cache_(cache) {}

    /// `roots` are distinct and exist in the cache's trees. The token is new.
    void add(Token token, std::vector<SubtreeKey> roots);
    /// Scenarios to come will need it. It is asked for when no scenario here waits for anything
    /// and little is under way, if nothing has to leave the cache for it; else it is forgotten, as
    /// the oldest is when there are too many. The root exists in the cache's trees.
    void hint(const Hinted& hinted);
    /// Ranges of a tree need its top, which stays once it has come. True: it is asked for now.
    bool want_top(TreeId tree);
    /// The cache holds this block now, or has refused it as unneeded.
    void arrived(const SubtreeKey& key);
    /// The scenario needs its subtrees no longer: it has run, or is given up at whatever stage.
    void finished(Token token);

    /// Asked for and not here, ascending.
    [[nodiscard]] std::vector<SubtreeKey> awaited() const;

    /// What is to be done since the last call.
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
        std::set<Token> waiting; ///< Possibly none.
        std::uint64_t bytes = 0; ///< Expected.
    };
    struct Use {
        std::uint32_t scenarios = 0;
        std::uint64_t bytes = 0; ///< As expected when first used.
    };

    [[nodiscard]] bool fits(const Need& need) const;
    void admit(Token token, Need& need, Step& step);
    void ask_for_hinted(Step& step);
    /// False: it has been asked for before.
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
