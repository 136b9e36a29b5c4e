#include "client/view/page_gateway.hpp"

#include "common/core/errors.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/timing/web.hpp"
#include "proto/channel/http/http.hpp"
#include "proto/channel/listener.hpp"
#include "proto/channel/stream.hpp"
#include "web/server/page_server.hpp"

#include <fcntl.h>
#include <spawn.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

extern char** environ; // NOLINT: POSIX names it so.

namespace cd {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t key_digits = 32; ///< 128 bits.

bool has_display() {
    return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

} // namespace

struct PageGateway::State {
    /// Counts open connections, which may outlive the listener.
    std::shared_ptr<std::size_t> connections = std::make_shared<std::size_t>(0);
    asio::io_context context;
    std::unique_ptr<Listener> listener;
    std::string key = to_hex(random_secret()).substr(0, key_digits);
    std::unique_ptr<PageServer> server;
    asio::steady_timer timer{context};
    Clock::time_point last_request = Clock::now();

    void accept(asio::ip::tcp::socket socket) {
        if (*connections >= limits::view_connections_max) {
            return;
        }
        ++*connections;
        const std::shared_ptr<void> seat(nullptr, [count = connections](const void*) { --*count; });
        serve_http(std::make_unique<Stream>(std::move(socket)),
                   [this, seat](const HttpRequest& request, HttpRespond respond) {
                       last_request = Clock::now();
                       server->answer(
                           request, [](PageRight) { return Done{}; }, std::move(respond));
                   });
    }

    /// Ends the context once `stop` says so, or after `idle_max` without a request.
    void watch(const StopCheck& stop, std::optional<std::chrono::milliseconds> idle_max) {
        if (stop() || (idle_max && Clock::now() - last_request > *idle_max)) {
            context.stop();
            return;
        }
        timer.expires_after(timing::view_check_period);
        timer.async_wait([this, &stop, idle_max](const auto&) { watch(stop, idle_max); });
    }
};

PageGateway::PageGateway(std::unique_ptr<State> state) : state_(std::move(state)) {}
PageGateway::~PageGateway() = default;

Result<std::unique_ptr<PageGateway>> PageGateway::listen(std::uint16_t port) {
    auto state = std::make_unique<State>();
    state->listener =
        CD_TRY(Listener::open(state->context.get_executor(), Endpoint{"127.0.0.1", port}));
    return std::unique_ptr<PageGateway>(new PageGateway(std::move(state)));
}

asio::any_io_executor PageGateway::executor() {
    return state_->context.get_executor();
}

std::string PageGateway::url() const {
    return "http://127.0.0.1:" + std::to_string(state_->listener->port()) + "/#key=" + state_->key;
}

void PageGateway::serve(PageSource& source,
                        const StopCheck& stop,
                        std::optional<std::chrono::milliseconds> idle_max) {
    state_->server = std::make_unique<PageServer>(executor(), source, PageOptions{{}, state_->key});
    state_->last_request = Clock::now();
    state_->listener->start(
        [this](asio::ip::tcp::socket socket) { state_->accept(std::move(socket)); });
    state_->watch(stop, idle_max);
    state_->context.run();
    state_->listener->close();
}

void open_browser(const std::string& url) {
    if (!has_display()) {
        return;
    }
    std::string program = "xdg-open";
    std::string argument = url;
    const std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
    pid_t id = 0;
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    // What a browser prints must not mix with the output of this program.
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    (void)::posix_spawnp(&id, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
}

} // namespace cd
