// Proves that HTTP answers arrive whole, from memory and from files, at once or late; and that a
// reader that stands still is disconnected and slows nobody else.
#include "proto/channel/http/http.hpp"

#include "common/core/limits/web.hpp"
#include "tests/proto/http_ask.hpp"
#include "tests/proto/loopback.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>

#include <random>
#include <vector>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A client's end of a connection that `serve_http` serves.
class HttpEnd {
  public:
    HttpEnd(asio::io_context& context,
            HttpHandler handler,
            const std::string& request,
            std::chrono::steady_clock::duration timeout = patience)
        : context_(context), socket_(context) {
        asio::ip::tcp::acceptor acceptor = listen_anywhere(context.get_executor());
        socket_.connect(acceptor.local_endpoint());
        serve_http(std::make_unique<Stream>(acceptor.accept()), std::move(handler), timeout);
        asio::write(socket_, asio::buffer(request));
    }

    /// Reads to the end of the connection.
    HttpReply read() {
        bool is_over = false;
        read_next(is_over);
        context_.restart(); // An earlier connection may have left it without work.
        while (!is_over) {
            context_.run_one();
        }
        return parse_reply(text_);
    }

  private:
    void read_next(bool& is_over) {
        socket_.async_read_some(asio::buffer(part_), [&](const auto& error, std::size_t bytes) {
            text_.append(part_.data(), bytes);
            is_over = static_cast<bool>(error);
            if (!is_over) {
                read_next(is_over);
            }
        });
    }

    asio::io_context& context_;
    asio::ip::tcp::socket socket_;
    std::array<char, 65536> part_{};
    std::string text_;
};

std::string random_text(std::size_t size) {
    std::mt19937 random(7);
    std::string text(size, ' ');
    for (char& each : text) {
        each = static_cast<char>(random());
    }
    return text;
}

class Http : public testing::Test {
  protected:
    HttpReply ask(HttpHandler handler, const std::string& request) {
        return HttpEnd(context_, std::move(handler), request).read();
    }
    HttpReply ask_for(HttpAnswer answer, const std::string& method = "GET") {
        return ask([answer](const HttpRequest&, const HttpRespond& respond) { respond(answer); },
                   request_text(method, "/"));
    }

    asio::io_context context_;
};

const std::size_t several_pieces = 4 * limits::http_piece_bytes + 1000;

TEST_F(Http, ABodyOfSeveralPiecesArrivesWholeFromMemoryAndFromAFile) {
    const TemporaryFolder folder;
    ThreadPool pool(1);
    const std::string text = random_text(several_pieces);
    write_text(folder / "body", text);
    HttpAnswer from_memory;
    from_memory.content = make_memory_body(text);
    HttpAnswer from_file;
    from_file.content = make_file_body(std::move(DiskFile::open(folder / "body").value()),
                                       several_pieces,
                                       pool,
                                       context_.get_executor());
    for (const HttpAnswer& answer : {HttpAnswer{200, text}, from_memory, from_file}) {
        const HttpReply reply = ask_for(answer);
        EXPECT_EQ(reply.status, 200);
        EXPECT_TRUE(reply.body == text);
        EXPECT_THAT(reply.head, HasSubstr("Content-Length: " + std::to_string(several_pieces)));
        EXPECT_THAT(reply.head, HasSubstr("\r\nCross-Origin-Opener-Policy: same-origin\r\n"));
        EXPECT_THAT(reply.head, HasSubstr("\r\nCross-Origin-Resource-Policy: same-origin"));
    }
}

TEST_F(Http, AFileThatIsTooShortEndsTheConnectionBeforeTheStatedLength) {
    const TemporaryFolder folder;
    ThreadPool pool(1);
    write_text(folder / "body", "short");
    HttpAnswer answer;
    answer.content = make_file_body(
        std::move(DiskFile::open(folder / "body").value()), 100, pool, context_.get_executor());
    EXPECT_EQ(ask_for(answer).body, "");
}

TEST_F(Http, HeadGetsTheHeadOfTheAnswerAlone) {
    const HttpReply reply = ask_for({200, std::string(1000, 'x')}, "HEAD");
    EXPECT_EQ(reply.status, 200);
    EXPECT_THAT(reply.head, HasSubstr("Content-Length: 1000"));
    EXPECT_EQ(reply.body, "");
}

TEST_F(Http, AnAnswerMayComeLater) {
    asio::steady_timer timer(context_);
    const HttpReply reply = ask(
        [&](const HttpRequest&, HttpRespond respond) {
            timer.expires_after(std::chrono::milliseconds(1));
            timer.async_wait([respond](auto&&...) { respond({200, "late"}); });
        },
        request_text("GET", "/"));
    EXPECT_EQ(reply.body, "late");
}

TEST_F(Http, AHandlerThatDropsItsAnswerClosesTheConnection) {
    EXPECT_EQ(ask([](auto&&...) {}, request_text("GET", "/")).status, 0);
}

TEST_F(Http, TheHandlerGetsTheHeadersThatServersRead) {
    HttpRequest got;
    const HttpReply reply = ask(
        [&](const HttpRequest& request, const HttpRespond& respond) {
            got = request;
            respond({});
        },
        request_text("GET",
                     "/a?b",
                     "Authorization: Bearer k\r\nIf-None-Match: \"e\"\r\nAccept-Encoding: gzip\r\n",
                     "there:80"));
    EXPECT_EQ(reply.status, 200);
    EXPECT_EQ(got.target, "/a?b");
    EXPECT_EQ(got.host, "there:80");
    EXPECT_EQ(got.authorization, "Bearer k");
    EXPECT_EQ(got.if_none_match, "\"e\"");
    EXPECT_EQ(got.accept_encoding, "gzip");
    EXPECT_EQ(ask([](auto&&...) {}, request_text("GET", "/", "Host: other\r\n")).status, 400);
}

TEST_F(Http, EveryAnswerForbidsBrowsersToMixItWithOtherOrigins) {
    for (const HttpReply& reply :
         {ask_for({200, "x"}), ask_for({404, "x"}), ask([](auto&&...) {}, "rubbish\r\n\r\n")}) {
        EXPECT_THAT(reply.head, HasSubstr("Content-Security-Policy: default-src 'none';"));
        EXPECT_THAT(reply.head, HasSubstr("X-Content-Type-Options: nosniff"));
        EXPECT_THAT(reply.head, HasSubstr("Referrer-Policy: no-referrer"));
        EXPECT_THAT(reply.head, Not(HasSubstr("Set-Cookie")));
    }
}

TEST_F(Http, AReaderThatStandsStillIsDisconnected) {
    auto seat = std::make_shared<int>();
    const std::weak_ptr<int> taken = seat;
    HttpAnswer answer;
    answer.content = make_memory_body(std::string(64u << 20, 'x'));
    const HttpEnd still(
        context_,
        [answer, seat](const HttpRequest&, const HttpRespond& respond) { respond(answer); },
        request_text("GET", "/"),
        std::chrono::milliseconds(50));
    seat.reset();
    while (!taken.expired()) {
        context_.run_one(); // Hangs if the connection stays.
    }
}

TEST_F(Http, ManySlowReadersDoNotHoldUpAnother) {
    const std::string text(16u << 20, 'x');
    const auto owner = std::make_shared<const std::string>(text);
    std::vector<std::unique_ptr<HttpEnd>> slow;
    for (int i = 0; i < 64; ++i) {
        HttpAnswer answer;
        answer.content = make_memory_body(std::as_bytes(std::span(*owner)), owner);
        slow.push_back(std::make_unique<HttpEnd>(
            context_,
            [answer](const HttpRequest&, const HttpRespond& respond) { respond(answer); },
            request_text("GET", "/")));
    }
    EXPECT_EQ(ask_for({200, "ok"}).body, "ok");
    EXPECT_EQ(slow.front()->read().body.size(), text.size());
}

} // namespace
} // namespace cd::tests
