// Sends blocks of geometry to the workers, or names the peers that they fetch blocks from.
#pragma once

#include "master/base/event_loop.hpp"
#include "master/blocks/block_director.hpp"
#include "master/geometry/tree_registry.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/network.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace cd {

/// Carries out the decisions of `BlockDirector` on the workers' channels. Runs on the loop's
/// thread. Ignores events of unknown workers and of trees that are no longer used.
class BlockDelivery {
  public:
    struct Parts {
        asio::any_io_executor executor; ///< Runs coroutines on the loop's thread.
        EventLoop& loop;
        Network& network; ///< Reaches the workers' ports.
        Pool& pool;       ///< Encodes blocks again if their file is damaged.
        const TreeRegistry& trees;
    };

    /// All parts outlive this object.
    explicit BlockDelivery(const Parts& parts) : parts_(parts) {}
    BlockDelivery(const BlockDelivery&) = delete;
    BlockDelivery& operator=(const BlockDelivery&) = delete;
    /// Stops all transfers when the master ends.
    void close();

    /// `port`: the worker's port for peers, 0 if it serves none. Probes the port; a worker that
    /// cannot be reached there never becomes a source of blocks.
    void worker_joined(WorkerId worker,
                       std::shared_ptr<Channel> channel,
                       const PeerKey& key,
                       std::uint16_t port);
    void worker_left(WorkerId worker);
    /// Handles a broken connection: the worker gets no blocks, and peers none from it, until it
    /// returns.
    void worker_detached(WorkerId worker);
    /// Handles a reconnection. The worker then reports the blocks that it holds and wants.
    void worker_returned(WorkerId worker, std::shared_ptr<Channel> channel);

    /// Returns whether blocks of the tree may be sent to the worker.
    [[nodiscard]] bool knows(WorkerId worker, TreeId tree) const;
    /// Handles a request for blocks. Errors: BadFrame for a root that the tree lacks.
    [[nodiscard]] Status wanted(WorkerId worker, const WantSubtrees& want);
    /// Handles a report of held blocks. Errors: BadFrame for a root that the tree lacks.
    [[nodiscard]] Status held(WorkerId worker, const Held& held);
    void evicted(WorkerId worker, const Evicted& evicted);
    /// Handles a worker's report that it could not fetch blocks from a peer.
    void failed(WorkerId worker, const FetchFailed& failed);
    void tree_removed(TreeId tree);

    /// Counts the blocks that the master itself, not a peer, has sent to a worker.
    struct Sent {
        std::uint64_t blocks = 0;
        std::uint64_t bytes = 0; ///< Compressed bytes.
    };
    [[nodiscard]] Sent sent_to(WorkerId worker) const;
    /// The port at which a worker serves others.
    struct PeerPort {
        std::uint16_t port = 0;
        bool is_reachable = true; ///< False: it is not named as a source any more.
    };
    /// Empty if the worker serves no peers.
    [[nodiscard]] std::optional<PeerPort> peer_port_of(WorkerId worker) const;
    /// Blocks that a connected worker has reported as held. Empty if it serves no peers.
    [[nodiscard]] const BlockIndex::Blocks& held_by(WorkerId worker) const {
        return director_.held_by(worker);
    }
    /// Aborts if an invariant is broken. For tests; call it after each event.
    void check_invariants() const { director_.check_invariants(); }

  private:
    struct Link {
        std::shared_ptr<Channel> channel;
        PeerKey key;
        std::string host;
        std::uint16_t port = 0;
        std::uint64_t ticket_last = 0; ///< Number of the last ticket for fetches from this worker.
        std::deque<BlockKey> queue;    ///< Blocks that the master has yet to send.
        bool sending = false;
        Sent sent;
    };

    /// Checks that the tree, which must be in use, has all these roots. Errors: BadFrame.
    [[nodiscard]] Status check_roots(TreeId tree, const std::vector<RootIndex>& roots) const;
    void probe(WorkerId worker);
    [[nodiscard]] asio::awaitable<void>
    probe(WorkerId worker, Endpoint endpoint, std::weak_ptr<Channel> channel);
    void act(const BlockActions& actions);
    void send(const SendBlock& action);
    void direct(const SendToPeers& action);
    [[nodiscard]] asio::awaitable<void> send_queue(WorkerId worker);
    /// Sends blocks of the tree from the head of the queue in one message. Returns false if the
    /// first block cannot be read from disk.
    static bool send_some(Link& link, TreeId tree, const Cut& cut);
    static void send_blocks(Link& link, const Cut& cut, const Subtrees& subtrees);
    /// Call if `block` cannot be read from disk: builds it again on a pool, and sends it if it is
    /// still the first of the worker's queue.
    [[nodiscard]] asio::awaitable<void> send_anew(WorkerId worker, BlockKey block);
    void watch_time();

    Parts parts_;
    BlockDirector director_;
    std::map<WorkerId, Link> links_;
    bool watching_ = false;
    bool closed_ = false;
};

} // namespace cd
