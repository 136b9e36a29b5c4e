#include "proto/channel/http.hpp"

#include "common/core/limits/wire.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/deadline.hpp"

#include <boost/beast/http.hpp>

#include <array>
#include <sstream>
#include <utility>

namespace cd {

namespace {

namespace http = boost::beast::http;
using boost::system::error_code;

/// A request and its answer. Keeps itself alive while its stream is read or written.
class Exchange : public std::enable_shared_from_this<Exchange> {
  public:
    using Answer = std::function<HttpAnswer(const HttpRequest&)>;

    Exchange(std::unique_ptr<Stream> stream,
             Answer answer,
             std::chrono::steady_clock::duration timeout)
        : stream_(std::move(stream)),
          deadline_(stream_->socket(), timeout),
          answer_(std::move(answer)) {
        parser_.header_limit(limits::http_request_bytes_max);
    }

    void read() {
        stream_->read_some(asio::buffer(part_),
                           [self = shared_from_this()](const error_code& error, std::size_t bytes) {
                               if (!error) {
                                   self->came(bytes);
                               }
                           });
    }

  private:
    void came(std::size_t bytes) {
        head_.append(part_.data(), bytes);
        error_code error;
        head_.erase(0, parser_.put(asio::buffer(head_), error));
        if (parser_.is_header_done()) {
            const auto& head = parser_.get();
            return respond(
                answer_({std::string(head.method_string()), std::string(head.target())}));
        }
        if ((error && error != http::error::need_more) ||
            head_.size() > limits::http_request_bytes_max) {
            return respond({400, "this is not an HTTP request\n"});
        }
        read();
    }

    void respond(HttpAnswer answer) {
        http::response<http::string_body> response{http::int_to_status(answer.status), 11};
        response.set(http::field::content_type, answer.content_type);
        if (response.result() == http::status::method_not_allowed) {
            response.set(http::field::allow, "GET");
        }
        response.keep_alive(false);
        response.body() = std::move(answer.body);
        response.prepare_payload();
        std::ostringstream text;
        text << response;
        bytes_ = text.str();
        stream_->write({asio::buffer(bytes_), asio::const_buffer()},
                       [self = shared_from_this()](auto&&...) { self->stream_->end_writing(); });
    }

    std::unique_ptr<Stream> stream_;
    Deadline<asio::ip::tcp::socket> deadline_;
    Answer answer_;
    http::request_parser<http::empty_body> parser_;
    std::array<char, 4096> part_{};
    std::string head_;  ///< Received bytes that the parser has not consumed.
    std::string bytes_; ///< The encoded response.
};

} // namespace

void serve_http(std::unique_ptr<Stream> stream,
                std::function<HttpAnswer(const HttpRequest&)> answer,
                std::chrono::steady_clock::duration timeout) {
    std::make_shared<Exchange>(std::move(stream), std::move(answer), timeout)->read();
}

} // namespace cd
