#include "master/server.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/version.hpp"
#include "master/client_session.hpp"
#include "master/worker_session.hpp"

namespace cd {

namespace {

using boost::system::error_code;

Result<asio::ip::tcp::endpoint> resolve(const asio::any_io_executor& executor,
                                        const Endpoint& endpoint) {
    error_code error;
    const auto address = asio::ip::make_address(endpoint.host, error);
    if (!error) {
        return asio::ip::tcp::endpoint(address, endpoint.port);
    }
    asio::ip::tcp::resolver resolver(executor);
    const auto found = resolver.resolve(endpoint.host, std::to_string(endpoint.port), error);
    if (error || found.empty()) {
        return Error{ErrorCode::BadInput,
                     "cannot listen on " + endpoint.host + ": no such address"};
    }
    return found.begin()->endpoint();
}

} // namespace

Result<std::unique_ptr<Server>> Server::listen(const asio::any_io_executor& executor,
                                               const Endpoint& endpoint,
                                               Coordinator& coordinator) {
    const auto address = resolve(executor, endpoint);
    if (!address) {
        return address.error();
    }
    asio::ip::tcp::acceptor acceptor(executor);
    error_code error;
    acceptor.open(address.value().protocol(), error);
    if (!error) {
        acceptor.set_option(asio::socket_base::reuse_address(true), error);
    }
    if (!error) {
        acceptor.bind(address.value(), error);
    }
    if (!error) {
        acceptor.listen(asio::socket_base::max_listen_connections, error);
    }
    if (error) {
        return Error{ErrorCode::Io,
                     "cannot listen on " + endpoint.host + ":" + std::to_string(endpoint.port) +
                         ": " + error.message()};
    }
    return std::unique_ptr<Server>(new Server(std::move(acceptor), coordinator));
}

Server::Server(asio::ip::tcp::acceptor acceptor, Coordinator& coordinator)
    : acceptor_(std::move(acceptor)), pause_(acceptor_.get_executor()), coordinator_(coordinator) {}

std::uint16_t Server::port() const {
    error_code ignored;
    return acceptor_.local_endpoint(ignored).port();
}

void Server::start() {
    spawn(acceptor_.get_executor(), "accept", accept_all());
}

void Server::close() {
    error_code ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    for (const auto& [connection, channel] : connections_) {
        channel->close();
    }
}

asio::awaitable<void> Server::accept_all() {
    while (acceptor_.is_open()) {
        error_code error;
        auto socket =
            co_await acceptor_.async_accept(asio::redirect_error(asio::use_awaitable, error));
        if (!acceptor_.is_open()) {
            co_return;
        }
        if (error) {
            // Out of file descriptors, most likely: some will be free again.
            spdlog::warn("cannot accept: error=\"{}\"", error.message());
            pause_.expires_after(limits::accept_retry_period);
            co_await pause_.async_wait(asio::redirect_error(asio::use_awaitable, error));
            continue;
        }
        if (connections_.size() >= limits::connections_max) {
            spdlog::warn("connection refused: reason=\"{} are open\"", connections_.size());
            continue;
        }
        const std::uint64_t connection = ++connection_last_;
        auto channel = Channel::make(std::move(socket));
        connections_.emplace(connection, channel);
        spawn(acceptor_.get_executor(), "session", serve(connection, std::move(channel)));
    }
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
    welcome.version = negotiate(hello.value()).value();
    welcome.build = version;
    if (hello.value().role == Role::Worker) {
        const WorkerId worker = coordinator_.new_worker_id();
        welcome.id = worker.value;
        channel->send(welcome);
        co_await std::make_shared<WorkerSession>(coordinator_, channel, worker)->run(hello.value());
    } else {
        welcome.id = connection_last_;
        channel->send(welcome);
        co_await std::make_shared<ClientSession>(coordinator_, channel)->run();
    }
}

} // namespace cd
