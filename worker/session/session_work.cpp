// Schedules a session's scenarios on the worker's threads and collects their results.
#include "common/core/host/log.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "worker/session/session.hpp"

#include <utility>

namespace cd {

// ---- Results from the threads ---------------------------------------------------------------

void Session::scenario_ran(Token token, const std::optional<FinishedScenarios>& finished) {
    if (abandoned_->load()) {
        return; // The session is over.
    }
    --running_;
    const auto place = places_.find(token);
    if (place == places_.end()) {
        return settle_soon(); // The scenario was returned before it began.
    }
    Task& task = tasks_.at(place->second.task);
    places_.erase(place);
    fetcher_.finished(token);
    if (finished) {
        add_results(task, *finished);
    } else {
        task.drop();
    }
    settle_soon();
}

void Session::walked(TaskId id, Walked walked) {
    if (abandoned_->load()) {
        return; // The session is over.
    }
    --running_;
    Task& task = tasks_.at(id);
    for (const SubtreeKey& key : walked.used) {
        cache_.touch(key);
    }
    traffic_.found(task.job().id, walked.found);
    task.drop(walked.left);
    if (stopping_ || task.abandoned()->load()) {
        task.drop(walked.waiting.size());
    } else {
        for (Walked::Waiting& waiting : walked.waiting) {
            const std::size_t scenario = waiting.scenario;
            task.keep_roots(std::move(waiting));
            wait_for_subtrees(task, scenario);
        }
    }
    add_results(task, walked.finished);
    settle_soon();
}

void Session::add_results(Task& task, const FinishedScenarios& finished) {
    task.add(finished);
    if (task.result_bytes() >= limits::results_flush_bytes) {
        flush(task);
    } else {
        flush_soon();
    }
}

// ---- Scheduling -----------------------------------------------------------------------------

// Posts one `settle` for all events that arrive together.
void Session::settle_soon() {
    if (std::exchange(settling_, true)) {
        return;
    }
    asio::post(executor_.home(), [weak = weak_from_this()] {
        if (const auto session = weak.lock()) {
            session->settling_ = false;
            session->settle();
        }
    });
}

void Session::settle() {
    if (abandoned_->load() || end_ != SessionEnd::Lost) {
        return;
    }
    const Fetcher::Step step = fetcher_.advance();
    note_asked(step);
    // Evicted goes first, so that the master does not apply it to the blocks requested next.
    send_evicted();
    send_held();
    send_wants(step.want);
    ready_.insert(ready_.end(), step.ready.begin(), step.ready.end());
    start_ready();
    end_finished_tasks();
    end_when_drained();
}

/// Ends the session once the master has written the last results to disk.
void Session::end_when_drained() {
    if (draining_ && tasks_.empty() && keep_->results.empty() && channel_->is_open()) {
        end_ = SessionEnd::Drained;
        channel_->close(true);
    }
}

void Session::start_ready() {
    const std::size_t running_max = limits::jobs_per_thread_max * executor_.threads();
    while (running_ < running_max && keep_->results.has_room()) {
        // Computes no more results while the master does not read the queued ones.
        if (channel_->queued_bytes() >= limits::write_queue_bytes_max) {
            if (!std::exchange(waiting_for_queue_, true)) {
                spawn(executor_.home(), "resume", resume_when_sent(shared_from_this()));
            }
            return;
        }
        if (!start_next()) {
            return;
        }
    }
}

bool Session::start_next() {
    if (!ready_.empty()) {
        const Token token = ready_.front();
        ready_.pop_front();
        start(token);
        return true;
    }
    Task* const task = places_.size() < limits::walked_waiting_max ? next_to_walk() : nullptr;
    if (task != nullptr) {
        start_walk(*task);
    }
    return task != nullptr;
}

Task* Session::next_to_walk() {
    for (auto& [id, task] : tasks_) {
        if (task.has_unwalked() && has_tops(task.job())) {
            return &task;
        }
    }
    return nullptr;
}

asio::awaitable<void> Session::resume_when_sent(std::shared_ptr<Session> self) {
    co_await self->channel_->wait_until_queued_below(limits::write_queue_bytes_max / 2);
    self->waiting_for_queue_ = false;
    self->settle_soon();
}

void Session::start(Token token) {
    Place& place = places_.at(token);
    const Task& task = tasks_.at(place.task);
    place.has_begun = std::make_shared<std::atomic<bool>>(false);
    ++running_;
    executor_.submit(
        [weak = weak_from_this(),
         abandoned = abandoned_,
         task_abandoned = task.abandoned(),
         has_begun = place.has_begun,
         clock = new_clock(task.job().id),
         dropped = task.job().dropped,
         answered = task.answered_elsewhere(),
         token,
         computed = keep_->computed,
         ready = std::make_shared<const ReadyScenario>(task.ready(place.scenario, cache_))]() {
            if (abandoned->load()) {
                return Executor::Continuation([] {});
            }
            const std::uint64_t index = ready->scenario.index;
            const auto stop = [&] {
                return abandoned->load() || task_abandoned->load() || dropped->contains(index) ||
                       answered->contains(index);
            };
            if (has_begun->exchange(true)) {
                return Executor::Continuation([weak, token] {
                    if (const auto session = weak.lock()) {
                        session->scenario_ran(token, std::nullopt);
                    }
                });
            }
            clock->begin(index);
            auto finished = execute(*ready, stop);
            *computed += finished ? finished->count : 0;
            return Executor::Continuation([weak, token, finished = std::move(finished)] {
                if (const auto session = weak.lock()) {
                    session->scenario_ran(token, finished);
                }
            });
        });
}

std::shared_ptr<ScenarioClock> Session::new_clock(JobId job) {
    std::erase_if(clocks_, [](const auto& clock) { return clock.expired(); });
    auto clock = std::make_shared<ScenarioClock>(job);
    clocks_.push_back(clock);
    return clock;
}

void Session::start_walk(Task& task) {
    ++running_;
    const auto stop = [abandoned = abandoned_, task_abandoned = task.abandoned()] {
        return abandoned->load() || task_abandoned->load();
    };
    const auto part = std::make_shared<const Walk>(task.next_walk(cache_, executor_.threads()));
    executor_.submit([weak = weak_from_this(),
                      abandoned = abandoned_,
                      clock = new_clock(task.job().id),
                      id = task.id(),
                      stop,
                      computed = keep_->computed,
                      part] {
        if (abandoned->load()) {
            return Executor::Continuation([] {});
        }
        auto found = std::make_shared<Walked>(walk(*part, stop, *clock));
        *computed += found->finished.count;
        return Executor::Continuation([weak, id, found] {
            if (const auto session = weak.lock()) {
                session->walked(id, std::move(*found));
            }
        });
    });
}

} // namespace cd
