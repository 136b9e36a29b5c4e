#include "master/net/http_front.hpp"

#include "common/core/timing/wire.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/identity/access.hpp"
#include "master/identity/identity.hpp"
#include "master/net/metrics.hpp"
#include "proto/channel/stream.hpp"

#include <utility>

namespace cd {

namespace {

/// Returns the reason why the master or one of its jobs is paused; empty if none is.
std::string what_waits(Coordinator& coordinator) {
    if (!coordinator.jobs().paused().empty()) {
        return "paused: " + coordinator.jobs().paused();
    }
    for (const JobStatus& job : coordinator.jobs().cluster().jobs) {
        if (!job.paused.empty()) {
            return "job " + std::to_string(job.job.value) + " is paused: " + job.paused;
        }
    }
    return "";
}

HttpAnswer answer_to(const HttpRequest& request, Coordinator& coordinator, const Access& access) {
    if (request.method != "GET" && request.method != "HEAD") {
        return {405, "only GET and HEAD\n"};
    }
    if (request.target == "/healthz") {
        return {200, "ok\n"};
    }
    if (request.target == "/readyz") {
        const std::string why = what_waits(coordinator);
        return why.empty() ? HttpAnswer{200, "ready\n"} : HttpAnswer{503, why + "\n"};
    }
    if (request.target == "/metrics") {
        const Status allowed = access.check(Message(StatusQuery{}));
        return allowed ? HttpAnswer{200,
                                    metrics_text(coordinator.jobs().cluster()),
                                    std::string(metrics_content_type)}
                       : HttpAnswer{403, allowed.error().detail + "\n"};
    }
    return {404, "there are /healthz, /readyz and /metrics\n"};
}

} // namespace

Result<std::unique_ptr<HttpFront>> HttpFront::listen(const asio::any_io_executor& executor,
                                                     const Endpoint& endpoint,
                                                     Coordinator& coordinator,
                                                     MasterIdentity* identity) {
    Result<std::unique_ptr<Listener>> listener = Listener::open(executor, endpoint);
    if (!listener) {
        return listener.error();
    }
    return std::unique_ptr<HttpFront>(
        new HttpFront(std::move(listener.value()), coordinator, identity));
}

HttpFront::HttpFront(std::unique_ptr<Listener> listener,
                     Coordinator& coordinator,
                     MasterIdentity* identity)
    : listener_(std::move(listener)), coordinator_(coordinator), identity_(identity) {}

void HttpFront::start() {
    listener_->start([this](asio::ip::tcp::socket socket) { accept(std::move(socket)); });
}

void HttpFront::close() {
    listener_->close();
}

void HttpFront::accept(asio::ip::tcp::socket socket) {
    Seats::Seat seat = seats_.take(socket);
    if (seat == nullptr) {
        refusals_.log(LogLevel::Warning,
                      "http connection refused",
                      peer_name(socket),
                      std::to_string(seats_.taken()) + " are open");
        return;
    }
    spawn(coordinator_.parts().executor, "http", serve(std::move(socket), std::move(seat)));
}

asio::awaitable<void> HttpFront::serve(asio::ip::tcp::socket socket, Seats::Seat seat) {
    const std::string peer = peer_name(socket);
    auto stream = std::make_unique<Stream>(std::move(socket));
    Status secured = Done{};
    if (identity_ != nullptr) {
        std::shared_ptr<const Tls> tls = identity_->tls()->now;
        secured =
            co_await stream->secure(std::move(tls), TlsEnd::Accepting, timing::http_exchange_max);
    }
    if (!secured) {
        refusals_.log(LogLevel::Warning, "http connection refused", peer, secured.error().detail);
        co_return;
    }
    const Access access =
        identity_ == nullptr ? Access() : Access(*identity_, stream->peer_identity());
    // The handler keeps the connection slot until the stream is destroyed.
    serve_http(std::move(stream),
               [this, access, peer, seat](const HttpRequest& request, const HttpRespond& respond) {
                   respond(answer(request, access, peer));
               });
}

HttpAnswer
HttpFront::answer(const HttpRequest& request, const Access& access, const std::string& peer) {
    HttpAnswer answer = answer_to(request, coordinator_, access);
    if (answer.status == 403) {
        const std::string reason = answer.body.substr(0, answer.body.find('\n'));
        refusals_.log(LogLevel::Warning, "http request refused", peer, reason);
    }
    return answer;
}

} // namespace cd
