// The greeting on both sides of a new channel, and the start of coroutines.
#include "common/core/host/log.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/channel.hpp"

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
                       error.detail + ", before it answered: it may have no place for another "
                                      "connection; try again"};
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
    channel->set_peer_boot_id(welcome->boot_id);
    co_return *welcome;
}

Status check_version(const Hello& hello) {
    if (hello.version == protocol_version) {
        return Done{};
    }
    const std::string peer = hello.role == Role::Client ? "client" : "worker";
    const std::string here = hello.role == Role::Peer ? "worker" : "master";
    const std::string to_upgrade =
        hello.version < protocol_version ? peer + " " + hello.name : "this " + here;
    return Error{ErrorCode::Refused,
                 peer + " " + hello.name + " speaks version " + std::to_string(hello.version) +
                     " of the protocol, this " + here + " version " +
                     std::to_string(protocol_version) + ": upgrade " + to_upgrade};
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
            channel->set_peer_boot_id(hello->boot_id);
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

void spawn(asio::any_io_executor executor, std::string name, asio::awaitable<void> coroutine) {
    asio::co_spawn(
        executor, std::move(coroutine), [name = std::move(name)](const std::exception_ptr& thrown) {
            if (!thrown) {
                return;
            }
            try {
                std::rethrow_exception(thrown);
            } catch (const std::exception& error) {
                log_error("coroutine failed: name={} error={}", name, error.what());
            }
        });
}

} // namespace cd
