#include "master/identity/admission.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/wire.hpp"
#include "master/identity/identity.hpp"

namespace cd {

namespace {

Result<Certified> decide(const Access& access, const Channel& channel, const Message& question) {
    if (const auto* join = std::get_if<Join>(&question)) {
        return access.identity()->join(*join, channel.binding().value());
    }
    const auto* const renew = std::get_if<Renew>(&question);
    if (renew == nullptr || !access.holder()) {
        return Error{ErrorCode::Refused, "neither a token nor a certificate was shown"};
    }
    return access.identity()->renew(*renew, *access.holder());
}

} // namespace

asio::awaitable<void> admit(std::shared_ptr<Channel> channel, Access access) {
    const Result<Message> question = co_await channel->receive(timing::connect_timeout);
    if (!question) {
        co_return;
    }
    const Result<Certified> answer = decide(access, *channel, question.value());
    if (answer) {
        const Result<Identity> identity = read_identity(answer.value().certificate);
        log_info("certificate given: peer={} role={} name=\"{}\"",
                 channel->peer(),
                 to_text(identity.value().role),
                 identity.value().name);
        channel->send(answer.value());
    } else {
        log_warning(
            "certificate refused: peer={} reason=\"{}\"", channel->peer(), answer.error().detail);
        Failure failure;
        failure.code = ErrorCode::Refused;
        failure.detail = answer.error().detail;
        channel->send(failure);
    }
    channel->close(true);
}

} // namespace cd
