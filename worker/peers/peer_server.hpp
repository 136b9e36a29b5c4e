// Serves this worker's blocks to other workers that have a ticket of the master.
#pragma once

#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/access/peer_ticket.hpp"
#include "proto/access/refusals.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/channel/listener.hpp"
#include "proto/access/seats.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace cd {

/// Serves at most `limits::peer_uploads_max` fetches at a time; answers further fetches with Busy.
/// All members run on the executor's thread.
class PeerServer : public std::enable_shared_from_this<PeerServer> {
  public:
    /// Returns a cached block, or null if this worker does not have it.
    using Blocks = std::function<std::shared_ptr<const SubtreeBlock>(const SubtreeKey&)>;

    /// Opens the port and listens. Errors: those of `Listener::open`.
    [[nodiscard]] static Result<std::shared_ptr<PeerServer>>
    listen(const asio::any_io_executor& executor,
           const Endpoint& endpoint,
           std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>());

    [[nodiscard]] std::uint16_t port() const { return listener_->port(); }

    /// Serves `blocks` to holders of tickets for `key`. Replaces an earlier key and its blocks.
    void serve(const PeerKey& key, Blocks blocks);
    /// Refuses all tickets until the next `serve`.
    void stop_serving();

    /// Compressed bytes of all blocks served since `listen`.
    [[nodiscard]] std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    PeerServer(asio::any_io_executor executor,
               std::unique_ptr<Listener> listener,
               std::shared_ptr<const TlsSlot> tls);

    void accept(asio::ip::tcp::socket socket);
    /// Holds `self`, because the coroutine may run after the server's owner is gone.
    [[nodiscard]] asio::awaitable<void>
    serve(std::shared_ptr<PeerServer> self, asio::ip::tcp::socket socket, Seats::Seat seat);
    [[nodiscard]] asio::awaitable<void> converse(std::shared_ptr<Channel> channel,
                                                 Seats::Seat& seat);
    [[nodiscard]] asio::awaitable<void> answer_all(std::shared_ptr<Channel> channel);
    [[nodiscard]] asio::awaitable<void> answer(std::shared_ptr<Channel> channel, PeerFetch fetch);
    [[nodiscard]] asio::awaitable<void> upload(std::shared_ptr<Channel> channel, PeerFetch fetch);

    asio::any_io_executor executor_;
    std::unique_ptr<Listener> listener_;
    std::shared_ptr<const TlsSlot> tls_;
    std::optional<TicketCheck> tickets_; ///< Checks tickets; empty: refuses all.
    Blocks blocks_;
    Seats greetings_{limits::peer_connections_max}; ///< Connections before their greeting.
    Refusals refusals_;
    Seats greeted_{limits::peer_connections_max}; ///< Connections after their greeting.
    std::size_t uploads_ = 0;                     ///< Fetches that are being served.
    std::uint64_t uploaded_bytes_ = 0;
};

} // namespace cd
