// One HTTP/1.1 request on a stream, and its answer.
#pragma once

#include "common/core/timing/wire.hpp"
#include "proto/channel/stream.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace cd {

struct HttpRequest {
    std::string method; ///< For example "GET".
    std::string target; ///< For example "/metrics".
};

struct HttpAnswer {
    unsigned status = 200;
    std::string body;
    std::string content_type = "text/plain; charset=utf-8";
};

/// Reads a request's head, answers it, and ends the stream, all within the timeout. Invalid
/// requests get status 400. The body is not read. `answer` is called at most once and is destroyed
/// with the stream.
void serve_http(std::unique_ptr<Stream> stream,
                std::function<HttpAnswer(const HttpRequest&)> answer,
                std::chrono::steady_clock::duration timeout = timing::http_exchange_max);

} // namespace cd
