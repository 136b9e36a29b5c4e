#include "proto/channel/http/http_get.hpp"

#include "common/core/limits/web.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/deadline.hpp"
#include "proto/channel/open_socket.hpp"
#include "proto/channel/stream.hpp"

#include <boost/beast/http.hpp>

#include <array>
#include <functional>
#include <optional>
#include <utility>

namespace cd {

namespace {

namespace http = boost::beast::http;
using boost::system::error_code;

/// Sends a request and reads the answer. Keeps itself alive while its stream is in use.
class Reading : public std::enable_shared_from_this<Reading> {
  public:
    using Done = std::function<void(Result<std::string>)>;

    Reading(std::unique_ptr<Stream> stream, std::chrono::seconds timeout, Done done)
        : stream_(std::move(stream)), done_(std::move(done)) {
        parser_.body_limit(limits::http_page_bytes_max);
        parser_.eager(true); // Parses the body in the same call as the head.
        deadline_.emplace(stream_->socket(), timeout);
    }

    void ask(const HttpPage& page) {
        const std::string& host = page.server.host;
        request_ = "GET " + page.target + " HTTP/1.1\r\nHost: " +
                   (host.find(':') == std::string::npos ? host : "[" + host + "]") +
                   "\r\nConnection: close\r\n\r\n";
        stream_->write({asio::buffer(request_), asio::const_buffer()},
                       [self = shared_from_this()](const error_code& error, std::size_t) {
                           error ? self->end(stream_error(error)) : self->read();
                       });
    }

  private:
    void read() {
        stream_->read_some(asio::buffer(part_),
                           [self = shared_from_this()](const error_code& error, std::size_t bytes) {
                               self->came(error, bytes);
                           });
    }

    void came(const error_code& failure, std::size_t bytes) {
        text_.append(part_.data(), bytes);
        error_code error;
        text_.erase(0, text_.empty() ? 0 : parser_.put(asio::buffer(text_), error));
        if (failure && !parser_.is_done()) {
            return end(deadline_->expired()
                           ? Error{ErrorCode::Timeout, "no answer in time"}
                           : Error{ErrorCode::Disconnected, "it hung up before it answered"});
        }
        if (error && error != http::error::need_more) {
            return end(
                Error{error == http::error::body_limit ? ErrorCode::TooLarge : ErrorCode::BadFrame,
                      "the answer is no page: " + error.message()});
        }
        parser_.is_done() ? finish() : read();
    }

    void finish() {
        const unsigned status = parser_.get().result_int();
        std::string& body = parser_.get().body();
        if (status == 200) {
            return end(std::move(body));
        }
        end(Error{ErrorCode::Refused,
                  "it answers " + std::to_string(status) + ": " + body.substr(0, body.find('\n'))});
    }

    void end(Result<std::string> result) {
        deadline_.reset();
        stream_->close();
        std::exchange(done_, nullptr)(std::move(result));
    }

    std::unique_ptr<Stream> stream_;
    Done done_;
    std::string request_;
    std::optional<Deadline<asio::ip::tcp::socket>> deadline_;
    http::response_parser<http::string_body> parser_;
    std::array<char, 4096> part_{};
    std::string text_; ///< Bytes that the parser has not consumed.
};

asio::awaitable<void> get_page(HttpPage page, std::chrono::seconds timeout, Reading::Done done) {
    Result<asio::ip::tcp::socket> socket = co_await open_socket(page.server, timeout);
    if (!socket) {
        done(socket.error());
        co_return;
    }
    auto stream = std::make_unique<Stream>(std::move(socket.value()));
    if (page.tls != nullptr) {
        const Status secured = co_await stream->secure(page.tls, TlsEnd::Connecting, timeout);
        if (!secured) {
            done(secured.error());
            co_return;
        }
    }
    std::make_shared<Reading>(std::move(stream), timeout, std::move(done))->ask(page);
}

} // namespace

Result<std::string> http_get(const HttpPage& page, std::chrono::seconds timeout) {
    asio::io_context context(1);
    Result<std::string> result = Error{ErrorCode::Disconnected, "it did not answer"};
    spawn(context.get_executor(),
          "http get",
          get_page(page, timeout, [&result](Result<std::string> got) { result = std::move(got); }));
    context.run();
    return result;
}

} // namespace cd
