#include "worker/session/task_runner.hpp"

#include "common/core/host/log.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <utility>

namespace cd {

TaskRunner::TaskRunner(SessionHub& hub,
                       MasterLink& master,
                       BlockInbox& blocks,
                       std::shared_ptr<std::atomic<std::uint64_t>> computed)
    : hub_(hub),
      master_(master),
      blocks_(blocks),
      computed_(std::move(computed)),
      joiner_(hub, blocks.cache()),
      flush_timer_(hub.home()) {}

void TaskRunner::stop() {
    if (std::exchange(stopping_, true)) {
        return;
    }
    log_info("draining: running={} unanswered={}", running_, book_.unanswered());
    master_.send(Drain{});
    drop_unstarted([](const Task&) { return true; });
    hub_.settle_soon();
}

void TaskRunner::hand_back() {
    log_warning("not drained in time: running={} unanswered={}", running_, book_.unanswered());
    abandon([](const Task&) { return true; });
    hub_.settle_soon();
}

void TaskRunner::leave() {
    flush_timer_.cancel();
    flush_all();
}

// ---- Messages from the master ---------------------------------------------------------------

Status TaskRunner::add_job(AddJob add) {
    const auto job = book_.add_job(std::move(add), blocks_.cache());
    if (!job) {
        return job.error();
    }
    blocks_.add_job(*job.value());
    return Done{};
}

void TaskRunner::remove_job(JobId job) {
    abandon([job](const Task& task) { return task.job().id == job; });
    book_.remove_job(job);
    blocks_.remove_job(job);
    hub_.settle_soon();
}

void TaskRunner::remove_jobs_of(TreeId tree) {
    abandon([tree](const Task& task) { return task.job().uses(tree); });
    book_.remove_jobs_of(tree);
}

Status TaskRunner::add(WorkUnit unit) {
    const bool is_analysed = unit.is_analysed();
    const std::chrono::milliseconds results_wait(unit.results_wait_ms);
    const Result<Task*> added = book_.add(std::move(unit), blocks_.cache());
    if (!added) {
        return added.error();
    }
    Task& task = *added.value();
    hub_.set_results_wait(results_wait);
    if (stopping_ && is_analysed) {
        task.drop(task.scenario_count());
    } else if (stopping_) {
        task.drop_unwalked();
    } else if (is_analysed) {
        for (std::size_t scenario = 0; scenario < task.scenario_count(); ++scenario) {
            wait_for_subtrees(task, scenario);
        }
    } else {
        blocks_.need_tops(task.job().id, task.trees());
    }
    hub_.settle_soon();
    return Done{};
}

void TaskRunner::recall(const Recall& recall) {
    Task* const task = book_.find(recall.task);
    if (task == nullptr) {
        return; // The task has ended, and its EndOfTask is in transit.
    }
    const std::vector<Entry> dropped = drop_unbegun([&](const Entry& entry) {
        return entry.task == recall.task && task->is_recalled(entry.scenario, recall);
    });
    for (const Entry& entry : dropped) {
        task->give_back(task->index_of(entry.scenario));
    }
    task->keep_first(recall.kept);
    const Recalled recalled = task->given_back();
    log_debug("recalled: task={} scenarios={} places_kept={}",
              recall.task.value,
              recalled.scenarios.size(),
              recalled.kept);
    master_.send(recalled);
    hub_.settle_soon();
}

void TaskRunner::drop(const DropScenario& drop) {
    const auto job = book_.job(drop.job);
    if (job != nullptr && drop.task == TaskId{}) {
        log_info("scenario dropped: job={} scenario={}", drop.job.value, drop.scenario);
        job->dropped->add(drop.scenario);
        return;
    }
    Task* const task = book_.find(drop.task);
    if (job == nullptr || task == nullptr) {
        return;
    }
    task->answered_elsewhere()->add(drop.scenario);
    drop_unbegun([&](const Entry& entry) {
        return entry.task == drop.task && task->index_of(entry.scenario) == drop.scenario;
    });
    hub_.settle_soon();
}

// ---- Dropping scenarios ---------------------------------------------------------------------

std::vector<ScenarioQueue::Entry>
TaskRunner::drop_unbegun(const std::function<bool(const Entry&)>& concerned) {
    std::vector<Entry> dropped = queue_.drop_unbegun(concerned);
    for (const Entry& entry : dropped) {
        book_.at(entry.task).drop();
        blocks_.release(entry.token);
    }
    return dropped;
}

void TaskRunner::drop_unstarted(const std::function<bool(const Task&)>& concerned) {
    drop_unbegun([&](const Entry& entry) { return concerned(book_.at(entry.task)); });
    for (auto& [id, task] : book_.tasks()) {
        if (concerned(task)) {
            task.drop_unwalked();
        }
    }
}

void TaskRunner::abandon(const std::function<bool(const Task&)>& concerned) {
    drop_unstarted(concerned);
    for (auto& [id, task] : book_.tasks()) {
        if (concerned(task)) {
            task.abandon(); // Running scenarios stop soon, without a result.
        }
    }
}

// ---- Scheduling -----------------------------------------------------------------------------

void TaskRunner::wait_for_subtrees(const Task& task, std::size_t scenario) {
    blocks_.need(queue_.add(task.id(), scenario), task.job().id, task.roots_of(scenario));
}

bool TaskRunner::settle(std::span<const ScenarioQueue::Token> ready) {
    queue_.set_ready(ready);
    const std::size_t running_max = limits::jobs_per_thread_max * hub_.threads();
    bool is_more_ready = true;
    while (is_more_ready && running_ < running_max && master_.takes_results()) {
        is_more_ready = start_next();
    }
    if (flushing_soon_ && running_ < hub_.threads()) {
        flush_after(timing::results_wait_idle);
    }
    return end_finished_tasks();
}

bool TaskRunner::start_next() {
    if (const std::optional<Entry> entry = queue_.begin_next()) {
        start(*entry);
        return true;
    }
    Task* const task = queue_.size() < limits::walked_waiting_max ? next_to_walk() : nullptr;
    if (task != nullptr) {
        start_walk(*task, task->next_walk(blocks_.cache(), hub_.threads()));
    }
    return task != nullptr;
}

Task* TaskRunner::next_to_walk() {
    for (auto& [id, task] : book_.tasks()) {
        if (task.has_unwalked() && blocks_.has_tops(task.trees())) {
            return &task;
        }
    }
    return nullptr;
}

void TaskRunner::start(const Entry& entry) {
    const Task& task = book_.at(entry.task);
    if (task.walks_again(entry.scenario)) {
        return start_walk(task, task.walk_of(entry.scenario, blocks_.cache()), entry);
    }
    ++running_;
    hub_.run_on_thread([this,
                        over = hub_.over(),
                        abandoned = task.abandoned(),
                        has_begun = entry.has_begun,
                        clock = clocks_.add(task.job().id),
                        dropped = task.job().dropped,
                        answered = task.answered_elsewhere(),
                        token = entry.token,
                        computed = computed_,
                        ready = std::make_shared<const ReadyScenario>(
                            task.ready(entry.scenario, blocks_.cache()))] {
        const std::uint64_t index = ready->scenario.index;
        const auto stop = [&] {
            return over->load() || abandoned->load() || dropped->contains(index) ||
                   answered->contains(index);
        };
        std::optional<FinishedScenarios> finished;
        if (!has_begun->exchange(true)) {
            clock->begin(index);
            finished = execute(*ready, stop);
            *computed += finished ? finished->count : 0;
        }
        return [this, token, finished = std::move(finished)] { scenario_ran(token, finished); };
    });
}

void TaskRunner::start_walk(const Task& task, Walk next, const Entry& entry) {
    joiner_.prepare(next);
    ++running_;
    hub_.run_on_thread([this,
                        over = hub_.over(),
                        abandoned = task.abandoned(),
                        clock = clocks_.add(task.job().id),
                        id = task.id(),
                        computed = computed_,
                        entry,
                        part = std::make_shared<const Walk>(std::move(next))] {
        const auto stop = [&] { return over->load() || abandoned->load(); };
        const auto found = std::make_shared<Walked>();
        if (entry.has_begun == nullptr || !entry.has_begun->exchange(true)) {
            *found = walk(*part, stop, *clock);
            *computed += found->finished.count;
        }
        return [this, id, token = entry.token, found] { walked(id, token, std::move(*found)); };
    });
}

// ---- Results from the threads ---------------------------------------------------------------

void TaskRunner::scenario_ran(ScenarioQueue::Token token,
                              const std::optional<FinishedScenarios>& finished) {
    --running_;
    hub_.settle_soon();
    const std::optional<Entry> entry = queue_.finish(token);
    if (!entry) {
        return; // The scenario was dropped before it began.
    }
    Task& task = book_.at(entry->task);
    blocks_.release(token);
    if (finished) {
        add_results(task, *finished);
    } else {
        task.drop();
    }
}

void TaskRunner::walked(TaskId id, ScenarioQueue::Token token, Walked walked) {
    --running_;
    hub_.settle_soon();
    const bool is_one = token != ScenarioQueue::Token{};
    if (is_one && !queue_.finish(token)) {
        return; // The scenario was dropped before it began.
    }
    Task& task = book_.at(id);
    blocks_.found(task.job().id, walked);
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
    if (is_one) {
        blocks_.release(token);
    }
    add_results(task, walked.finished);
}

void TaskRunner::add_results(Task& task, const FinishedScenarios& finished) {
    task.add(finished);
    if (task.result_bytes() >= limits::results_flush_bytes) {
        flush(task);
    } else {
        flush_after(hub_.results_wait());
    }
}

void TaskRunner::flush_after(std::chrono::milliseconds wait) {
    const auto due = std::chrono::steady_clock::now() + wait;
    if (flushing_soon_ && flush_timer_.expiry() <= due) {
        return;
    }
    flushing_soon_ = true;
    flush_timer_.expires_at(due); // Cancels the wait for a later time.
    flush_timer_.async_wait(
        [this, weak = hub_.weak_from_this()](const boost::system::error_code& error) {
            const auto hub = weak.lock();
            if (hub != nullptr && !error) {
                flushing_soon_ = false;
                flush_all();
            }
        });
}

void TaskRunner::flush(Task& task) {
    if (auto results = task.take_results(master_.is_within_host())) {
        results->traffic = blocks_.take_traffic(task.job().id);
        master_.send_results(std::move(*results));
    }
}

void TaskRunner::flush_all() {
    for (auto& [id, task] : book_.tasks()) {
        flush(task);
    }
}

bool TaskRunner::end_finished_tasks() {
    const bool had_tasks = book_.has_tasks();
    for (auto task = book_.tasks().begin(); task != book_.tasks().end();) {
        if (task->second.unanswered() != 0) {
            ++task;
            continue;
        }
        flush(task->second);
        master_.send(EndOfTask{task->first});
        log_debug("task done: task={}", task->first.value);
        task = book_.tasks().erase(task);
    }
    return had_tasks && !book_.has_tasks();
}

} // namespace cd
