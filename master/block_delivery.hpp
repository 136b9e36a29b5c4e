// Carries blocks of geometry to the workers, or tells them from whom to fetch them.
#pragma once

#include "master/block_director.hpp"
#include "master/tree_registry.hpp"
#include "proto/asio.hpp"
#include "proto/channel.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace cd {

/// The director's decisions on the workers' channels. Runs on the executor's thread. Of a worker
/// that is not here, and of a tree that nobody uses any more, it hears nothing.
class BlockDelivery {
  public:
    BlockDelivery(asio::any_io_executor executor, const TreeRegistry& trees);
    BlockDelivery(const BlockDelivery&) = delete;
    BlockDelivery& operator=(const BlockDelivery&) = delete;
    /// The master ends: what is under way is not watched any more.
    void close();

    /// `port`: where it serves others; 0: nowhere. One that a probe does not reach is nobody's
    /// source.
    void worker_joined(WorkerId worker,
                       std::shared_ptr<Channel> channel,
                       const PeerKey& key,
                       std::uint16_t port);
    void worker_left(WorkerId worker);
    /// The connection broke: nothing more goes there, and nobody is sent there.
    void worker_detached(WorkerId worker);
    /// It has a connection again. What it holds it says, and what it still wants.
    void worker_returned(WorkerId worker, std::shared_ptr<Channel> channel);

    /// Errors: BadFrame for a root that the tree does not have.
    /// Blocks of the tree may be sent to the worker.
    [[nodiscard]] bool knows(WorkerId worker, TreeId tree) const;
    [[nodiscard]] Status wanted(WorkerId worker, const WantSubtrees& want);
    [[nodiscard]] Status held(WorkerId worker, const Held& held);
    void evicted(WorkerId worker, const Evicted& evicted);
    void failed(WorkerId worker, const FetchFailed& failed);
    void tree_removed(TreeId tree);

    /// By the master itself.
    struct Sent {
        std::uint64_t blocks = 0;
        std::uint64_t bytes = 0; ///< Compressed.
    };
    [[nodiscard]] Sent sent_to(WorkerId worker) const;
    /// What a worker that has a connection, and serves others, holds as it has said.
    [[nodiscard]] const std::set<BlockKey>& held_by(WorkerId worker) const {
        return director_.held_by(worker);
    }
    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const { director_.check_invariants(); }

  private:
    struct Link {
        std::shared_ptr<Channel> channel;
        PeerKey key;
        std::string host;
        std::uint16_t port = 0;
        std::uint64_t ticket_last = 0; ///< For fetches from it.
        std::deque<BlockKey> queue;    ///< What the master has yet to send.
        bool sending = false;
        Sent sent;
    };

    /// The tree is known.
    [[nodiscard]] Status check_roots(TreeId tree, const std::vector<RootIndex>& roots) const;
    void probe(WorkerId worker);
    [[nodiscard]] asio::awaitable<void>
    probe(WorkerId worker, Endpoint endpoint, std::weak_ptr<Channel> channel);
    void act(const BlockActions& actions);
    void send(const SendBlock& action);
    void direct(const SendToPeers& action);
    [[nodiscard]] asio::awaitable<void> send_queue(WorkerId worker);
    static void send_some(Link& link, TreeId tree, const CutGeometry& geometry);
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
