// Records for each worker the blocks of geometry that it reports to hold, waits for, and is being
// sent. To assign work, the dispatcher uses a plan of future blocks instead
// (master/dispatch/blocks/block_plan.hpp).
#pragma once

#include "common/core/id.hpp"
#include "common/tree/cut.hpp"
#include "master/blocks/slot_set.hpp"
#include "proto/messages/work_messages.hpp"

#include <boost/container/flat_map.hpp>
#include <boost/container/flat_set.hpp>

#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace cd {

/// Identifies the block of one distribution root.
struct BlockKey {
    TreeId tree;
    RootIndex root = 0;

    friend auto operator<=>(const BlockKey&, const BlockKey&) = default;
};

/// Stores each relation twice, at the worker and at the block, so that no change has to search.
/// Unless stated otherwise, a worker that is passed must have joined.
class BlockIndex {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using FetchId = std::uint64_t; ///< 0: the master sends the block.
    using Slot = SlotSet::Slot;    ///< A worker's place, which a later worker may get.
    using Blocks = boost::container::flat_set<BlockKey>;
    using PlaceInLine = std::uint64_t; ///< A waiting worker's position in the queue.

    struct Peer {
        WorkerId id;
        Slot slot = 0;
        bool serves = false;                ///< Peers can fetch blocks from this worker.
        bool is_avoided = false;            ///< This worker must not be named as a source any more.
        std::set<WorkerId> cannot_reach_it; ///< Workers that could not connect to this one.
        std::size_t uploads = 0;            ///< Fetches for which this worker is the first source.
        Blocks holds;
        std::map<BlockKey, Time> waits_for; ///< Awaited blocks, with the start of each wait.
        PlaceInLine place = 0;              ///< Valid while this worker waits for a block.
        std::map<BlockKey, FetchId> comes;  ///< Blocks under way to this worker.
    };
    struct Block {
        SlotSet holders;                            ///< Only workers that serve peers.
        SlotSet on_the_way_to;                      ///< Workers that are being sent the block.
        std::map<PlaceInLine, WorkerId> awaited_by; ///< Workers that wait for the block.
        Time last_spread = {}; ///< When a worker last reported to hold the block.
    };

    // ---- Workers ------------------------------------------------------------------------------
    /// Adds a new worker. `serves`: peers can fetch blocks from it.
    void join(WorkerId worker, bool serves);
    /// Removes a worker. It must not hold, wait for, or be sent any block.
    void leave(WorkerId worker);
    /// All workers, by their slots; null at a free slot.
    [[nodiscard]] const std::vector<std::unique_ptr<Peer>>& peers() const { return peers_; }
    [[nodiscard]] const Peer& at(WorkerId worker) const { return *peers_[slots_.at(worker)]; }
    /// Null if the worker has not joined.
    [[nodiscard]] const Peer* find(WorkerId worker) const;
    /// True if the worker may fetch from the source. False for a source that has not joined.
    [[nodiscard]] bool can_serve(WorkerId source, WorkerId worker) const;
    [[nodiscard]] static bool can_serve(const Peer& source, WorkerId worker);
    /// True if some peer that holds the block, or soon will, can give it to the worker later.
    [[nodiscard]] bool is_worth_waiting(const Block& block, WorkerId worker) const;
    /// Sources with a free upload slot.
    [[nodiscard]] const SlotSet& free() const { return free_; }
    void add_upload(WorkerId source);
    void remove_upload(WorkerId source);
    /// Records that worker `by` cannot reach the source. Avoids a source once
    /// `limits::peer_unreachable_by_max` workers cannot reach it.
    void set_unreachable(WorkerId source, WorkerId by);
    /// Never offers this worker as a source of any block again. Transfers under way continue.
    void avoid(WorkerId source);

    // ---- Blocks -------------------------------------------------------------------------------
    /// All blocks that some worker holds, waits for, or is being sent.
    [[nodiscard]] const std::map<BlockKey, Block>& blocks() const { return blocks_; }
    /// Returns the block, and adds it if it is new. It stays until `forget_if_unused`.
    [[nodiscard]] const Block& known(const BlockKey& block) { return blocks_[block]; }
    void forget_if_unused(const BlockKey& block);

    /// Records that the worker holds the block. Does nothing if the worker serves no peers.
    void add_hold(WorkerId worker, const BlockKey& block, Time now);
    /// Undoes `add_hold`. False if the worker did not hold the block, or has not joined.
    bool lose_hold(WorkerId worker, const BlockKey& block);
    /// Starts the worker's wait for a block that `blocks` has and that it does not await yet.
    void wait(WorkerId worker, const BlockKey& block, Time now);
    /// Ends the worker's wait for the block, if any.
    void stop_waiting(WorkerId worker, const BlockKey& block);
    /// Records that the block is under way to the worker.
    void send(WorkerId worker, const BlockKey& block, FetchId fetch);
    /// Undoes `send`. Returns the block's fetch; empty if the block was not under way.
    std::optional<FetchId> stop_sending(WorkerId worker, const BlockKey& block);

    /// Blocks that some worker waits for.
    using Awaited = boost::container::flat_map<BlockKey, const Block*>;
    [[nodiscard]] const Awaited& awaited() const { return awaited_; }
    /// The first waiting worker that may get a block from the source; 0: none.
    [[nodiscard]] WorkerId next_for(WorkerId source) const;

    /// Aborts if an invariant is broken. For tests.
    void check_invariants() const;

  private:
    [[nodiscard]] Peer& peer(WorkerId worker) { return *peers_[slots_.at(worker)]; }
    /// True if some worker of the set can serve this one.
    [[nodiscard]] bool has_source(const SlotSet& sources, WorkerId worker) const;
    [[nodiscard]] static bool has_place(const Peer& peer);
    /// Updates `free_` after a change of the source.
    void note_places(const Peer& source);

    std::unordered_map<WorkerId, Slot> slots_;
    std::vector<std::unique_ptr<Peer>> peers_; ///< By slot.
    std::vector<Slot> slots_left_;             ///< Slots of workers that left.
    std::map<BlockKey, Block> blocks_;
    PlaceInLine place_last_ = 0;
    std::size_t servers_ = 0; ///< Number of workers that serve peers.
    Awaited awaited_;         ///< Points into `blocks_`.
    SlotSet free_;
};

} // namespace cd
