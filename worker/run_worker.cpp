#include "worker/run_worker.hpp"

#include "common/core/host/log.hpp"
#include "common/core/host/service_notice.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/worker.hpp"
#include "common/core/version.hpp"
#include "common/geometry/simd_target.hpp"
#include "proto/access/credential_file.hpp"
#include "proto/access/join.hpp"
#include "proto/channel/signals.hpp"
#include "worker/membership/backoff.hpp"
#include "worker/membership/credential_keeper.hpp"
#include "worker/membership/leave_rule.hpp"
#include "worker/membership/membership.hpp"
#include "worker/membership/refusal_patience.hpp"

#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <utility>

namespace cd {
namespace {

constexpr int exit_done = 0;
constexpr int exit_usage = 2;
constexpr int exit_unreachable = 4;
constexpr int exit_refused = 5;
constexpr int exit_at_once = 130;

/// The waits between connections to the master.
class ReconnectPause {
  public:
    explicit ReconnectPause(asio::io_context& context)
        : timer_(context), backoff_(std::random_device{}()) {}

    asio::awaitable<void> wait() {
        timer_.expires_after(backoff_.next());
        boost::system::error_code ignored;
        co_await timer_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
    /// Ends the current wait, and makes the next one short.
    void skip() {
        backoff_.reset();
        timer_.cancel();
    }

  private:
    asio::steady_timer timer_;
    Backoff backoff_;
};

class Daemon {
  public:
    Daemon(const WorkerConfig& config,
           asio::io_context& context,
           std::unique_ptr<CredentialKeeper> keeper)
        : config_(config),
          context_(context),
          keeper_(std::move(keeper)),
          executor_(context.get_executor(), config.threads),
          membership_(executor_, config.cache_bytes),
          signals_(context.get_executor(), [this](unsigned count) { stop(count); }),
          pause_(context) {}

    asio::awaitable<void> run() {
        spawn(context_.get_executor(), "renewal", keeper_->keep());
        if (!LeaveRule(config_.times.leave).is_off()) {
            spawn(context_.get_executor(), "leaving", leave_when_due());
        }
        const auto give_up_at = std::chrono::steady_clock::now() + config_.times.connect_for;
        for (;;) {
            Target target{config_.master, keeper_->tls()->now};
            const Result<std::shared_ptr<Channel>> channel = co_await connect(
                std::move(target), std::chrono::ceil<std::chrono::seconds>(membership_.patience()));
            if (channel) {
                const std::optional<int> code = co_await serve(channel.value());
                if (code) {
                    channel.value()->close(true);
                    co_await channel.value()->wait_until_closed();
                    co_return end(*code);
                }
            } else if (channel.error().code == ErrorCode::Refused) {
                if (!tries_again_after_refusal(channel.error().detail)) {
                    co_return end(exit_refused);
                }
            } else {
                log_info("no master yet: reason=\"{}\"", channel.error().detail);
            }
            if (!patience_.was_accepted() && std::chrono::steady_clock::now() >= give_up_at) {
                log_error("no master within --connect-for: seconds={}",
                          config_.times.connect_for.count());
                co_return end(exit_unreachable);
            }
            co_await pause_.wait();
        }
    }

    [[nodiscard]] int exit_code() const { return exit_code_; }

  private:
    /// Greets and serves the master over one connection. Returns an exit code if the worker ends.
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
        PeerParts peers{peer_server_, {}, config_.name, keeper_->tls()};
        const Result<Served> served =
            co_await membership_.serve(channel, std::move(hello), std::move(peers));
        if (!served) {
            co_return exit_code_of_failed_greeting(served.error(), had_answer(*channel));
        }
        patience_.accepted();
        pause_.skip();
        const SessionEnd how = served.value().how;
        const bool has_ended = how == SessionEnd::Drained || how == SessionEnd::Terminated;
        if (has_ended || (membership_.is_draining() && !membership_.has_work())) {
            co_return exit_done;
        }
        log_warning("master lost: reason=\"{}\"", served.value().reason);
        co_return std::nullopt;
    }

    /// Whether any bytes came from the master. If so, a refusal does not come from TLS.
    static bool had_answer(const Channel& channel) { return channel.traffic().bytes_received != 0; }

    /// Returns nothing if the worker retries. The worker ends if the master itself refused the
    /// worker, or if TLS has refused the worker or the master for too long.
    std::optional<int> exit_code_of_failed_greeting(const Error& error, bool is_by_master) {
        log_error("greeting failed: error=\"{}\"", error.detail);
        const bool tries_again = error.code != ErrorCode::Refused ||
                                 (!is_by_master && tries_again_after_refusal(error.detail));
        return tries_again ? std::nullopt : std::optional<int>(exit_refused);
    }

    /// Whether to retry after TLS has refused this worker or its master.
    bool tries_again_after_refusal(const std::string& why) {
        const auto left = patience_.refused(std::chrono::steady_clock::now());
        if (left <= std::chrono::steady_clock::duration::zero()) {
            log_error(
                "refused: error=\"{}\" remedy=\"if the clocks of both hosts are right, join again: "
                "cdworker join MASTER --token TOKEN\"",
                why);
            return false;
        }
        log_error("refused, retrying for a time: seconds={} error=\"{}\" remedy=\"check that the "
                  "clocks of both hosts are right and the certificates valid\"",
                  std::chrono::ceil<std::chrono::seconds>(left).count(),
                  why);
        return true;
    }

    /// Listens for other workers, on the address of this host that `channel` uses. A failure is
    /// only logged.
    void listen_to_peers(const Channel& channel) {
        const Endpoint endpoint{channel.own_host(), config_.peer_port};
        if (config_.no_peers || peer_server_ != nullptr ||
            !check_exposure(endpoint, {keeper_->is_secured(), config_.insecure, true})) {
            return;
        }
        Result<std::shared_ptr<PeerServer>> server =
            PeerServer::listen(context_.get_executor(), endpoint, keeper_->tls());
        if (server) {
            peer_server_ = std::move(server.value());
        } else {
            log_warning("cannot serve geometry to other workers: error=\"{}\"",
                        server.error().detail);
        }
    }

    asio::awaitable<void> leave_when_due() {
        LeaveRule rule(config_.times.leave);
        asio::steady_timer timer(context_);
        for (;;) {
            const WorkerMoment moment{membership_.is_connected(),
                                      membership_.has_work(),
                                      membership_.scenarios_computed()};
            const Leave leave = rule.observe(moment, std::chrono::steady_clock::now());
            if (leave == Leave::Idle && !membership_.is_draining()) {
                log_info("leaving, there was no work: seconds={}",
                         config_.times.leave.idle->count());
                drain();
            }
            if (leave == Leave::Orphaned) {
                log_error("leaving, there was no master: seconds={}",
                          config_.times.leave.orphaned->count());
                membership_.end();
                membership_.log_unkept();
                co_return end(exit_unreachable);
            }
            timer.expires_after(timing::leave_check_period);
            co_await timer.async_wait(asio::use_awaitable);
        }
    }

    void stop(unsigned count) {
        if (count > 1) {
            log_warning("ended at once by a second signal");
            std::_Exit(exit_at_once);
        }
        drain();
    }

    void drain() {
        notify_service("STOPPING=1");
        if (membership_.drain(config_.times.drain_timeout, [this] { context_.stop(); })) {
            pause_.skip(); // Reconnects at once, to drain over the new connection.
        } else {
            log_info("ended, no work remained: scenarios_computed={}",
                     membership_.scenarios_computed());
            context_.stop();
        }
    }

    void end(int code) {
        log_info(
            "ended: exit_code={} scenarios_computed={}", code, membership_.scenarios_computed());
        exit_code_ = code;
        membership_.end();
        keeper_->stop();
        signals_.cancel();
        context_.stop(); // Closes idle connections of peers without a wait.
    }

    const WorkerConfig& config_;
    asio::io_context& context_;
    std::unique_ptr<CredentialKeeper> keeper_;
    Executor executor_;
    Membership membership_;
    StopSignals signals_;
    ReconnectPause pause_;
    std::shared_ptr<PeerServer> peer_server_; ///< Null if this worker serves no blocks.
    const std::uint64_t instance_ = std::random_device{}() | std::uint64_t{std::random_device{}()}
                                                                 << 32;
    RefusalPatience patience_;
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
    // Checks the file first: a join spends a use of the token even if the file cannot be written.
    const std::filesystem::path path = credential_path(config.state, config.master);
    if (const Status can_write = check_can_write(path); !can_write) {
        log_error("not joined: error=\"{}\"", can_write.error().detail);
        return exit_code_of(can_write.error());
    }
    asio::io_context context(1);
    std::optional<Result<Credential>> credential;
    std::string name = config.name.substr(0, limits::certified_name_bytes_max);
    spawn(context.get_executor(), "join", join(config, std::move(name), credential));
    context.run();
    if (!credential) {
        return exit_unreachable; // `spawn` has logged the error.
    }
    const Status done =
        *credential ? write_credential(path, credential->value()) : Status(credential->error());
    if (!done) {
        log_error("not joined: error=\"{}\"", done.error().detail);
        return exit_code_of(done.error());
    }
    log_info("joined: master={} credential={}", config.master.host, path.string());
    return exit_done;
}

int run_worker(const WorkerConfig& config) {
    asio::io_context context(1);
    auto keeper = CredentialKeeper::open(
        context.get_executor(), credential_path(config.state, config.master), config.master);
    if (!keeper) {
        log_error("no credential: error=\"{}\"", keeper.error().detail);
        return keeper.error().code == ErrorCode::Refused ? exit_refused : exit_usage;
    }
    const Exposure exposure{keeper.value()->is_secured(), config.insecure, false};
    if (const Status allowed = check_exposure(config.master, exposure); !allowed) {
        log_error("refused: error=\"{}\"", allowed.error().detail);
        return exit_refused;
    }
    const Status simd =
        config.simd.empty() ? check_simd_environment() : force_simd_target(config.simd);
    if (!simd) {
        log_error("wrong usage: error=\"{}\"", simd.error().detail);
        return exit_usage;
    }
    log_info("SIMD instructions chosen: simd={}", to_text(simd_target()));
    Daemon daemon(config, context, std::move(keeper.value()));
    spawn(context.get_executor(), "worker", daemon.run());
    context.run();
    return daemon.exit_code();
}

} // namespace cd
