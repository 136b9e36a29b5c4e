#include "proto/channel/http/http.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"
#include "web/server/page_request.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace cd::fuzz {

namespace {

struct Exchange {
    int requests = 0;
    HttpRequest request;
    std::string answer;
};

void write_all(int socket, Input bytes) {
    const ssize_t written = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    require(written == static_cast<ssize_t>(bytes.size()) || written < 0,
            "a socket takes a small request");
}

std::string read_all(int socket) {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t size = 0; (size = read(socket, part.data(), part.size())) > 0;) {
        text.append(part.data(), static_cast<std::size_t>(size));
    }
    return text;
}

/// Sends a request in pieces, and nothing after it.
Exchange exchange(std::array<Input, 2> pieces) {
    std::array<int, 2> ends{};
    require(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0, "a pair of sockets");
    Exchange done;
    {
        asio::io_context context;
        asio::ip::tcp::socket socket(context);
        socket.assign(asio::ip::tcp::v4(), ends[0]); // Any stream socket will do.
        const auto answer = [&done](const HttpRequest& request, const HttpRespond& respond) {
            ++done.requests;
            done.request = request;
            respond({});
        };
        serve_http(std::make_unique<Stream>(std::move(socket)), answer);
        for (const Input piece : pieces) {
            write_all(ends[1], piece);
            context.poll();
        }
        shutdown(ends[1], SHUT_WR);
        context.run();
    }
    done.answer = read_all(ends[1]);
    close(ends[1]);
    return done;
}

bool is_visible(const std::string& text) {
    return !text.empty() && std::ranges::none_of(text, [](unsigned char c) {
        return std::iscntrl(c) != 0 || c == ' ';
    });
}

/// A target of the page's interface is refused, or asks for what it says.
void read_target(const std::string& target) {
    constexpr std::uint64_t scenarios = 1000;
    const auto page = parse_page_request(target);
    if (!page) {
        require(!page.error().detail.empty(), "a refused target is told why");
        return;
    }
    require(target.starts_with(page_api), "all routes have one beginning");
    const ScenarioChoice& choice = page.value().choice;
    if (choice.check(scenarios, scenarios) && choice.size() != 0) {
        require(choice.at(choice.size() - 1, scenarios) < scenarios,
                "a choice stays within the job");
    }
}

} // namespace

void http(Input input) {
    if (input.size() < 2) {
        return;
    }
    const Input text = input.subspan(2);
    const std::size_t at =
        std::to_integer<std::size_t>(input[0]) + 256 * std::to_integer<std::size_t>(input[1]);
    const std::size_t cut = std::min(at, text.size());
    const Exchange whole = exchange({text, {}});
    const Exchange in_two = exchange({text.first(cut), text.subspan(cut)});
    require(whole.requests <= 1, "one request is answered");
    require(whole.requests == in_two.requests && whole.request.target == in_two.request.target,
            "how a request is cut makes no difference");
    // A fault in an endless request may go unnoticed.
    require(whole.answer == in_two.answer || whole.answer.empty() || in_two.answer.empty(),
            "how a request is cut makes no difference to its answer");
    if (whole.requests == 1) {
        read_target(whole.request.target);
        require(is_visible(whole.request.method) && is_visible(whole.request.target),
                "a request has a method and a target");
        require(whole.answer.starts_with("HTTP/1.1 200 "), "a request gets its answer");
    } else {
        require(whole.answer.empty() || whole.answer.starts_with("HTTP/1.1 400 "),
                "what is no request is told so");
    }
}

} // namespace cd::fuzz
