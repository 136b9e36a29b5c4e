// Gives this worker's blocks to other workers, as far as the master permits.
#pragma once

#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/access/peer_ticket.hpp"
#include "proto/access/refusals.hpp"
#include "proto/channel/listener.hpp"
#include "proto/channel/seats.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace cd {

/// Serves at most `limits::peer_uploads_max` fetches at a time and answers further ones with Busy.
/// All members run on the executor's thread.
class PeerServer : public std::enable_shared_from_this<PeerServer> {
  public:
    /// The block in a slot, or null.
    using Blocks = std::function<std::shared_ptr<const SubtreeBlock>(const SubtreeKey&)>;

    /// Listens at once. Errors: those of `Listener::open`.
    [[nodiscard]] static Result<std::shared_ptr<PeerServer>>
    listen(const asio::any_io_executor& executor,
           const Endpoint& endpoint,
           std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>());

    [[nodiscard]] std::uint16_t port() const { return listener_->port(); }

    /// Serves these blocks from now on, for tickets of this key, in place of earlier ones.
    void serve(const PeerKey& key, Blocks blocks);
    /// Serves no blocks any more.
    void stop_serving();

    /// The compressed bytes of all blocks given.
    [[nodiscard]] std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    PeerServer(asio::any_io_executor executor,
               std::unique_ptr<Listener> listener,
               std::shared_ptr<const TlsSlot> tls);

    void accept(asio::ip::tcp::socket socket);
    /// It begins some time after it was spawned, and the server may have ended by then.
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
    std::optional<TicketCheck> tickets_;
    Blocks blocks_;
    Seats greetings_{limits::peer_connections_max}; ///< Connections that have not greeted yet.
    Refusals refusals_;
    Seats places_{limits::peer_connections_max}; ///< Connections that have greeted.
    std::size_t uploads_ = 0;
    std::uint64_t uploaded_bytes_ = 0;
};

} // namespace cd
