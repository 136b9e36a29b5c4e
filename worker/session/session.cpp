#include "worker/session/session.hpp"

#include "common/core/host/log.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/codec/codec.hpp"

#include <utility>

namespace cd {

namespace {

Error came_twice(TaskId task) {
    return {ErrorCode::BadFrame, "task " + std::to_string(task.value) + " came twice"};
}

} // namespace

Session::Session(std::shared_ptr<Channel> channel,
                 Executor& executor,
                 std::uint64_t cache_bytes,
                 PeerParts peers,
                 std::shared_ptr<WorkerKeep> keep,
                 const SessionTimes& times)
    : channel_(std::move(channel)),
      executor_(executor),
      keep_(keep == nullptr ? std::make_shared<WorkerKeep>(cache_bytes) : std::move(keep)),
      cache_(std::exchange(keep_->cache, SubtreeCache(cache_bytes))),
      fetcher_(cache_),
      peers_(std::move(peers)),
      links_(peers_.name, peers_.tls),
      times_(times),
      abandoned_(std::make_shared<std::atomic<bool>>(false)),
      heartbeat_timer_(executor_.home()),
      flush_timer_(executor_.home()) {}

Session::~Session() {
    abandoned_->store(true);
}

void Session::stop() {
    if (stopping_) {
        return;
    }
    stopping_ = true;
    log_info("draining: running={} unanswered={}", running_, unanswered());
    channel_->send(Drain{});
    drop_unstarted([](const Task&) { return true; });
    settle_soon();
}

void Session::hand_back() {
    log_warning("not drained in time: running={} unanswered={}", running_, unanswered());
    abandon([](const Task&) { return true; });
    settle_soon();
}

std::size_t Session::let_go(std::uint64_t bytes) {
    const std::size_t gone = cache_.let_go(bytes);
    settle_soon();
    return gone;
}

// ---- Messages from the master ---------------------------------------------------------------

Status Session::handle(AddTree& add) {
    Status added = cache_.add_tree(add);
    if (added) {
        std::vector<RootIndex> held = cache_.held(add.tree);
        log_info("tree added: tree={} roots={} held={}", add.tree.value, add.roots, held.size());
        if (!held.empty()) {
            channel_->send(Held{add.tree, std::move(held)});
        }
    }
    return added;
}

Status Session::handle(RemoveTree& remove) {
    const TreeId tree = remove.tree;
    abandon([tree](const Task& task) { return task.job().uses(tree); });
    std::erase_if(jobs_, [tree](const auto& job) { return job.second->uses(tree); });
    fetcher_.forget_requests(tree);
    traffic_.tree_removed(tree);
    cache_.remove_tree(tree);
    log_info("tree removed: tree={} cached_bytes={}", tree.value, cache_.bytes());
    settle_soon();
    return Done{};
}

Status Session::handle(AddJob& add) {
    const JobId id = add.job;
    Result<std::shared_ptr<const WorkerJob>> job = make_worker_job(std::move(add), cache_);
    if (!job) {
        return job.error();
    }
    if (!jobs_.emplace(id, std::move(job.value())).second) {
        return Error{ErrorCode::BadFrame, "job " + std::to_string(id.value) + " was added already"};
    }
    traffic_.job_added(id);
    return Done{};
}

Status Session::handle(RemoveJob& remove) {
    const JobId id = remove.job;
    abandon([id](const Task& task) { return task.job().id == id; });
    jobs_.erase(id);
    traffic_.job_removed(id);
    settle_soon();
    return Done{};
}

Status Session::handle(Subtrees& subtrees) {
    for (SubtreeBlock& block : subtrees.blocks) {
        traffic_.came_from_master({subtrees.tree, block.root}, block.compressed.size());
        open_soon(subtrees.tree, std::move(block), {});
    }
    return Done{};
}

Status Session::handle(FetchFromPeers& directions) {
    spawn(executor_.home(),
          "blocks from peers",
          fetch_from_peers(shared_from_this(), std::move(directions)));
    return Done{};
}

Status Session::handle(Batch& batch) {
    const auto job = find_job(batch.task, batch.job);
    if (!job) {
        return job.error();
    }
    Result<Task> made = Task::make(std::move(batch), job.value(), cache_);
    if (!made) {
        return made.error();
    }
    const TaskId id = made.value().id();
    Task* const task = take_task(std::move(made.value()));
    if (task == nullptr) {
        return came_twice(id);
    }
    for (std::size_t scenario = 0; scenario < task->scenario_count(); ++scenario) {
        wait_for_subtrees(*task, scenario);
    }
    if (stopping_) {
        drop_unstarted([id](const Task& candidate) { return candidate.id() == id; });
    }
    settle_soon();
    return Done{};
}

Status Session::handle(ScenarioRange& range) {
    const auto job = find_job(range.task, range.job);
    if (!job) {
        return job.error();
    }
    Result<Task> made = Task::make(range, job.value());
    if (!made) {
        return made.error();
    }
    Task* const task = take_task(std::move(made.value()));
    if (task == nullptr) {
        return came_twice(range.task);
    }
    if (stopping_) {
        task->drop_unwalked();
    } else {
        want_tops(task->job());
    }
    settle_soon();
    return Done{};
}

Result<std::shared_ptr<const WorkerJob>> Session::find_job(TaskId task, JobId job) const {
    const auto found = jobs_.find(job);
    if (found == jobs_.end()) {
        return Error{ErrorCode::BadFrame,
                     "task " + std::to_string(task.value) + " names a job that is not here"};
    }
    return found->second;
}

Task* Session::take_task(Task task) {
    const TaskId id = task.id();
    const auto [place, is_new] = tasks_.emplace(id, std::move(task));
    return is_new ? &place->second : nullptr;
}

void Session::wait_for_subtrees(const Task& task, std::size_t scenario) {
    const Token token = next_token_++;
    places_.emplace(token, Place{task.id(), scenario, nullptr});
    fetcher_.add(token, task.roots_of(scenario));
}

Status Session::handle(ResultsKept& kept) {
    keep_->results.kept(kept.sequences);
    settle_soon(); // There may be room for more results, or the drain may be over.
    return Done{};
}

/// Handles the answer to this worker's own Drain, or the master's request to leave.
Status Session::handle(Drain& /*drain*/) {
    log_debug("draining: nothing more comes from the master");
    draining_ = true;
    stop();
    settle_soon();
    return Done{};
}

Status Session::handle(Terminate& terminate) {
    log_info("terminated by the master: reason=\"{}\"", terminate.reason);
    end_ = SessionEnd::Terminated;
    channel_->close();
    return Done{};
}

Status Session::handle(Heartbeat& /*heartbeat*/) {
    return Done{};
}

Status Session::handle(Failure& failure) {
    reason_ = "the master says: " + failure.detail;
    end_ = SessionEnd::Disagreed;
    channel_->close();
    return Done{};
}

template <class T>
Status Session::handle(T& message) {
    const std::uint16_t type = message_type(Message(std::move(message)));
    return Error{ErrorCode::BadFrame,
                 "message '" + std::string(message_name(type)) + "' is not for a worker"};
}

Status Session::handle(Message& message) {
    return std::visit([this](auto& content) { return handle(content); }, message);
}

void Session::refuse(const Error& error) {
    log_error("disagreement with the master: error=\"{}\"", error.detail);
    reason_ = error.detail;
    end_ = SessionEnd::Disagreed;
    Failure failure;
    failure.code = error.code;
    failure.detail = error.detail;
    channel_->send(failure);
    channel_->close(true);
}

// ---- Results --------------------------------------------------------------------------------

void Session::flush_soon() {
    if (std::exchange(flushing_soon_, true)) {
        return;
    }
    flush_timer_.expires_after(limits::results_flush_period);
    flush_timer_.async_wait([weak = weak_from_this()](const boost::system::error_code& error) {
        const auto session = weak.lock();
        if (session != nullptr) {
            session->flushing_soon_ = false;
            if (!error) {
                session->flush_all();
            }
        }
    });
}

void Session::flush(Task& task) {
    if (auto results = task.take_results()) {
        results->traffic = traffic_.take(task.job().id);
        keep_->results.add(*results);
        channel_->send(*results);
    }
}

void Session::flush_all() {
    for (auto& [id, task] : tasks_) {
        flush(task);
    }
}

void Session::end_finished_tasks() {
    for (auto task = tasks_.begin(); task != tasks_.end();) {
        if (task->second.unanswered() != 0) {
            ++task;
            continue;
        }
        flush(task->second);
        channel_->send(EndOfTask{task->first});
        log_debug("task done: task={}", task->first.value);
        task = tasks_.erase(task);
        if (tasks_.empty()) {
            send_heartbeat(); // The master then has the final counts of a job that ends.
        }
    }
}

} // namespace cd
