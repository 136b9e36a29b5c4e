#include "proto/channel/greeting.hpp"

#include <string>
#include <variant>

namespace cd {
namespace {

Error unexpected(const std::string& what) {
    return {ErrorCode::BadFrame, "the peer did not answer with a " + what};
}

/// Adds a likely reason to a lost connection: a peer without a free slot closes without an answer.
Error unanswered(const Error& error) {
    return error.code != ErrorCode::Disconnected
               ? error
               : Error{error.code,
                       error.detail + ", before it answered: all its connection slots may be "
                                      "taken; try again"};
}

} // namespace

asio::awaitable<Result<Welcome>>
greet(std::shared_ptr<Channel> channel, Hello hello, std::chrono::steady_clock::duration timeout) {
    channel->send(hello);
    const Result<Message> answer = co_await channel->receive(timeout);
    if (!answer) {
        channel->close();
        co_return unanswered(answer.error());
    }
    if (const auto* failure = std::get_if<Failure>(&answer.value())) {
        channel->close();
        co_return Error{ErrorCode::Refused, failure->detail};
    }
    const auto* welcome = std::get_if<Welcome>(&answer.value());
    if (welcome == nullptr || welcome->version != hello.version) {
        channel->close();
        co_return unexpected("welcome in the version of this side");
    }
    channel->expect(hello.role == Role::Peer ? Party::Giver : Party::Master);
    co_return *welcome;
}

Status check_version(const Hello& hello) {
    if (hello.version == protocol_version) {
        return Done{};
    }
    return Error{ErrorCode::Refused,
                 "the peer speaks version " + std::to_string(hello.version) +
                     " of the protocol, this side version " + std::to_string(protocol_version) +
                     ": install the same release on both hosts"};
}

asio::awaitable<Result<Hello>> accept_hello(std::shared_ptr<Channel> channel) {
    Result<Message> first = co_await channel->receive(timing::connect_timeout);
    if (!first) {
        channel->close();
        co_return first.error();
    }
    auto* hello = std::get_if<Hello>(&first.value());
    Error problem = unexpected("hello");
    if (hello != nullptr) {
        const Status spoken = check_version(*hello);
        if (spoken) {
            channel->expect(party_of(hello->role));
            co_return std::move(*hello);
        }
        problem = spoken.error();
    }
    Failure failure;
    failure.code = problem.code;
    failure.detail = problem.detail;
    channel->send(failure);
    channel->close(true);
    co_return problem;
}

} // namespace cd
