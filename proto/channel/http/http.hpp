// One HTTP/1.1 request on a stream, and its answer.
#pragma once

#include "common/core/timing/wire.hpp"
#include "proto/channel/http/http_body.hpp"
#include "proto/channel/stream.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// A request without its body. A missing header is empty.
struct HttpRequest {
    std::string method; ///< For example "GET".
    std::string target; ///< For example "/metrics".
    std::string host = {};
    std::string authorization = {};
    std::string if_none_match = {};
    std::string accept_encoding = {};
};

struct HttpAnswer {
    unsigned status = 200;
    std::string body = {};
    std::string content_type = "text/plain; charset=utf-8";
    std::vector<std::pair<std::string_view, std::string>> headers = {}; ///< Name and value.
    std::shared_ptr<HttpBody> content = nullptr; ///< Takes the place of `body` unless null.
};

/// Takes the answer to a request, on the thread of its stream.
using HttpRespond = std::function<void(HttpAnswer)>;
/// Answers a request at once or later. If it drops `respond`, the connection closes.
using HttpHandler = std::function<void(const HttpRequest& request, HttpRespond respond)>;

/// Reads a request's head within `timeout`, answers it, and ends the stream. The answer is written
/// in pieces of at most `limits::http_piece_bytes`; a peer that does not take a piece within
/// `timeout` is disconnected. Invalid requests get status 400. The request's body is not read. HEAD
/// gets the head of the answer alone. Each answer has the headers that keep browsers from mixing it
/// with other origins. `handler` is called at most once and is destroyed with the stream.
void serve_http(std::unique_ptr<Stream> stream,
                HttpHandler handler,
                std::chrono::steady_clock::duration timeout = timing::http_exchange_max);

} // namespace cd
