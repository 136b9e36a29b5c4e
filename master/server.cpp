#include "master/server.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/version.hpp"
#include "master/client_session.hpp"
#include "master/worker_session.hpp"

namespace cd {

Result<std::unique_ptr<Server>> Server::listen(const asio::any_io_executor& executor,
                                               const Endpoint& endpoint,
                                               Coordinator& coordinator) {
    Result<std::unique_ptr<Listener>> listener = Listener::open(executor, endpoint);
    if (!listener) {
        return listener.error();
    }
    return std::unique_ptr<Server>(new Server(std::move(listener.value()), coordinator));
}

Server::Server(std::unique_ptr<Listener> listener, Coordinator& coordinator)
    : listener_(std::move(listener)), coordinator_(coordinator) {}

void Server::start() {
    listener_->start([this](asio::ip::tcp::socket socket) { accept(std::move(socket)); });
}

void Server::close() {
    listener_->close();
    for (const auto& [connection, channel] : connections_) {
        channel->close();
    }
}

void Server::accept(asio::ip::tcp::socket socket) {
    if (connections_.size() >= limits::connections_max) {
        spdlog::warn("connection refused: reason=\"{} are open\"", connections_.size());
        return;
    }
    const std::uint64_t connection = ++connection_last_;
    auto channel = Channel::make(std::move(socket));
    connections_.emplace(connection, channel);
    spawn(coordinator_.executor(), "session", serve(connection, std::move(channel)));
}

asio::awaitable<void> Server::serve(std::uint64_t connection, std::shared_ptr<Channel> channel) {
    co_await converse(std::move(channel));
    connections_.erase(connection);
}

asio::awaitable<void> Server::converse(std::shared_ptr<Channel> channel) {
    const Result<Hello> hello = co_await accept_hello(channel);
    if (!hello) {
        spdlog::info(
            "greeting failed: peer={} error=\"{}\"", channel->peer(), hello.error().detail);
        co_return;
    }
    Welcome welcome;
    welcome.cluster = coordinator_.cluster();
    welcome.version = negotiate(hello.value()).value();
    welcome.build = version;
    if (hello.value().role == Role::Peer) {
        Failure failure;
        failure.detail = "this is a master; workers fetch from each other";
        channel->send(failure);
        channel->close(true);
    } else if (hello.value().role == Role::Worker) {
        const WorkerId worker = coordinator_.new_worker_id();
        welcome.id = worker.value;
        welcome.peer_key = random_secret();
        channel->send(welcome);
        const auto session = std::make_shared<WorkerSession>(coordinator_, channel, worker);
        co_await session->run(hello.value(), welcome.peer_key);
    } else {
        welcome.id = connection_last_;
        channel->send(welcome);
        co_await std::make_shared<ClientSession>(coordinator_, channel)->run();
    }
}

} // namespace cd
