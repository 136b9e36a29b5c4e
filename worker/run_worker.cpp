#include "worker/run_worker.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/version.hpp"
#include "common/geometry/simd_target.hpp"
#include "proto/credential_file.hpp"
#include "proto/join.hpp"
#include "proto/signals.hpp"
#include "worker/credential_keeper.hpp"
#include "worker/session.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

namespace cd {
namespace {

constexpr int exit_done = 0;
constexpr int exit_usage = 2;
constexpr int exit_unreachable = 4;
constexpr int exit_refused = 5;
constexpr int exit_at_once = 130;

class Daemon {
  public:
    Daemon(const WorkerConfig& config,
           asio::io_context& context,
           std::unique_ptr<CredentialKeeper> keeper)
        : config_(config),
          context_(context),
          keeper_(std::move(keeper)),
          tls_(keeper_->tls()),
          executor_(context.get_executor(), config.threads),
          signals_(context.get_executor(), [this](unsigned count) { stop(count); }),
          pause_(context),
          drain_timer_(context),
          backoff_(std::random_device{}()) {}

    asio::awaitable<void> run() {
        spawn(context_.get_executor(), "renewal", keeper_->keep());
        const auto give_up_at = std::chrono::steady_clock::now() + config_.connect_for;
        for (;;) {
            Target target{config_.master, tls_->now};
            const Result<std::shared_ptr<Channel>> channel = co_await connect(
                std::move(target), std::chrono::ceil<std::chrono::seconds>(patience()));
            if (channel) {
                const std::optional<int> code = co_await serve(channel.value());
                if (code) {
                    co_return end(*code);
                }
            } else if (channel.error().code == ErrorCode::Refused) {
                spdlog::error("refused: {}", channel.error().detail);
                co_return end(exit_refused);
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
    /// With a step of the greeting: while a session can go on, its time is short.
    [[nodiscard]] std::chrono::milliseconds patience() const {
        const std::chrono::milliseconds longest = limits::connect_timeout;
        return session_ == nullptr ? longest : std::min(longest, times_.silent_after);
    }

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
        if (session_ != nullptr) {
            hello.session = session_id_;
            hello.epoch = epoch_;
        }
        const Result<Welcome> welcome = co_await greet(channel, hello, patience());
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
        is_connected_ = true;
        const SessionEnd how = co_await converse(channel, welcome.value());
        is_connected_ = false;
        if (stopping_ || how == SessionEnd::Drained || how == SessionEnd::Terminated) {
            co_return exit_done;
        }
        spdlog::warn("master lost: reason=\"{}\"", session_->reason());
        if (how == SessionEnd::Disagreed) {
            session_.reset();
        }
        co_return std::nullopt;
    }

    asio::awaitable<SessionEnd> converse(std::shared_ptr<Channel> channel, Welcome welcome) {
        if (welcome.is_resumed && session_ != nullptr) {
            co_return co_await session_->resume(channel);
        }
        if (session_ != nullptr) {
            session_->leave();
        }
        session_id_ = welcome.id;
        epoch_ = welcome.epoch;
        times_ = SessionTimes::of(welcome);
        keep_->enter(welcome.cluster);
        const PeerParts peers{peer_server_, welcome.peer_key, config_.name, tls_};
        session_ = std::make_shared<Session>(
            channel, executor_, config_.cache_bytes, peers, keep_, times_);
        co_return co_await session_->run();
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
        if (is_connected_) {
            session_->stop();
            drain_timer_.expires_after(config_.drain_timeout);
            drain_timer_.async_wait([session = std::weak_ptr(session_)](const auto& error) {
                const auto draining = session.lock();
                if (!error && draining != nullptr) {
                    draining->hand_back();
                }
            });
        } else {
            spdlog::info("ended: nothing was under way");
            context_.stop();
        }
    }

    void end(int code) {
        spdlog::info("ended: exit_code={}", code);
        exit_code_ = code;
        session_.reset(); // It has a share in the server.
        peer_server_.reset();
        keeper_->stop();
        drain_timer_.cancel();
        signals_.cancel();
    }

    const WorkerConfig& config_;
    asio::io_context& context_;
    std::unique_ptr<CredentialKeeper> keeper_;
    std::shared_ptr<const TlsSlot> tls_;
    Executor executor_;
    StopSignals signals_;
    asio::steady_timer pause_;
    asio::steady_timer drain_timer_;
    Backoff backoff_;
    std::shared_ptr<PeerServer> peer_server_; ///< Null where others get nothing.
    std::shared_ptr<WorkerKeep> keep_ = std::make_shared<WorkerKeep>(config_.cache_bytes);
    const std::uint64_t instance_ = std::random_device{}() | std::uint64_t{std::random_device{}()}
                                                                 << 32;
    std::shared_ptr<Session> session_; ///< Also without a connection, as long as it may go on.
    std::uint64_t session_id_ = 0;
    std::uint64_t epoch_ = 0;
    SessionTimes times_;
    bool is_connected_ = false; ///< And welcome.
    bool was_welcome_ = false;
    bool stopping_ = false;
    int exit_code_ = exit_done;
};

asio::awaitable<void>
join(const WorkerConfig& config, std::string name, std::optional<Result<Credential>>& result) {
    Endpoint master = config.master;
    JoinToken token = *config.join;
    result = co_await join_cluster(std::move(master), std::move(token), std::move(name));
}

int exit_code_of(const Error& error) {
    switch (error.code) {
    case ErrorCode::Timeout:
    case ErrorCode::Disconnected:
        return exit_unreachable;
    case ErrorCode::BadFrame:
    case ErrorCode::Refused:
        return exit_refused;
    default:
        return exit_usage;
    }
}

} // namespace

int join_as_worker(const WorkerConfig& config) {
    asio::io_context context(1);
    std::optional<Result<Credential>> credential;
    std::string name = config.name.substr(0, limits::certified_name_bytes_max);
    spawn(context.get_executor(), "join", join(config, std::move(name), credential));
    context.run();
    if (!credential) {
        return exit_unreachable; // Logged by `spawn`.
    }
    const std::filesystem::path path = credential_path(config.state, config.master);
    const Status done =
        *credential ? write_credential(path, credential->value()) : Status(credential->error());
    if (!done) {
        spdlog::error("not joined: {}", done.error().detail);
        return exit_code_of(done.error());
    }
    spdlog::info("joined: master={} credential={}", config.master.host, path.string());
    return exit_done;
}

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
    asio::io_context context(1);
    auto keeper = CredentialKeeper::open(
        context.get_executor(), credential_path(config.state, config.master), config.master);
    if (!keeper) {
        spdlog::error("no credential: {}", keeper.error().detail);
        return keeper.error().code == ErrorCode::Refused ? exit_refused : exit_usage;
    }
    const Exposure exposure{keeper.value()->is_secured(), config.insecure, false};
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
    Daemon daemon(config, context, std::move(keeper.value()));
    spawn(context.get_executor(), "worker", daemon.run());
    context.run();
    return daemon.exit_code();
}

} // namespace cd
