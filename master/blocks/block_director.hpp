// Decides whether the master or a peer sends a block of geometry to a worker that wants it. A state
// machine without sockets, clocks or threads.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
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

/// Action: the master sends the block to the worker.
struct SendBlock {
    WorkerId to;
    BlockKey block;

    friend bool operator==(const SendBlock&, const SendBlock&) = default;
};

/// Action: the master tells the worker to fetch the blocks from the first source that has them.
struct SendToPeers {
    WorkerId to;
    TreeId tree;
    std::vector<RootIndex> roots;  ///< Ascending.
    std::vector<WorkerId> sources; ///< Best first; at most `limits::peer_sources_max`.

    friend bool operator==(const SendToPeers&, const SendToPeers&) = default;
};

using BlockAction = std::variant<SendBlock, SendToPeers>;
using BlockActions = std::vector<BlockAction>;

/// The master sends a block to one worker. Workers that hold it then pass it on, each to at most
/// `limits::peer_uploads_max` others at a time: a block that all workers want spreads like a tree
/// and costs the master a bounded number of uploads. A worker waits for a block that no source can
/// send now but some worker soon can. The master sends the block if no other worker has received it
/// for `timing::peer_wait_max`. A worker counts as a holder only once it has reported the block. A
/// source that the master or two workers cannot reach, or that sends a damaged block, is not named
/// again. If peers fail to deliver a block, so that the worker wants it again, the master sends it.
class BlockDirector {
  public:
    using Time = BlockIndex::Time;

    /// `serves`: peers can fetch blocks from this worker.
    void worker_joined(WorkerId worker, bool serves);
    BlockActions worker_left(WorkerId worker, Time now);

    BlockActions wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    BlockActions held(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    BlockActions evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now);
    /// Handles a report that the source gave the worker none of these blocks. The worker tries its
    /// next source or requests them again. Ignored if the master did not name this source to the
    /// worker; otherwise a worker could exclude any other worker from serving.
    BlockActions peer_failed(WorkerId worker,
                             WorkerId source,
                             TreeId tree,
                             std::span<const RootIndex> roots,
                             PeerOutcome how,
                             Time now);
    /// Never names the source again, because a probe did not reach its port.
    BlockActions not_reached(WorkerId source, Time now);
    BlockActions tree_removed(TreeId tree, Time now);

    /// Advances the time. Call about every `timing::peer_check_period` while `open` is not 0.
    BlockActions time_is(Time now);

    /// Returns the number of wanted blocks that have not arrived, over all workers.
    [[nodiscard]] std::size_t open() const;
    /// Blocks that a worker has reported as held. The worker must have joined. Empty if it does not
    /// serve peers.
    [[nodiscard]] const BlockIndex::Blocks& held_by(WorkerId worker) const {
        return index_.at(worker).holds;
    }
    /// Returns whether the worker must not be named as a source any more.
    [[nodiscard]] bool is_avoided(WorkerId worker) const;

    /// Aborts if an invariant is broken. For tests; call it after each event.
    void check_invariants() const;

  private:
    using FetchId = BlockIndex::FetchId;

    /// Blocks that a worker fetches from peers because of one SendToPeers.
    struct Fetch {
        WorkerId to;
        WorkerId source; ///< First source, while the fetch takes one of its upload slots; else 0.
        std::vector<WorkerId> named; ///< All sources named to the worker.
        std::size_t left = 0;        ///< Number of the blocks that are still under way.
        Time deadline;
    };
    /// Consequences of one event, which `settle` handles at the end.
    struct Event {
        Time now;
        std::set<WorkerId> have_places; ///< Sources that have a free upload slot again.
        std::set<BlockKey> less_hope;   ///< Blocks that fewer workers can give than before.
        BlockActions actions;
    };

    /// Roots that the current event already takes from each source.
    using RootsBySource = std::map<WorkerId, std::vector<RootIndex>>;

    /// Returns the best source of the block for the worker; 0 if there is none. Splits one request
    /// among at most `limits::sources_of_a_request_max` sources, unless these lack some blocks.
    [[nodiscard]] WorkerId
    first_source(const BlockIndex::Block& block, WorkerId worker, const RootsBySource& given) const;
    /// Returns the source with the fewest uploads among those that have a free upload slot and that
    /// this event does not use yet; 0 if there is none.
    [[nodiscard]] WorkerId
    new_source(const BlockIndex::Block& block, WorkerId worker, const RootsBySource& given) const;
    /// Returns the source with the fewest blocks to give among those that this event uses already;
    /// 0 if there is none.
    [[nodiscard]] WorkerId
    given_source(const BlockIndex::Block& block, WorkerId worker, const RootsBySource& given) const;

    /// Chooses the source of a wanted block, and adds a peer to `given`, or lets the worker wait.
    void want(WorkerId worker, const BlockKey& block, RootsBySource& given, Event& event);
    void send_from_master(WorkerId worker, const BlockKey& block, Event& event);
    /// Sends the awaited blocks that no worker has received for `timing::peer_wait_max`.
    void send_what_does_not_spread(Event& event);
    void fetch(
        WorkerId worker, TreeId tree, std::vector<RootIndex> roots, WorkerId source, Event& event);
    /// Ends both the block's delivery to the worker and the worker's wait for it.
    void forget_delivery(WorkerId worker, const BlockKey& block, Event& event);
    /// Counts down the blocks of the fetch: one more has arrived, or will not arrive.
    void end_part(FetchId fetch, Event& event);
    /// Frees the upload slot that the fetch takes.
    void free_place(Fetch& fetch, Event& event);
    void lose_hold(WorkerId worker, const BlockKey& block, Event& event);
    /// Call when some or all workers can no longer fetch from this source. For each of its blocks,
    /// `settle` then checks whether the workers that wait for the block still have a source.
    void serves_fewer(WorkerId source, Event& event);

    /// Ends an event: assigns freed upload slots to waiting workers, and lets the master send the
    /// blocks that workers would await in vain.
    BlockActions settle(Event event);
    /// Gives the source's blocks to workers waiting for them, while it has upload slots.
    void offer(WorkerId source, Event& event);
    /// Lets the master send the block to the waiting workers to which no peer can give it any more.
    void rescue(const BlockKey& block, Event& event);

    BlockIndex index_;
    std::map<FetchId, Fetch> fetches_;
    FetchId fetch_last_ = 0;
};

} // namespace cd
