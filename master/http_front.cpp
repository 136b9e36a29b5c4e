#include "master/http_front.hpp"

#include "common/core/limits_http.hpp"
#include "common/core/log.hpp"
#include "master/access.hpp"
#include "master/coordinator.hpp"
#include "master/identity.hpp"
#include "master/metrics.hpp"
#include "proto/http.hpp"
#include "proto/stream.hpp"

#include <utility>

namespace cd {

namespace {

HttpAnswer answer_to(const HttpRequest& request, Coordinator& coordinator, const Access& access) {
    if (request.method != "GET") {
        return {405, "only GET\n"};
    }
    if (request.target == "/healthz") {
        return {200, "ok\n"};
    }
    if (request.target == "/readyz") {
        const std::string& why = coordinator.paused();
        return why.empty() ? HttpAnswer{200, "ready\n"} : HttpAnswer{503, "paused: " + why + "\n"};
    }
    if (request.target == "/metrics") {
        const Status allowed = access.check(Message(StatusQuery{}));
        return allowed ? HttpAnswer{200,
                                    metrics_text(coordinator.cluster_status()),
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
    const auto open = static_cast<std::size_t>(connection_.use_count() - 1);
    if (open >= limits::http_connections_max) {
        spdlog::warn("http connection refused: reason=\"{} are open\"", open);
        return;
    }
    spawn(coordinator_.executor(), "http", serve(std::move(socket)));
}

asio::awaitable<void> HttpFront::serve(asio::ip::tcp::socket socket) {
    // Whatever holds it is a connection.
    const auto counted = connection_;
    auto stream = std::make_unique<Stream>(std::move(socket));
    Status secured = Done{};
    if (identity_ != nullptr) {
        std::shared_ptr<const Tls> tls = identity_->tls()->now;
        secured =
            co_await stream->secure(std::move(tls), TlsEnd::Accepting, limits::http_exchange_max);
    }
    if (!secured) {
        spdlog::info("http connection refused: reason=\"{}\"", secured.error().detail);
        co_return;
    }
    const Access access =
        identity_ == nullptr ? Access() : Access(*identity_, stream->peer_identity());
    serve_http(std::move(stream), [this, access, counted](const HttpRequest& request) {
        return answer_to(request, coordinator_, access);
    });
}

} // namespace cd
