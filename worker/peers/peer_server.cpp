#include "worker/peers/peer_server.hpp"

#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/worker.hpp"
#include "common/core/version.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/greeting.hpp"

#include <utility>

namespace cd {

namespace {

bool is_worker(const std::optional<Identity>& identity) {
    return identity && identity->role == CertifiedRole::Worker;
}

} // namespace

Result<std::shared_ptr<PeerServer>> PeerServer::listen(const asio::any_io_executor& executor,
                                                       const Endpoint& endpoint,
                                                       std::shared_ptr<const TlsSlot> tls) {
    Result<std::unique_ptr<Listener>> listener = Listener::open(executor, endpoint);
    if (!listener) {
        return listener.error();
    }
    std::shared_ptr<PeerServer> server(
        new PeerServer(executor, std::move(listener.value()), std::move(tls)));
    server->listener_->start([weak = std::weak_ptr(server)](asio::ip::tcp::socket socket) {
        if (const auto self = weak.lock()) {
            self->accept(std::move(socket));
        }
    });
    return server;
}

PeerServer::PeerServer(asio::any_io_executor executor,
                       std::unique_ptr<Listener> listener,
                       std::shared_ptr<const TlsSlot> tls)
    : executor_(std::move(executor)), listener_(std::move(listener)), tls_(std::move(tls)) {}

void PeerServer::serve(const PeerKey& key, Blocks blocks) {
    tickets_.emplace(key);
    blocks_ = std::move(blocks);
}

void PeerServer::stop_serving() {
    tickets_.reset();
    blocks_ = nullptr;
}

void PeerServer::accept(asio::ip::tcp::socket socket) {
    Seats::Seat seat = greetings_.take(socket);
    if (seat == nullptr || greeted_.taken() >= limits::peer_connections_max) {
        return; // The socket closes, and the peer tries its next source.
    }
    spawn(executor_, "a peer", serve(shared_from_this(), std::move(socket), std::move(seat)));
}

asio::awaitable<void> PeerServer::serve(std::shared_ptr<PeerServer> self,
                                        asio::ip::tcp::socket socket,
                                        Seats::Seat seat) {
    const std::string peer = peer_name(socket);
    const Result<std::shared_ptr<Channel>> channel =
        co_await accept_channel(std::move(socket), tls_->now);
    if (!channel) {
        // The master probes the port by a connection without a byte.
        const auto level =
            channel.error().code == ErrorCode::Disconnected ? LogLevel::Debug : LogLevel::Warning;
        self->refusals_.log(level, "peer refused", peer, channel.error().detail);
    } else if (tls_->now != nullptr && !is_worker(channel.value()->peer_identity())) {
        self->refusals_.log(
            LogLevel::Warning, "peer refused", peer, "not the certificate of a worker");
    } else {
        co_await converse(channel.value(), seat);
    }
}

asio::awaitable<void> PeerServer::converse(std::shared_ptr<Channel> channel, Seats::Seat& seat) {
    const Result<Hello> hello = co_await accept_hello(channel);
    // If the address cannot be parsed, only the total number of connections is limited.
    boost::system::error_code ignored;
    const Seats::Seat slot = greeted_.take(asio::ip::make_address(channel->peer_host(), ignored));
    if (hello && hello.value().role == Role::Peer && slot != nullptr) {
        seat.reset();
        Welcome welcome;
        welcome.build = version;
        channel->send(welcome);
        co_await answer_all(channel);
    }
    channel->close();
}

asio::awaitable<void> PeerServer::answer_all(std::shared_ptr<Channel> channel) {
    for (;;) {
        Result<Message> message = co_await channel->receive(timing::peer_idle_max);
        const auto* fetch = message ? std::get_if<PeerFetch>(&message.value()) : nullptr;
        if (fetch == nullptr) {
            break;
        }
        co_await answer(channel, *fetch);
    }
}

asio::awaitable<void> PeerServer::answer(std::shared_ptr<Channel> channel, PeerFetch fetch) {
    if (!tickets_ || !tickets_->take(fetch)) {
        refusals_.log(LogLevel::Warning,
                      "peer refused",
                      channel->peer(),
                      "tree " + std::to_string(fetch.tree.value) + ", ticket " +
                          std::to_string(fetch.ticket));
        channel->send(PeerFetched{fetch.tree, std::move(fetch.roots), PeerOutcome::Refused});
    } else if (uploads_ >= limits::peer_uploads_max) {
        channel->send(PeerFetched{fetch.tree, std::move(fetch.roots), PeerOutcome::Busy});
    } else {
        ++uploads_;
        co_await upload(channel, std::move(fetch));
        --uploads_;
    }
}

asio::awaitable<void> PeerServer::upload(std::shared_ptr<Channel> channel, PeerFetch fetch) {
    PeerFetched end;
    end.tree = fetch.tree;
    Subtrees some;
    some.tree = fetch.tree;
    std::uint64_t bytes = 0;
    for (const RootIndex root : fetch.roots) {
        const auto block = blocks_ ? blocks_({fetch.tree, root}) : nullptr;
        if (block == nullptr) {
            end.missing.push_back(root);
            continue;
        }
        bytes += block->compressed.size();
        some.blocks.push_back(*block);
        if (bytes >= limits::subtrees_bytes_min) {
            channel->send(some);
            some.blocks.clear();
            uploaded_bytes_ += std::exchange(bytes, 0);
            co_await channel->wait_until_queued_below(limits::subtrees_bytes_min);
        }
    }
    if (!some.blocks.empty()) {
        channel->send(some);
        uploaded_bytes_ += bytes;
    }
    end.outcome = end.missing.empty() ? PeerOutcome::Given : PeerOutcome::Missing;
    channel->send(end);
    co_await channel->wait_until_queued_below(1);
}

} // namespace cd
