// Serves the monitoring pages /healthz, /readyz and /metrics.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "proto/access/refusals.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/http/http.hpp"
#include "proto/channel/listener.hpp"
#include "proto/channel/seats.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace cd {

class Access;
class Coordinator;
class MasterIdentity;

/// Speaks HTTP/1.1, one GET per connection. With an identity, which must outlive this object,
/// serves only TLS, and /metrics only for a certificate that may view the cluster; the other pages
/// are public. All members run on the coordinator's thread.
class HttpFront {
  public:
    /// Opens the port at once; with port 0 the system chooses one. Errors: as `Listener::open`.
    [[nodiscard]] static Result<std::unique_ptr<HttpFront>>
    listen(const asio::any_io_executor& executor,
           const Endpoint& endpoint,
           Coordinator& coordinator,
           MasterIdentity* identity = nullptr);

    [[nodiscard]] std::uint16_t port() const { return listener_->port(); }
    void start();
    void close();

  private:
    HttpFront(std::unique_ptr<Listener> listener,
              Coordinator& coordinator,
              MasterIdentity* identity);
    void accept(asio::ip::tcp::socket socket);
    [[nodiscard]] asio::awaitable<void> serve(asio::ip::tcp::socket socket, Seats::Seat seat);
    [[nodiscard]] HttpAnswer
    answer(const HttpRequest& request, const Access& access, const std::string& peer);

    std::unique_ptr<Listener> listener_;
    Coordinator& coordinator_;
    MasterIdentity* identity_;                  ///< Null: HTTP without TLS.
    Seats seats_{limits::http_connections_max}; ///< Connection slots.
    Refusals refusals_;
};

} // namespace cd
