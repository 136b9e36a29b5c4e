// Gives blocks that this worker holds to other workers, as far as the master lets them have them.
#pragma once

#include "proto/listener.hpp"
#include "proto/peer_ticket.hpp"
#include "proto/refusals.hpp"
#include "proto/seats.hpp"
#include "worker/subtree_cache.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace cd {

/// Serves at most `limits::peer_uploads_max` fetches at a time; to others it says that it is busy.
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

    /// From now on these blocks, for tickets of this key; instead of those before.
    void serve(const PeerKey& key, Blocks blocks);
    /// No blocks any more.
    void stop_serving();

    /// Compressed, of all blocks given.
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
    Seats greetings_{limits::peer_connections_max}; ///< Of those that have not greeted yet.
    Refusals refusals_;
    Seats places_{limits::peer_connections_max}; ///< Of those that have.
    std::size_t uploads_ = 0;
    std::uint64_t uploaded_bytes_ = 0;
};

} // namespace cd
