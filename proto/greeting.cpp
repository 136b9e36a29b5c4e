// The greeting on both sides of a new channel, and how conversations are started.
#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "proto/channel.hpp"

#include <algorithm>
#include <bit>

namespace cd {
namespace {

Error unexpected(const std::string& what) {
    return {ErrorCode::BadFrame, "the peer did not answer with a " + what};
}

std::string versions(std::uint16_t min, std::uint16_t max) {
    return std::to_string(min) + " to " + std::to_string(max);
}

/// The greatest way that both can go.
Result<std::uint32_t> common_way(std::uint32_t ours, std::uint32_t theirs, const char* of_what) {
    if ((ours & theirs) == 0) {
        return Error{ErrorCode::Refused,
                     std::string("no common ") + of_what + ": the peer has " +
                         std::to_string(theirs) + ", this side " + std::to_string(ours)};
    }
    return std::bit_floor(ours & theirs);
}

bool is_one_of(std::uint32_t way, std::uint32_t ways) {
    return std::has_single_bit(way) && (way & ways) != 0;
}

/// It answers this hello.
bool is_agreement(const Welcome& welcome, const Hello& hello) {
    const Choices& chosen = welcome.choices;
    return welcome.version >= hello.version_min && welcome.version <= hello.version_max &&
           (chosen.features & ~hello.choices.features) == 0 &&
           is_one_of(chosen.digests, hello.choices.digests) &&
           is_one_of(chosen.compressors, hello.choices.compressors);
}

/// Who has no place for another connection closes it unanswered.
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
    if (welcome == nullptr || !is_agreement(*welcome, hello)) {
        channel->close();
        co_return unexpected("welcome in a version, and with choices, that this side has");
    }
    channel->expect(hello.role == Role::Peer ? Party::Giver : Party::Master);
    co_return *welcome;
}

Result<Agreement> negotiate(const Hello& hello) {
    const std::uint16_t lowest = std::max(hello.version_min, protocol_version_min);
    const std::uint16_t highest = std::min(hello.version_max, protocol_version_max);
    if (lowest > highest) {
        return Error{ErrorCode::Refused,
                     "no common protocol version: the peer speaks " +
                         versions(hello.version_min, hello.version_max) + ", this side " +
                         versions(protocol_version_min, protocol_version_max)};
    }
    const Choices ours;
    const Choices& theirs = hello.choices;
    const auto digest = common_way(ours.digests, theirs.digests, "digest");
    const auto compressor = common_way(ours.compressors, theirs.compressors, "compressor");
    if (!digest || !compressor) {
        return digest ? compressor.error() : digest.error();
    }
    return Agreement{highest,
                     {ours.features & theirs.features, digest.value(), compressor.value()}};
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
        const Result<Agreement> agreement = negotiate(*hello);
        if (agreement) {
            channel->expect(party_of(hello->role));
            co_return std::move(*hello);
        }
        problem = agreement.error();
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
