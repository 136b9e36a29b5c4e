#include "proto/channel/listener.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/wire.hpp"

#include <utility>

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

struct Listener::State {
    explicit State(asio::ip::tcp::acceptor open)
        : acceptor(std::move(open)), pause(acceptor.get_executor()) {}

    asio::ip::tcp::acceptor acceptor;
    asio::steady_timer pause;
    OnSocket on_socket;
};

Result<std::unique_ptr<Listener>> Listener::open(const asio::any_io_executor& executor,
                                                 const Endpoint& endpoint) {
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
    return std::unique_ptr<Listener>(new Listener(std::make_shared<State>(std::move(acceptor))));
}

Listener::Listener(std::shared_ptr<State> state) : state_(std::move(state)) {}

Listener::~Listener() {
    close();
}

std::uint16_t Listener::port() const {
    error_code ignored;
    return state_->acceptor.local_endpoint(ignored).port();
}

void Listener::start(OnSocket on_socket) {
    state_->on_socket = std::move(on_socket);
    spawn(state_->acceptor.get_executor(), "accept", accept_all(state_));
}

void Listener::close() {
    error_code ignored;
    state_->acceptor.close(ignored);
    state_->pause.cancel();
}

asio::awaitable<void> Listener::accept_all(std::shared_ptr<State> state) {
    while (state->acceptor.is_open()) {
        error_code error;
        auto socket =
            co_await state->acceptor.async_accept(asio::redirect_error(asio::use_awaitable, error));
        if (!state->acceptor.is_open()) {
            co_return;
        }
        if (error) {
            // The process is probably out of file descriptors; retries when some may be free.
            log_warning("cannot accept: error=\"{}\"", error.message());
            state->pause.expires_after(timing::accept_retry_period);
            co_await state->pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
            continue;
        }
        state->on_socket(std::move(socket));
    }
}

} // namespace cd
