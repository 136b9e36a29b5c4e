#include "worker/membership/membership.hpp"

#include "common/core/host/log.hpp"
#include "common/core/host/service_notice.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/wire.hpp"
#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <utility>

namespace cd {

Membership::Membership(Executor& executor, std::uint64_t cache_bytes, const UnkeptBounds& bounds)
    : executor_(executor),
      keep_(std::make_shared<CarryOver>(cache_bytes, bounds)),
      drain_timer_(executor.home()) {}

std::chrono::milliseconds Membership::patience() const {
    const std::chrono::milliseconds longest = timing::connect_timeout;
    return session_ == nullptr ? longest : std::min(longest, silence_borne_);
}

void Membership::learn_from(bool was_silent, std::chrono::steady_clock::duration lasted) {
    const bool was_short = lasted < limits::short_connection_silences * silence_borne_;
    silence_borne_ = was_silent && was_short ? std::min(2 * silence_borne_, times_.lost_after)
                                             : times_.silent_after;
    if (session_ != nullptr) {
        session_->link().bear_silence_for(silence_borne_);
    }
}

asio::awaitable<Result<Served>>
Membership::serve(std::shared_ptr<Channel> channel, Hello hello, PeerParts peers) {
    if (session_ != nullptr) {
        hello.resumed.id = session_id_;
        hello.resumed.epoch = epoch_;
    }
    const Result<Welcome> greeted = co_await greet(channel, hello, patience());
    if (!greeted) {
        learn_from(greeted.error().code == ErrorCode::Timeout, {});
        co_return greeted.error();
    }
    const Welcome& welcome = greeted.value();
    log_info("connected: master={} worker={} threads={} cache_bytes={}",
             channel->peer(),
             welcome.id,
             executor_.threads(),
             keep_->cache.bytes_max());
    notify_service("READY=1");
    is_connected_ = true;
    const auto since = std::chrono::steady_clock::now();
    SessionEnd how = SessionEnd::Lost;
    std::shared_ptr<Session> session = session_;
    if (welcome.is_resumed && session != nullptr) {
        how = co_await session->resume(channel);
    } else {
        if (session != nullptr) {
            session->leave();
        }
        session_id_ = welcome.id;
        epoch_ = welcome.epoch;
        times_ = SessionTimes::of(welcome);
        silence_borne_ = times_.silent_after;
        keep_->enter(welcome.cluster);
        peers.key = welcome.peer_key;
        session_ = session =
            std::make_shared<Session>(channel, executor_, keep_, std::move(peers), times_);
        if (is_draining_) {
            session->stop();
        }
        how = co_await session->run();
    }
    is_connected_ = false;
    learn_from(session->link().met_silence(), std::chrono::steady_clock::now() - since);
    Served served{how, session->link().reason()};
    if (how == SessionEnd::Disagreed) {
        session_.reset();
    }
    co_return served;
}

bool Membership::drain(std::chrono::milliseconds timeout, std::function<void()> out_of_time) {
    is_draining_ = true;
    if (session_ != nullptr) {
        session_->stop();
    }
    if (!is_connected_ && !has_work()) {
        return false;
    }
    const std::chrono::milliseconds at_most = timing::results_kept_wait_max;
    const std::chrono::milliseconds last = std::min(at_most, timeout / 2);
    spawn(executor_.home(), "drain", watch_drain(timeout - last, last, std::move(out_of_time)));
    return true;
}

asio::awaitable<void> Membership::watch_drain(std::chrono::milliseconds to_finish,
                                              std::chrono::milliseconds last,
                                              std::function<void()> out_of_time) {
    boost::system::error_code error;
    drain_timer_.expires_after(to_finish);
    co_await drain_timer_.async_wait(asio::redirect_error(asio::use_awaitable, error));
    if (error) {
        co_return; // The session has ended.
    }
    if (session_ != nullptr) {
        session_->hand_back();
    }
    drain_timer_.expires_after(last);
    co_await drain_timer_.async_wait(asio::redirect_error(asio::use_awaitable, error));
    if (!error) {
        log_warning("drain timed out: results_not_acknowledged={}",
                    keep_->results.messages().size());
        end();
        log_unkept();
        out_of_time();
    }
}

bool Membership::has_work() const {
    return (session_ != nullptr && session_->has_tasks()) || !keep_->results.empty();
}

void Membership::log_unkept() const {
    for (const auto& [job, lost] : keep_->results.by_job()) {
        log_warning("results that no master took: job={} scenarios={} compute_seconds={:.3f}",
                    job.value,
                    lost.scenarios,
                    lost.compute_seconds);
    }
}

void Membership::end() {
    drain_timer_.cancel();
    if (session_ != nullptr) {
        session_->leave();
        session_.reset();
    }
}

} // namespace cd
