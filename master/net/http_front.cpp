#include "master/net/http_front.hpp"

#include "common/core/timing/wire.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/identity/access.hpp"
#include "master/identity/identity.hpp"
#include "proto/channel/stream.hpp"

#include <chrono>
#include <utility>

namespace cd {

namespace {

HttpAnswer readiness(const Coordinator& coordinator) {
    const std::string why = reason_of_pause(coordinator);
    return why.empty() ? HttpAnswer{200, "ready\n"} : HttpAnswer{503, why + "\n"};
}

} // namespace

Result<std::unique_ptr<HttpFront>> HttpFront::listen(const asio::any_io_executor& executor,
                                                     const Endpoint& endpoint,
                                                     Coordinator& coordinator,
                                                     MasterIdentity* identity,
                                                     std::vector<std::string> host_names) {
    Result<std::unique_ptr<Listener>> listener = Listener::open(executor, endpoint);
    if (!listener) {
        return listener.error();
    }
    return std::unique_ptr<HttpFront>(new HttpFront(std::move(listener.value()),
                                                    coordinator,
                                                    identity,
                                                    std::move(host_names),
                                                    is_loopback(endpoint)));
}

HttpFront::HttpFront(std::unique_ptr<Listener> listener,
                     Coordinator& coordinator,
                     MasterIdentity* identity,
                     std::vector<std::string> host_names,
                     bool is_loopback)
    : listener_(std::move(listener)),
      coordinator_(coordinator),
      identity_(identity),
      page_(coordinator, std::move(host_names), identity != nullptr),
      is_loopback_(is_loopback) {}

void HttpFront::start() {
    page_.start();
    listener_->start([this](asio::ip::tcp::socket socket) { accept(std::move(socket)); });
}

void HttpFront::close() {
    page_.close();
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
               [this, access, peer, seat](const HttpRequest& request, HttpRespond respond) {
                   answer(request, access, [this, peer, respond](HttpAnswer answer) {
                       if (answer.status == 403) {
                           const std::string reason = answer.body.substr(0, answer.body.find('\n'));
                           refusals_.log(LogLevel::Warning, "http request refused", peer, reason);
                       }
                       ++answers_[answer.status];
                       respond(std::move(answer));
                   });
               });
}

MasterFigures HttpFront::figures() {
    MasterFigures figures;
    figures.written = coordinator_.jobs().written();
    figures.commits = coordinator_.parts().journal.commit_times();
    figures.disk_bytes = page_.reader().disk();
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    figures.now = std::chrono::duration<double>(now).count();
    figures.process = process_figures();
    figures.http_answers = answers_;
    if (identity_ != nullptr) {
        const auto until = identity_->tls()->now->identity()->until.time_since_epoch();
        figures.certificate_until = std::chrono::duration<double>(until).count();
    }
    for (const auto& [id, worker] : coordinator_.workers().all()) {
        figures.workers.push_back({id,
                                   worker.author->name,
                                   worker.author->build,
                                   coordinator_.worker_desk().peer_port_of(id)});
    }
    return figures;
}

HttpAnswer HttpFront::metrics(const HttpRequest& request, const Access& access) {
    if (is_loopback_ && !page_.is_own_host(request.host)) {
        return {421, "this server is not '" + request.host + "'\n"};
    }
    if (const Status allowed = access.check(Message(StatusQuery{})); !allowed) {
        return {403, allowed.error().detail + "\n"};
    }
    ClusterStatus status;
    page_.reader().status([&](Result<ClusterStatus> now) { status = std::move(now.value()); });
    return {200, metrics_text(status, figures()), std::string(metrics_content_type)};
}

void HttpFront::answer(const HttpRequest& request, const Access& access, HttpRespond respond) {
    const bool reads = request.method == "GET" || request.method == "HEAD";
    if (reads && request.target == "/healthz") {
        return respond({200, "ok\n"});
    }
    if (reads && request.target == "/readyz") {
        return respond(readiness(coordinator_));
    }
    if (reads && request.target == "/metrics") {
        return respond(metrics(request, access));
    }
    page_.answer(request, access, std::move(respond));
}

} // namespace cd
