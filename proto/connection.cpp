// How connections begin: connecting, and the greeting on both sides.
#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "proto/channel.hpp"

#include <algorithm>

namespace cd {
namespace {

using boost::system::error_code;

/// While alive, cancels the pending operations of a socket or resolver once the time is up. Both
/// and their coroutine share one thread.
template <class Cancellable>
class Deadline {
  public:
    Deadline(Cancellable& target, std::chrono::steady_clock::duration timeout)
        : state_(std::make_shared<State>()), timer_(target.get_executor(), timeout) {
        state_->target = &target;
        timer_.async_wait([state = state_](const error_code&) {
            // An expiry already queued is delivered even after the timer is gone.
            if (state->target != nullptr) {
                state->expired = true;
                state->target->cancel();
            }
        });
    }

    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;
    ~Deadline() { state_->target = nullptr; }

    [[nodiscard]] bool expired() const { return state_->expired; }

  private:
    struct State {
        Cancellable* target = nullptr;
        bool expired = false;
    };

    std::shared_ptr<State> state_;
    asio::steady_timer timer_;
};

using Addresses = std::vector<asio::ip::tcp::endpoint>;

asio::awaitable<Addresses> resolve(const Endpoint& endpoint, error_code& error) {
    const auto literal = asio::ip::make_address(endpoint.host, error);
    Addresses addresses;
    if (!error) {
        addresses.emplace_back(literal, endpoint.port);
        co_return addresses;
    }
    asio::ip::tcp::resolver resolver(co_await asio::this_coro::executor);
    const Deadline deadline(resolver, limits::connect_timeout);
    // GCC 12 may destroy a temporary twice that stands beside a co_await: it gets a name.
    const std::string port = std::to_string(endpoint.port);
    const auto found = co_await resolver.async_resolve(
        endpoint.host, port, asio::redirect_error(asio::use_awaitable, error));
    for (const auto& entry : found) {
        addresses.push_back(entry.endpoint());
    }
    co_return addresses;
}

Error unreachable(const Endpoint& endpoint, const std::string& why) {
    return {ErrorCode::Disconnected,
            "cannot connect to " + endpoint.host + ":" + std::to_string(endpoint.port) + ": " +
                why};
}

Error unexpected(const std::string& what) {
    return {ErrorCode::BadFrame, "the peer did not answer with a " + what};
}

std::string versions(std::uint16_t min, std::uint16_t max) {
    return std::to_string(min) + " to " + std::to_string(max);
}

} // namespace

asio::awaitable<Result<std::shared_ptr<Channel>>> connect(Endpoint endpoint,
                                                          std::chrono::seconds timeout) {
    error_code error;
    const Addresses addresses = co_await resolve(endpoint, error);
    std::string why = error ? error.message() : "no such host";
    for (const auto& address : addresses) {
        asio::ip::tcp::socket socket(co_await asio::this_coro::executor);
        const Deadline deadline(socket, timeout);
        co_await socket.async_connect(address, asio::redirect_error(asio::use_awaitable, error));
        if (!error) {
            co_return Channel::make(std::move(socket));
        }
        why = deadline.expired() ? "no answer in time" : error.message();
    }
    co_return unreachable(endpoint, why);
}

asio::awaitable<Result<Welcome>> greet(std::shared_ptr<Channel> channel, Hello hello) {
    channel->send(hello);
    const Result<Message> answer = co_await channel->receive(limits::connect_timeout);
    if (!answer) {
        channel->close();
        co_return answer.error();
    }
    if (const auto* failure = std::get_if<Failure>(&answer.value())) {
        channel->close();
        co_return Error{ErrorCode::Refused, failure->detail};
    }
    const auto* welcome = std::get_if<Welcome>(&answer.value());
    if (welcome == nullptr || welcome->version < hello.version_min ||
        welcome->version > hello.version_max) {
        channel->close();
        co_return unexpected("welcome in a version that this side speaks");
    }
    co_return *welcome;
}

Result<std::uint16_t> negotiate(const Hello& hello) {
    const std::uint16_t lowest = std::max(hello.version_min, protocol_version_min);
    const std::uint16_t highest = std::min(hello.version_max, protocol_version_max);
    if (lowest > highest) {
        return Error{ErrorCode::Refused,
                     "no common protocol version: the peer speaks " +
                         versions(hello.version_min, hello.version_max) + ", this side " +
                         versions(protocol_version_min, protocol_version_max)};
    }
    return highest;
}

asio::awaitable<Result<Hello>> accept_hello(std::shared_ptr<Channel> channel) {
    Result<Message> first = co_await channel->receive(limits::connect_timeout);
    if (!first) {
        channel->close();
        co_return first.error();
    }
    auto* hello = std::get_if<Hello>(&first.value());
    Error problem = unexpected("hello");
    if (hello != nullptr) {
        const Result<std::uint16_t> version = negotiate(*hello);
        if (version) {
            co_return std::move(*hello);
        }
        problem = version.error();
    }
    Failure failure;
    failure.code = problem.code;
    failure.detail = problem.detail;
    channel->send(failure);
    channel->close(true);
    co_return problem;
}

void spawn(asio::any_io_executor executor, std::string name, asio::awaitable<void> coroutine) {
    asio::co_spawn(
        executor, std::move(coroutine), [name = std::move(name)](const std::exception_ptr& thrown) {
            if (!thrown) {
                return;
            }
            try {
                std::rethrow_exception(thrown);
            } catch (const std::exception& error) {
                spdlog::error("coroutine failed: name={} error={}", name, error.what());
            }
        });
}

} // namespace cd
