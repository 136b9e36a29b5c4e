#include "proto/channel/http/http.hpp"

#include "common/core/host/log.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/limits/wire.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/deadline.hpp"

#include <boost/beast/http.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

namespace cd {

namespace {

namespace http = boost::beast::http;
using boost::system::error_code;
using Head = http::request<http::empty_body>;
using BeastText = boost::beast::string_view;

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> security_headers{
    {{"Content-Security-Policy",
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; "
      "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
     {"X-Content-Type-Options", "nosniff"},
     {"Referrer-Policy", "no-referrer"},
     {"Cross-Origin-Opener-Policy", "same-origin"},
     {"Cross-Origin-Resource-Policy", "same-origin"}}};

std::string text_of(const Head& head, http::field field) {
    return std::string(head[field]);
}

HttpRequest request_of(const Head& head) {
    return {std::string(head.method_string()),
            std::string(head.target()),
            text_of(head, http::field::host),
            text_of(head, http::field::authorization),
            text_of(head, http::field::if_none_match),
            text_of(head, http::field::accept_encoding)};
}

std::string head_of(const HttpAnswer& answer, std::uint64_t body_bytes) {
    http::response<http::empty_body> response{http::int_to_status(answer.status), 11};
    response.set(http::field::content_type, answer.content_type);
    const auto set = [&](std::string_view name, std::string_view value) {
        response.set(BeastText(name.data(), name.size()), BeastText(value.data(), value.size()));
    };
    for (const auto& [name, value] : security_headers) {
        set(name, value);
    }
    if (response.result() == http::status::method_not_allowed) {
        response.set(http::field::allow, "GET, HEAD");
    }
    for (const auto& [name, value] : answer.headers) {
        set(name, value);
    }
    response.keep_alive(false);
    if (response.result() != http::status::not_modified) {
        response.content_length(body_bytes);
    }
    std::ostringstream text;
    text << response.base();
    return text.str();
}

/// A request and its answer. Keeps itself alive while its stream is read or written.
class Exchange : public std::enable_shared_from_this<Exchange> {
  public:
    Exchange(std::unique_ptr<Stream> stream,
             HttpHandler handler,
             std::chrono::steady_clock::duration timeout)
        : stream_(std::move(stream)), timeout_(timeout), handler_(std::move(handler)) {
        parser_.header_limit(limits::http_request_bytes_max);
        deadline_.emplace(stream_->socket(), timeout_);
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
        text_.append(part_.data(), bytes);
        error_code error;
        text_.erase(0, parser_.put(asio::buffer(text_), error));
        if (parser_.is_header_done()) {
            return answer(parser_.get());
        }
        if ((error && error != http::error::need_more) ||
            text_.size() > limits::http_request_bytes_max) {
            return respond({400, "this is not an HTTP request\n"});
        }
        read();
    }

    void answer(const Head& head) {
        deadline_.reset();
        has_body_ = head.method() != http::verb::head;
        if (head.count(http::field::host) > 1) {
            return respond({400, "a request names one Host\n"});
        }
        handler_(request_of(head), [self = shared_from_this()](HttpAnswer answer) {
            self->respond(std::move(answer));
        });
    }

    void respond(HttpAnswer answer) {
        body_ = answer.content != nullptr ? std::move(answer.content)
                                          : make_memory_body(std::move(answer.body));
        text_ = head_of(answer, body_->size());
        has_body_ = has_body_ && answer.status != 304;
        write_next();
    }

    /// Writes the head with the first piece of the body, then piece by piece.
    void write_next() {
        const std::uint64_t left = has_body_ ? body_->size() - offset_ : 0;
        if (left == 0) {
            return text_.empty() ? stream_->end_writing() : write({});
        }
        body_->read(offset_,
                    std::min<std::uint64_t>(left, limits::http_piece_bytes),
                    [self = shared_from_this()](Result<std::span<const std::byte>> piece) {
                        if (piece) {
                            return self->write(piece.value());
                        }
                        log_warning("http answer ended early: reason=\"{}\"", piece.error().detail);
                    });
    }

    void write(std::span<const std::byte> piece) {
        deadline_.emplace(stream_->socket(), timeout_);
        offset_ += piece.size();
        stream_->write({asio::buffer(text_), asio::buffer(piece.data(), piece.size())},
                       [self = shared_from_this()](const error_code& error, std::size_t) {
                           self->deadline_.reset();
                           self->text_.clear();
                           if (!error) {
                               self->write_next();
                           }
                       });
    }

    std::unique_ptr<Stream> stream_;
    std::chrono::steady_clock::duration timeout_;
    std::optional<Deadline<asio::ip::tcp::socket>> deadline_; ///< Of the operation that runs.
    HttpHandler handler_;
    http::request_parser<http::empty_body> parser_;
    std::array<char, 4096> part_{};
    std::string text_; ///< Bytes that the parser has not consumed; later the answer's head.
    std::shared_ptr<HttpBody> body_;
    std::uint64_t offset_ = 0; ///< Bytes of the body that are written or being written.
    bool has_body_ = true;     ///< False: the answer is a head alone.
};

} // namespace

void serve_http(std::unique_ptr<Stream> stream,
                HttpHandler handler,
                std::chrono::steady_clock::duration timeout) {
    std::make_shared<Exchange>(std::move(stream), std::move(handler), timeout)->read();
}

} // namespace cd
