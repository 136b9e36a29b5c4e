#include "worker/run_worker.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/version.hpp"
#include "common/geometry/simd_target.hpp"
#include "proto/signals.hpp"
#include "worker/session.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace cd {
namespace {

constexpr int exit_done = 0;
constexpr int exit_usage = 2;
constexpr int exit_unreachable = 4;
constexpr int exit_refused = 5;
constexpr int exit_at_once = 130;

class Daemon {
  public:
    Daemon(const WorkerConfig& config, asio::io_context& context)
        : config_(config),
          context_(context),
          executor_(context.get_executor(), config.threads),
          signals_(context.get_executor(), [this](unsigned count) { stop(count); }),
          pause_(context),
          backoff_(std::random_device{}()) {}

    asio::awaitable<void> run() {
        const auto give_up_at = std::chrono::steady_clock::now() + config_.connect_for;
        for (;;) {
            Target target{config_.master, tls_->now};
            const Result<std::shared_ptr<Channel>> channel = co_await connect(std::move(target));
            if (channel) {
                const std::optional<int> code = co_await serve(channel.value());
                if (code) {
                    co_return end(*code);
                }
            } else {
                spdlog::info("no master yet: reason=\"{}\"", channel.error().detail);
            }
            if (!was_welcome_ && std::chrono::steady_clock::now() >= give_up_at) {
                spdlog::error("no master within --connect-for: seconds={}",
                              config_.connect_for.count());
                co_return end(exit_unreachable);
            }
            pause_.expires_after(backoff_.next());
            boost::system::error_code ignored;
            co_await pause_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        }
    }

    [[nodiscard]] int exit_code() const { return exit_code_; }

  private:
    /// From the greeting to the end of the session; an exit code when it was the last one.
    asio::awaitable<std::optional<int>> serve(std::shared_ptr<Channel> channel) {
        Hello hello;
        hello.role = Role::Worker;
        hello.name = config_.name;
        hello.build = std::string(version);
        hello.threads = executor_.threads();
        hello.cache_bytes = config_.cache_bytes;
        listen_to_peers(*channel);
        hello.peer_port = peer_server_ == nullptr ? std::uint16_t{0} : peer_server_->port();
        hello.weight = config_.weight;
        hello.instance = instance_;
        const Result<Welcome> welcome = co_await greet(channel, hello);
        if (!welcome) {
            spdlog::error("not welcome: error=\"{}\"", welcome.error().detail);
            const bool refused = welcome.error().code == ErrorCode::Refused;
            co_return refused ? std::optional<int>(exit_refused) : std::nullopt;
        }
        spdlog::info("connected: master={} worker={} threads={} cache_bytes={}",
                     channel->peer(),
                     welcome.value().id,
                     executor_.threads(),
                     config_.cache_bytes);
        was_welcome_ = true;
        backoff_.reset();
        keep_->enter(welcome.value().cluster);
        session_ = std::make_shared<Session>(
            channel,
            executor_,
            config_.cache_bytes,
            PeerParts{peer_server_, welcome.value().peer_key, config_.name, tls_},
            keep_);
        const SessionEnd how = co_await session_->run();
        const std::shared_ptr<Session> session = std::move(session_);
        if (how != SessionEnd::Lost || stopping_) {
            co_return exit_done;
        }
        spdlog::warn("master lost: reason=\"{}\"", session->reason());
        co_return std::nullopt;
    }

    /// On the address by which the master sees this worker. Without it all works, too.
    void listen_to_peers(const Channel& channel) {
        const Endpoint endpoint{channel.own_host(), config_.peer_port};
        if (config_.no_peers || peer_server_ != nullptr ||
            !check_exposure(endpoint, {tls_->now != nullptr, config_.insecure, true})) {
            return;
        }
        Result<std::shared_ptr<PeerServer>> server =
            PeerServer::listen(context_.get_executor(), endpoint, tls_);
        if (server) {
            peer_server_ = std::move(server.value());
        } else {
            spdlog::warn("other workers get nothing here: error=\"{}\"", server.error().detail);
        }
    }

    void stop(unsigned count) {
        if (count > 1) {
            spdlog::warn("ended at once by a second signal");
            std::_Exit(exit_at_once);
        }
        stopping_ = true;
        if (session_ != nullptr) {
            session_->stop();
        } else {
            spdlog::info("ended: nothing was under way");
            context_.stop();
        }
    }

    void end(int code) {
        spdlog::info("ended: exit_code={}", code);
        exit_code_ = code;
        peer_server_.reset();
        signals_.cancel();
    }

    const WorkerConfig& config_;
    asio::io_context& context_;
    Executor executor_;
    std::shared_ptr<TlsSlot> tls_ = std::make_shared<TlsSlot>();
    StopSignals signals_;
    asio::steady_timer pause_;
    Backoff backoff_;
    std::shared_ptr<PeerServer> peer_server_; ///< Null where others get nothing.
    std::shared_ptr<WorkerKeep> keep_ = std::make_shared<WorkerKeep>(config_.cache_bytes);
    const std::uint64_t instance_ = std::random_device{}() | std::uint64_t{std::random_device{}()}
                                                                 << 32;
    std::shared_ptr<Session> session_; ///< Null while there is no master.
    bool was_welcome_ = false;
    bool stopping_ = false;
    int exit_code_ = exit_done;
};

} // namespace

std::chrono::milliseconds Backoff::next() {
    const std::uint64_t min = limits::reconnect_after_min.count();
    const std::uint64_t max = limits::reconnect_after_max.count();
    const std::uint64_t pause = std::min(max, min << std::min(attempts_, 16u));
    ++attempts_;
    return std::chrono::milliseconds(pause / 2 + random_() % (pause / 2 + 1));
}

void Backoff::reset() {
    attempts_ = 0;
}

int run_worker(const WorkerConfig& config) {
    const Exposure exposure{false, config.insecure, false};
    if (const Status allowed = check_exposure(config.master, exposure); !allowed) {
        spdlog::error("refused: {}", allowed.error().detail);
        return exit_refused;
    }
    const Status simd =
        config.simd.empty() ? check_simd_environment() : force_simd_target(config.simd);
    if (!simd) {
        spdlog::error("wrong usage: {}", simd.error().detail);
        return exit_usage;
    }
    spdlog::info("instructions chosen: simd={}", to_text(simd_target()));
    asio::io_context context(1);
    Daemon daemon(config, context);
    spawn(context.get_executor(), "worker", daemon.run());
    context.run();
    return daemon.exit_code();
}

} // namespace cd
