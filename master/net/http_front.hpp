// Serves HTTP: /healthz, /readyz, /metrics, and the page.
#pragma once

#include "common/core/limits/web.hpp"
#include "common/core/result.hpp"
#include "master/net/metrics.hpp"
#include "master/page/master_page.hpp"
#include "proto/access/refusals.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/http/http.hpp"
#include "proto/channel/listener.hpp"
#include "proto/channel/seats.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cd {

class Access;
class Coordinator;
class MasterIdentity;

/// Speaks HTTP/1.1, one GET or HEAD per connection. With an identity, which must outlive this
/// object, serves only TLS; then /metrics and the page's data need a certificate that may see them,
/// and the rest is public. All members run on the coordinator's thread.
class HttpFront {
  public:
    /// Opens the port at once; with port 0 the system chooses one. `host_names` are further names
    /// by which browsers may address this server. Errors: as `Listener::open`.
    [[nodiscard]] static Result<std::unique_ptr<HttpFront>>
    listen(const asio::any_io_executor& executor,
           const Endpoint& endpoint,
           Coordinator& coordinator,
           MasterIdentity* identity = nullptr,
           std::vector<std::string> host_names = {});

    [[nodiscard]] std::uint16_t port() const { return listener_->port(); }
    void start();
    void close();

  private:
    HttpFront(std::unique_ptr<Listener> listener,
              Coordinator& coordinator,
              MasterIdentity* identity,
              std::vector<std::string> host_names,
              bool is_loopback);
    void accept(asio::ip::tcp::socket socket);
    [[nodiscard]] asio::awaitable<void> serve(asio::ip::tcp::socket socket, Seats::Seat seat);
    void answer(const HttpRequest& request, const Access& access, HttpRespond respond);
    [[nodiscard]] HttpAnswer metrics(const HttpRequest& request, const Access& access);
    [[nodiscard]] MasterFigures figures();

    std::unique_ptr<Listener> listener_;
    Coordinator& coordinator_;
    MasterIdentity* identity_;                  ///< Null: HTTP without TLS.
    Seats seats_{limits::http_connections_max}; ///< Connection slots.
    Refusals refusals_;
    MasterPage page_;
    bool is_loopback_;                          ///< Only this machine can connect.
    std::map<unsigned, std::uint64_t> answers_; ///< Number of answers by their status code.
};

} // namespace cd
