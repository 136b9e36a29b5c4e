// Decides whether the master or a peer sends a block of geometry to a worker that wants it. A state
// machine without sockets, clocks or threads.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/tree/cut.hpp"
#include "master/blocks/block_index.hpp"
#include "proto/messages/work_messages.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <variant>
#include <vector>

namespace cd {

/// The master sends the block itself.
struct SendBlock {
    WorkerId to;
    BlockKey block;

    friend bool operator==(const SendBlock&, const SendBlock&) = default;
};

/// The worker fetches these blocks, roots ascending, from the first source that has them.
struct SendToPeers {
    WorkerId to;
    TreeId tree;
    std::vector<RootIndex> roots;
    std::vector<WorkerId> sources; ///< At most `limits::peer_sources_max`.

    friend bool operator==(const SendToPeers&, const SendToPeers&) = default;
};

using BlockAction = std::variant<SendBlock, SendToPeers>;
using BlockActions = std::vector<BlockAction>;

/// The master sends a block once. Workers that hold it then pass it on, each to at most
/// `limits::peer_uploads_max` others at a time: a block that all want spreads like a tree and costs
/// the master a bounded number of uploads. A worker waits for a block that no source can send now
/// but some worker will soon hold; after `limits::peer_wait_max` the master sends it. A worker
/// holds a block only once it reports so. A source that the master or two workers cannot reach, or
/// that sends a damaged block, is not named again. A block that a worker wants again, although
/// peers were to send it, comes from the master.
class BlockDirector {
  public:
    using Time = BlockIndex::Time;

    /// `serves`: peers can fetch blocks from this worker.
    void worker_joined(WorkerId worker, bool serves);
    BlockActions worker_left(WorkerId worker, Time now);

    BlockActions wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    BlockActions held(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    BlockActions evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    /// The source gave the worker none of these blocks; the worker tries the next source or wants
    /// them again. Ignored if the worker was not told of this source: otherwise it could keep
    /// others from serving.
    BlockActions peer_failed(WorkerId worker,
                             WorkerId source,
                             TreeId tree,
                             std::span<const RootIndex> roots,
                             PeerOutcome how,
                             Time now);
    /// A probe did not reach the source's port.
    BlockActions not_reached(WorkerId source, Time now);
    BlockActions tree_removed(TreeId tree, Time now);

    /// Advances the time. Call about every `limits::peer_check_period` while `open` is not 0.
    BlockActions time_is(Time now);

    /// Returns the number of blocks wanted and not yet held.
    [[nodiscard]] std::size_t open() const;
    /// Blocks that a connected worker which serves peers reported to hold.
    [[nodiscard]] const std::set<BlockKey>& held_by(WorkerId worker) const {
        return index_.at(worker).holds;
    }
    /// Returns whether the worker is no longer named as a source.
    [[nodiscard]] bool is_avoided(WorkerId worker) const;

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    using FetchId = BlockIndex::FetchId;

    struct Fetch {
        WorkerId to;
        WorkerId source; ///< First source, whose upload slot is taken; 0: it no longer has one.
        std::vector<WorkerId> named; ///< All sources named to the worker.
        std::size_t left = 0;
        Time deadline;
    };
    /// Consequences of one event, settled at its end.
    struct Event {
        Time now;
        std::set<WorkerId> have_places; ///< Sources that may now have something to give.
        std::set<BlockKey> less_hope;   ///< Blocks that lost a holder or a receiver.
        BlockActions actions;
    };

    /// Returns the least loaded source with a free upload slot; 0: none.
    [[nodiscard]] WorkerId
    first_source(const BlockIndex::Block& block,
                 WorkerId worker,
                 const std::map<WorkerId, std::vector<RootIndex>>& given) const;

    void want(WorkerId worker,
              const BlockKey& block,
              std::map<WorkerId, std::vector<RootIndex>>& given,
              Event& event);
    void send_from_master(WorkerId worker, const BlockKey& block, Event& event);
    void fetch(
        WorkerId worker, TreeId tree, std::vector<RootIndex> roots, WorkerId source, Event& event);
    /// Ends both the block's delivery to the worker and the worker's wait for it.
    void forget_delivery(WorkerId worker, const BlockKey& block, Event& event);
    /// One block of the fetch has arrived, or will not arrive.
    void end_part(FetchId fetch, Event& event);
    void free_place(Fetch& fetch, Event& event);
    void lose_hold(WorkerId worker, const BlockKey& block, Event& event);
    /// Handles a source that some or all workers may no longer use: waits for it may be in vain.
    void serves_fewer(WorkerId source, Event& event);

    BlockActions settle(Event event);
    /// Gives the source's blocks to workers waiting for them, while it has upload slots.
    void offer(WorkerId source, Event& event);
    /// Sends a block that no peer can give any more from the master to all who wait.
    void rescue(const BlockKey& block, Event& event);

    BlockIndex index_;
    std::map<FetchId, Fetch> fetches_;
    FetchId fetch_last_ = 0;
};

} // namespace cd
