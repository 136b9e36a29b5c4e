#include "proto/access/join.hpp"

#include "common/core/limits/wire.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/wire.hpp"
#include "common/core/version.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/greeting.hpp"

#include <utility>

namespace cd {

namespace {

/// Connects and greets as a Joiner.
asio::awaitable<Result<std::shared_ptr<Channel>>> open(Target target, std::string name) {
    Result<std::shared_ptr<Channel>> channel = co_await connect(std::move(target));
    if (!channel) {
        co_return channel.error();
    }
    Hello hello;
    hello.role = Role::Joiner;
    hello.name = std::move(name);
    hello.build = version;
    const Result<Welcome> welcome = co_await greet(channel.value(), hello);
    if (!welcome) {
        co_return welcome.error();
    }
    co_return channel;
}

asio::awaitable<Result<Credential>>
ask(std::shared_ptr<Channel> channel, Message question, CertificateRequest request) {
    channel->send(question);
    Result<Message> answer = co_await channel->receive(timing::connect_timeout);
    channel->close();
    if (!answer) {
        co_return answer.error();
    }
    if (auto* failure = std::get_if<Failure>(&answer.value())) {
        co_return Error{failure->code, std::move(failure->detail)};
    }
    auto* const certified = std::get_if<Certified>(&answer.value());
    if (certified == nullptr) {
        co_return Error{ErrorCode::BadFrame, "the master did not answer with a certificate"};
    }
    Credential credential{
        std::move(request.key), std::move(certified->certificate), std::move(certified->authority)};
    const auto usable = Tls::make(credential);
    if (!usable) {
        co_return Error{ErrorCode::BadFrame, "the master sent " + usable.error().detail};
    }
    co_return credential;
}

} // namespace

asio::awaitable<Result<Credential>>
join_cluster(Endpoint master, JoinToken token, std::string name) {
    if (!is_good_name(name)) {
        co_return Error{
            ErrorCode::BadInput,
            "the name '" + escaped(name) + "' is not 1 to " +
                std::to_string(limits::certified_name_bytes_max) +
                " printable bytes without a blank at either end: choose another --name"};
    }
    Target target{std::move(master), Tls::make_joining(token.authority)};
    const auto channel = co_await open(std::move(target), name);
    if (!channel) {
        co_return channel.error();
    }
    CertificateRequest request = make_certificate_request();
    Join join;
    join.token = token.id;
    join.proof = join_proof(token, channel.value()->binding().value(), request.request);
    join.name = std::move(name);
    join.request = request.request;
    Message question(std::move(join));
    auto credential = co_await ask(channel.value(), std::move(question), std::move(request));
    if (!credential) {
        co_return credential;
    }
    const auto authority = certificate_fingerprint(credential.value().authority);
    if (!authority || authority.value() != token.authority) {
        co_return Error{ErrorCode::Refused, "the master sent another authority than the token's"};
    }
    co_return credential;
}

asio::awaitable<Result<Credential>> renew_credential(Endpoint master,
                                                     std::shared_ptr<const Tls> tls) {
    Target target{std::move(master), tls};
    std::string name = tls->identity()->name;
    const auto channel = co_await open(std::move(target), std::move(name));
    if (!channel) {
        co_return channel.error();
    }
    CertificateRequest request = make_certificate_request();
    Message question(Renew{request.request});
    co_return co_await ask(channel.value(), std::move(question), std::move(request));
}

} // namespace cd
