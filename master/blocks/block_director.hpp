// Decides who gives a block of geometry to the worker that wants it, the master or another worker:
// a state machine without sockets, clocks or threads.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/tree/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <chrono>
#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <variant>
#include <vector>

namespace cd {

struct BlockKey {
    TreeId tree;
    RootIndex root = 0;

    friend auto operator<=>(const BlockKey&, const BlockKey&) = default;
};

/// The master sends the block itself.
struct SendBlock {
    WorkerId to;
    BlockKey block;

    friend bool operator==(const SendBlock&, const SendBlock&) = default;
};

/// The worker fetches these blocks, roots ascending, from the first of the sources that gives them.
struct SendToPeers {
    WorkerId to;
    TreeId tree;
    std::vector<RootIndex> roots;
    std::vector<WorkerId> sources; ///< At most `limits::peer_sources_max`.

    friend bool operator==(const SendToPeers&, const SendToPeers&) = default;
};

using BlockAction = std::variant<SendBlock, SendToPeers>;
using BlockActions = std::vector<BlockAction>;

/// A block goes out from the master once; from then on workers that have it hand it on, each to at
/// most `limits::peer_uploads_max` others at a time, so that a block that all want spreads like a
/// tree and costs the master a bounded number of uploads. A worker that wants a block which nobody
/// can give now, but some worker is about to hold, waits; after `limits::peer_wait_max` the master
/// gives the block.
///
/// A worker holds a block when it says so, never before. A source that the master or two workers
/// cannot reach, or that gives a damaged block, is not named again. A block that a worker wants a
/// second time, although peers were to give it, comes from the master.
class BlockDirector {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `serves`: other workers can ask it for blocks.
    void worker_joined(WorkerId worker, bool serves);
    BlockActions worker_left(WorkerId worker, Time now);

    BlockActions wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    BlockActions held(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    BlockActions evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    /// The source gave the worker none of these; the worker goes on to the next source, or wants
    /// them again. Nothing happens where the worker was not told of this source: it could keep
    /// others from serving.
    BlockActions peer_failed(WorkerId worker,
                             WorkerId source,
                             TreeId tree,
                             std::span<const RootIndex> roots,
                             PeerOutcome how,
                             Time now);
    /// A probe did not reach its port.
    BlockActions not_reached(WorkerId source, Time now);
    BlockActions tree_removed(TreeId tree, Time now);

    /// Call this about every `limits::peer_check_period` while anything is `open`.
    BlockActions time_is(Time now);

    /// Blocks wanted and not yet held.
    [[nodiscard]] std::size_t open() const;
    /// The blocks that a worker, which is here and serves others, reported to hold.
    [[nodiscard]] const std::set<BlockKey>& held_by(WorkerId worker) const {
        return peers_.at(worker).holds;
    }
    /// Whether the worker is no longer named as a source.
    [[nodiscard]] bool is_avoided(WorkerId worker) const;

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    using FetchId = std::uint64_t;     ///< 0: the master sends it.
    using PlaceInLine = std::uint64_t; ///< A waiting worker's position in the queue.

    struct Peer {
        bool serves = false;
        bool is_avoided = false;
        std::set<WorkerId> cannot_reach_it;
        std::size_t uploads = 0; ///< Fetches for which it is the first source.
        std::set<BlockKey> holds;
        std::set<BlockKey> could_give;      ///< Held blocks that some worker waits for.
        std::map<BlockKey, Time> waits_for; ///< With the time at which the wait began.
        PlaceInLine place = 0;
        std::map<BlockKey, FetchId> comes;
    };
    struct Fetch {
        WorkerId to;
        WorkerId source; ///< The first one, whose place is taken; 0 when it has none any more.
        std::vector<WorkerId> named; ///< All sources that the worker was told.
        std::size_t left = 0;
        Time deadline;
    };
    struct Block {
        std::set<WorkerId> holders;
        std::set<WorkerId> on_the_way_to;
        std::map<PlaceInLine, WorkerId> awaited_by;
    };
    /// The consequences of one event, settled at its end.
    struct Event {
        Time now;
        std::set<WorkerId> have_places; ///< Sources that may have something to give now.
        std::set<BlockKey> less_hope;   ///< Blocks that a holder or a receiver was lost of.
        BlockActions actions;
    };

    [[nodiscard]] bool can_serve(WorkerId source, WorkerId worker) const;
    /// Other workers hold the block, or are about to, and could give it later.
    [[nodiscard]] bool is_worth_waiting(const Block& block, WorkerId worker) const;
    /// The source with a free place that has been given the least; 0: none.
    [[nodiscard]] WorkerId
    first_source(const Block& block,
                 WorkerId worker,
                 const std::map<WorkerId, std::vector<RootIndex>>& given) const;

    void want(WorkerId worker,
              const BlockKey& block,
              std::map<WorkerId, std::vector<RootIndex>>& given,
              Event& event);
    void wait_for(WorkerId worker, const BlockKey& block, Event& event);
    /// It no longer waits for the block, if it did.
    void stop_waiting(WorkerId worker, const BlockKey& block);
    void send_from_master(WorkerId worker, const BlockKey& block, Event& event);
    void fetch(
        WorkerId worker, TreeId tree, std::vector<RootIndex> roots, WorkerId source, Event& event);
    /// The block no longer comes to the worker, and it waits for it no longer.
    void forget_delivery(WorkerId worker, const BlockKey& block, Event& event);
    void free_place(Fetch& fetch, Event& event);
    void add_hold(WorkerId worker, const BlockKey& block);
    void lose_hold(WorkerId worker, const BlockKey& block, Event& event);
    /// It may have become one that some, or all, are not sent to: those may wait for it in vain.
    void serves_fewer(WorkerId source, Event& event);
    void forget_if_unused(const BlockKey& block);

    BlockActions settle(Event event);
    /// Gives what the source holds to those who wait for it, while it has places.
    void offer(WorkerId source, Event& event);
    /// The first in line that waits for something that the source holds, and may have it; 0: none.
    [[nodiscard]] WorkerId next_for(WorkerId source) const;
    /// To be called when its uploads change, or whether it is avoided.
    void note_places(WorkerId source);
    /// Where nobody can give a block any more, those who wait get it from the master.
    void rescue(const BlockKey& block, Event& event);

    std::map<WorkerId, Peer> peers_;
    std::map<BlockKey, Block> blocks_; ///< Held, awaited, or on the way.
    std::map<FetchId, Fetch> fetches_;
    FetchId fetch_last_ = 0;
    PlaceInLine place_last_ = 0;
    std::size_t servers_ = 0; ///< Workers that serve others.
    // So that an event costs what it touches, and not what all workers hold or wait for:
    std::map<PlaceInLine, WorkerId> line_; ///< Waiting workers, in the order in which they came.
    std::set<WorkerId> free_;              ///< Sources with a free place.
};

} // namespace cd
