// Records which worker holds, awaits or is sent which block of geometry.
#pragma once

#include "common/core/id.hpp"
#include "common/tree/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

namespace cd {

struct BlockKey {
    TreeId tree;
    RootIndex root = 0;

    friend auto operator<=>(const BlockKey&, const BlockKey&) = default;
};

/// Workers and blocks, each with its side of the relations, so that a change costs what it touches.
/// Unless said otherwise a named worker must have joined.
class BlockIndex {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using FetchId = std::uint64_t;     ///< 0: the master sends the block.
    using PlaceInLine = std::uint64_t; ///< A waiting worker's position in the queue.

    struct Peer {
        bool serves = false;
        bool is_avoided = false;
        std::set<WorkerId> cannot_reach_it;
        std::size_t uploads = 0; ///< Fetches for which it is the first source.
        std::set<BlockKey> holds;
        std::set<BlockKey> could_give;      ///< Held blocks that some worker waits for.
        std::map<BlockKey, Time> waits_for; ///< Awaited blocks, with the start of each wait.
        PlaceInLine place = 0;
        std::map<BlockKey, FetchId> comes;
    };
    struct Block {
        std::set<WorkerId> holders;
        std::set<WorkerId> on_the_way_to;
        std::map<PlaceInLine, WorkerId> awaited_by;
    };

    // ---- Workers ------------------------------------------------------------------------------
    /// The worker must be new. `serves`: peers can fetch blocks from it.
    void join(WorkerId worker, bool serves);
    /// The worker holds, awaits and is sent nothing any more.
    void leave(WorkerId worker);
    [[nodiscard]] const std::map<WorkerId, Peer>& peers() const { return peers_; }
    [[nodiscard]] const Peer& at(WorkerId worker) const { return peers_.at(worker); }
    /// Null if the worker has not joined.
    [[nodiscard]] const Peer* find(WorkerId worker) const;
    /// False for workers that have not joined.
    [[nodiscard]] bool can_serve(WorkerId source, WorkerId worker) const;
    /// Returns whether peers that hold the block, or soon will, could give it later.
    [[nodiscard]] bool is_worth_waiting(const Block& block, WorkerId worker) const;
    /// Sources with a free upload slot.
    [[nodiscard]] const std::set<WorkerId>& free() const { return free_; }
    void add_upload(WorkerId source);
    void remove_upload(WorkerId source);
    /// Avoids a source that so many workers cannot reach, `limits::peer_unreachable_by_max`.
    void set_unreachable(WorkerId source, WorkerId by);
    /// The source is not named any more.
    void avoid(WorkerId source);

    // ---- Blocks -------------------------------------------------------------------------------
    /// Blocks held, awaited, or in transit.
    [[nodiscard]] const std::map<BlockKey, Block>& blocks() const { return blocks_; }
    /// The block, which is in the index from now on, until `forget_if_unused`.
    [[nodiscard]] const Block& known(const BlockKey& block) { return blocks_[block]; }
    void forget_if_unused(const BlockKey& block);

    /// Ignored for a worker from which peers cannot fetch.
    void add_hold(WorkerId worker, const BlockKey& block);
    /// False if the worker did not hold it, or has not joined.
    bool lose_hold(WorkerId worker, const BlockKey& block);
    /// The worker must not await the block, which must be known.
    void wait(WorkerId worker, const BlockKey& block, Time now);
    /// Ends the worker's wait for the block, if any.
    void stop_waiting(WorkerId worker, const BlockKey& block);
    /// The block is under way to the worker.
    void send(WorkerId worker, const BlockKey& block, FetchId fetch);
    /// Ends the block's delivery to the worker. Returns how it came; empty if it did not.
    std::optional<FetchId> stop_sending(WorkerId worker, const BlockKey& block);

    /// Waiting workers in order of arrival.
    [[nodiscard]] const std::map<PlaceInLine, WorkerId>& line() const { return line_; }
    /// The first waiting worker that may get a block from the source; 0: none.
    [[nodiscard]] WorkerId next_for(WorkerId source) const;

    /// Aborts when an invariant is broken; for tests.
    void check_invariants() const;

  private:
    [[nodiscard]] static bool has_place(const Peer& peer);
    void note_places(WorkerId source);

    std::map<WorkerId, Peer> peers_;
    std::map<BlockKey, Block> blocks_;
    PlaceInLine place_last_ = 0;
    std::size_t servers_ = 0; ///< Number of workers that serve peers.
    std::map<PlaceInLine, WorkerId> line_;
    std::set<WorkerId> free_;
};

} // namespace cd
