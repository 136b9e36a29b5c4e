// Serves the page on this machine alone, to those who know the key.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "web/server/page_source.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace cd {

/// Listens on loopback. Since other users of this machine can connect, data need a random key that
/// lives as long as this object.
class PageGateway {
  public:
    /// Listens at once; for port 0 the system chooses one. Errors: Io if the port is in use.
    [[nodiscard]] static Result<std::unique_ptr<PageGateway>> listen(std::uint16_t port);
    PageGateway(const PageGateway&) = delete;
    PageGateway& operator=(const PageGateway&) = delete;
    ~PageGateway();

    /// Returns the executor for sources, which end before this object.
    [[nodiscard]] asio::any_io_executor executor();
    /// Returns the page's address with the key: http://127.0.0.1:PORT/#key=...
    [[nodiscard]] std::string url() const;
    /// Serves a source on this thread until `stop` returns true, or until no request has come for
    /// `idle_max`, if given. May be called once.
    void serve(PageSource& source,
               const StopCheck& stop,
               std::optional<std::chrono::milliseconds> idle_max);

  private:
    struct State;
    explicit PageGateway(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Opens an address in the user's browser, if there is a display and a browser. Returns at once.
void open_browser(const std::string& url);

} // namespace cd
