// Sends blocks of geometry to the workers, or names the peers that they fetch blocks from.
#pragma once

#include "master/blocks/block_director.hpp"
#include "master/geometry/tree_registry.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/endpoint.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace cd {

/// Carries out the director's decisions on the workers' channels. Runs on the executor's thread.
/// Ignores events of unknown workers and of trees that are no longer used.
class BlockDelivery {
  public:
    BlockDelivery(asio::any_io_executor executor, const TreeRegistry& trees);
    BlockDelivery(const BlockDelivery&) = delete;
    BlockDelivery& operator=(const BlockDelivery&) = delete;
    /// Stops all transfers and timers when the master ends.
    void close();

    /// `port` is the worker's port for peers, or 0 if it serves none. A worker that a probe does
    /// not reach is never a source.
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
    /// The worker wants blocks. Errors: BadFrame for a root that the tree lacks.
    [[nodiscard]] Status wanted(WorkerId worker, const WantSubtrees& want);
    /// The worker holds blocks. Errors: BadFrame for a root that the tree lacks.
    [[nodiscard]] Status held(WorkerId worker, const Held& held);
    void evicted(WorkerId worker, const Evicted& evicted);
    /// The worker could not fetch blocks from a peer.
    void failed(WorkerId worker, const FetchFailed& failed);
    void tree_removed(TreeId tree);

    /// Blocks that the master, and no peer, has sent to a worker.
    struct Sent {
        std::uint64_t blocks = 0;
        std::uint64_t bytes = 0; ///< Compressed bytes.
    };
    [[nodiscard]] Sent sent_to(WorkerId worker) const;
    /// Blocks that the worker reported to hold. Empty if it serves no peers. It must be connected.
    [[nodiscard]] const std::set<BlockKey>& held_by(WorkerId worker) const {
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

    /// The tree must be known.
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
    static bool send_some(Link& link, TreeId tree, const CutGeometry& geometry);
    static void send_blocks(Link& link, Subtrees subtrees);
    /// Call if `block` cannot be read from disk: builds it again on a pool, and sends it if it is
    /// still the first of the worker's queue.
    [[nodiscard]] asio::awaitable<void> send_anew(WorkerId worker, BlockKey block);
    [[nodiscard]] asio::awaitable<void> watch_time();

    asio::any_io_executor executor_;
    const TreeRegistry& trees_;
    BlockDirector director_;
    std::map<WorkerId, Link> links_;
    asio::steady_timer timer_;
    bool watching_ = false;
    bool closed_ = false;
};

} // namespace cd
