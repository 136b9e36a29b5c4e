// Answers requests to the page: static files, and data from a source.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/http/http.hpp"
#include "web/server/page_source.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// What the asking user must be allowed to see.
enum class PageRight : std::uint8_t {
    Nothing, ///< Everybody may see it.
    Cluster, ///< The cluster's status.
    Jobs,    ///< Results and geometry.
};

/// Decides whether the asking user has a right. Errors: Refused with the reason.
using PageAccess = std::function<Status(PageRight)>;

struct PageOptions {
    /// Names of this server besides loopback and `master`.
    std::vector<std::string> host_names = {};
    /// A secret that requests for data must show; nothing if none is needed.
    std::optional<std::string> key = std::nullopt;
};

/// All members run on the executor's thread.
class PageServer {
  public:
    /// The source outlives the server and its answers.
    PageServer(asio::any_io_executor executor, PageSource& source, PageOptions options)
        : executor_(std::move(executor)), source_(source), options_(std::move(options)) {}

    /// Answers any request. Status codes: 200 and 304; 400 for an invalid parameter; 401 without
    /// the key, late; 403 without the right; 404; 405 unless GET or HEAD; 421 for another host's
    /// name; 503 if the source is busy or has failed.
    void answer(const HttpRequest& request, const PageAccess& access, HttpRespond respond);

    /// Returns true unless the header Host has a name that is not this server's: a web page may
    /// point its own name at this server.
    [[nodiscard]] bool is_own_host(std::string_view host) const;

  private:
    [[nodiscard]] bool has_key(const HttpRequest& request) const;
    void refuse_late(HttpRespond respond);
    void answer_api(const HttpRequest& request, const PageAccess& access, HttpRespond respond);
    void ask(const PageRequest& request, HttpRespond respond);

    asio::any_io_executor executor_;
    PageSource& source_;
    PageOptions options_;
};

/// Returns an answer with a JSON document that says what is wrong.
[[nodiscard]] HttpAnswer error_answer(const Error& error);

} // namespace cd
