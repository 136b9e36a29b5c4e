// Worker presence: joining, returning, silence and leaving.
#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/coordinator/coordinator.hpp"

#include <algorithm>

namespace cd {

namespace {

bool names(const std::vector<JobId>& list, JobId one) {
    return std::find(list.begin(), list.end(), one) != list.end();
}

bool names(const std::vector<Recalled>& list, TaskId one) {
    return std::ranges::find(list, one, &Recalled::task) != list.end();
}

WorkerProcess number_in(const Sha256& hash) {
    return std::max<WorkerProcess>(1, ByteReader(hash.bytes).get<WorkerProcess>());
}

WorkerProcess random_process() {
    return number_in(random_secret());
}

WorkerProcess number_of(const std::string& text) {
    return number_in(sha256(std::as_bytes(std::span(text))));
}

/// A worker that sends no instance id gets a random one. For a certified worker the id is hashed
/// with its certificate holder, so nobody can impersonate another holder's process.
WorkerProcess process_that_greets(const Hello& hello, const std::string& holder) {
    if (hello.instance == 0) {
        return random_process();
    }
    return holder.empty() ? hello.instance
                          : number_of("process " + std::to_string(hello.instance) + " " + holder);
}

/// All roots below `count` that are not in `held`, which ascends.
std::vector<RootIndex> others(std::uint32_t count, const std::vector<RootIndex>& held) {
    std::vector<RootIndex> all;
    auto next = held.begin();
    for (RootIndex root = 0; root < count; ++root) {
        if (next != held.end() && *next == root) {
            ++next;
        } else {
            all.push_back(root);
        }
    }
    return all;
}

} // namespace

// ---- Joining and returning --------------------------------------------------------------------

Reception Coordinator::receive_worker(const Hello& hello, const std::string& holder) {
    const WorkerId before{hello.session};
    const auto link = workers_.find(before);
    const bool is_of_this_life = hello.epoch == epoch_ || mutated(Mutation::OldEpochTaken);
    if (is_of_this_life && link != workers_.end() && !link->second.is_cut_off &&
        link->second.instance == hello.instance && link->second.author->holder == holder) {
        return {before, link->second.key, true};
    }
    return {WorkerId{++worker_last_}, random_secret(), false};
}

void Coordinator::worker_joined(const Reception& reception,
                                const Hello& hello,
                                std::shared_ptr<Channel> channel) {
    const WorkerId worker = reception.worker;
    if (reception.is_resumed) {
        return worker_returned(worker, std::move(channel));
    }
    const auto& certified = channel->peer_identity();
    const std::string holder = certified ? certified->name : "";
    const WorkerProcess process = process_that_greets(hello, holder);
    end_earlier_sessions(process);
    log_info("worker joined: worker={} name={} holder=\"{}\" threads={} cache_bytes={} peer={}",
             worker.value,
             hello.name,
             holder,
             hello.threads,
             hello.cache_bytes,
             channel->peer());
    WorkerLink link;
    link.channel = channel;
    link.key = reception.key;
    link.author = std::make_shared<const Author>(Author{process, worker, hello.name, holder});
    link.threads = std::max(1u, hello.threads);
    link.cache_bytes = hello.cache_bytes;
    link.instance = hello.instance;
    link.quarantined = alarms_.is_quarantined(process);
    const bool is_trusted = !link.quarantined;
    workers_.emplace(worker, std::move(link));
    watch_.joined(worker, Clock::now());
    if (watch_timer_ == nullptr && !closed_) {
        watch_timer_ = std::make_shared<asio::steady_timer>(parts_.executor);
        spawn(parts_.executor, "watch over workers", watch_workers());
    }
    if (!is_trusted) {
        log_error("worker stays in quarantine: worker={} name={}", worker.value, hello.name);
        return;
    }
    blocks_.worker_joined(worker, std::move(channel), reception.key, hello.peer_port);
    act(dispatcher().worker_joined(
        worker,
        {hello.name, std::max(1u, hello.threads), hello.weight, hello.cache_bytes, process}));
    feed();
}

std::shared_ptr<WorkerIntake> Coordinator::intake_of(WorkerId worker) {
    std::erase_if(intakes_, [](const auto& intake) { return intake.second.expired(); });
    std::weak_ptr<WorkerIntake>& known = intakes_[workers_.at(worker).author->process];
    std::shared_ptr<WorkerIntake> intake = known.lock();
    if (intake == nullptr) {
        intake = std::make_shared<WorkerIntake>();
        known = intake;
    }
    return intake;
}

void Coordinator::end_earlier_sessions(WorkerProcess process) {
    std::vector<WorkerId> earlier;
    for (const auto& [id, link] : workers_) {
        if (link.author->process == process) {
            earlier.push_back(id);
        }
    }
    for (const WorkerId id : earlier) {
        // The process is alive, so its tasks did not kill it; they may never have arrived.
        take_all_back(id);
        worker_lost(id, "it has begun another session");
    }
    for (auto lost = lost_.begin(); lost != lost_.end();) {
        if (lost->second.process == process) {
            watch_.left(lost->first);
            lost = lost_.erase(lost);
        } else {
            ++lost;
        }
    }
}

void Coordinator::take_all_back(WorkerId worker) {
    std::vector<TaskId> given;
    for (const auto& [task, running] : tasks_) {
        if (running.worker == worker) {
            given.push_back(task);
        }
    }
    act(dispatcher().worker_draining(worker)); // Otherwise the worker would get some of it again.
    for (const TaskId task : given) {
        act(dispatcher().task_unbegun(worker, task));
    }
}

void Coordinator::worker_returned(WorkerId worker, std::shared_ptr<Channel> channel) {
    const auto link = workers_.find(worker);
    if (link == workers_.end()) {
        return channel->close(); // The worker was lost since its Hello.
    }
    log_info("worker came back: worker={} name={} peer={}",
             worker.value,
             link->second.author->name,
             channel->peer());
    ++sessions_resumed_;
    link->second.channel->close();
    link->second.channel = channel;
    link->second.is_settled = false;
    watch_.heard(worker, Clock::now());
    act(dispatcher().worker_silent(worker)); // Ends when its Standing arrives.
    blocks_.worker_returned(worker, std::move(channel));
}

void Coordinator::worker_stands(WorkerId worker, const Standing& standing) {
    const auto link = workers_.find(worker);
    if (link == workers_.end()) {
        return;
    }
    if (link->second.is_settled) { // The session is new.
        awaited_.has_told_all(link->second.author->process);
        return feed();
    }
    if (const Status sound = check_standing(standing); !sound) {
        return cut_off(worker, sound.error());
    }
    link->second.is_settled = true;
    take_lost_trees(worker, link->second, standing);
    take_lost_jobs(link->second, standing);
    if (!link->second.quarantined) {
        add_held_trees(link->second);
    }
    take_lost_tasks(worker, standing);
    act(dispatcher().worker_heard(worker));
    if (dispatcher_.worker_status(worker).draining) {
        link->second.channel->send(Drain{}); // The first may have been lost with a connection.
    }
    feed();
}

Status Coordinator::check_standing(const Standing& standing) const {
    for (const StandingTree& tree : standing.trees) {
        const auto geometry = trees_.find(tree.tree);
        if (geometry != nullptr && !geometry->has_blocks(tree.held)) {
            return Error{ErrorCode::BadFrame, "it speaks of a root that does not exist"};
        }
    }
    return Done{};
}

/// Compares the worker's trees with the master's record. Missing ones are sent again when needed;
/// unexpected ones are removed.
void Coordinator::take_lost_trees(WorkerId worker, WorkerLink& link, const Standing& standing) {
    std::set<TreeId> there;
    for (const StandingTree& tree : standing.trees) {
        there.insert(tree.tree);
        const auto geometry = trees_.find(tree.tree);
        if (geometry == nullptr || !link.trees.contains(tree.tree)) {
            link.channel->send(RemoveTree{tree.tree});
            continue;
        }
        blocks_held(worker, Held{tree.tree, tree.held});
        const auto gone = others(geometry->root_count(), tree.held);
        act(dispatcher().roots_evicted(worker, tree.tree, gone));
    }
    std::erase_if(link.trees, [&](TreeId tree) { return !there.contains(tree); });
}

void Coordinator::take_lost_jobs(WorkerLink& link, const Standing& standing) {
    for (const JobId job : standing.jobs) {
        if (!link.jobs.contains(job)) {
            link.channel->send(RemoveJob{job});
        } else if (const MasterJob* running = jobs_.find_running(job)) {
            for (const std::uint64_t scenario : running->cancelled) {
                link.channel->send(DropScenario{job, scenario});
            }
        }
    }
    std::erase_if(link.jobs, [&](JobId job) { return !names(standing.jobs, job); });
}

/// A missing task never arrived or has ended; in the latter case its results arrived before. For a
/// present task, a return of work may have been lost, so it is processed again.
void Coordinator::take_lost_tasks(WorkerId worker, const Standing& standing) {
    for (const Recalled& task : standing.tasks) {
        task_recalled(worker, task);
    }
    std::vector<TaskId> missing;
    for (const auto& [id, task] : tasks_) {
        if (task.worker == worker && !names(standing.tasks, id)) {
            missing.push_back(id);
        }
    }
    for (const TaskId id : missing) {
        RunningTask& task = tasks_.at(id);
        task.unbegun = !task.ended;
        task.ended = true;
        end_task_if_complete(id);
    }
}

// ---- Silence ----------------------------------------------------------------------------------

bool Coordinator::is_its_channel(WorkerId worker, const Channel& channel) const {
    const auto link = workers_.find(worker);
    return link != workers_.end() && link->second.channel.get() == &channel;
}

bool Coordinator::worker_heard(WorkerId worker, const Channel& channel) {
    if (!is_its_channel(worker, channel)) {
        return false;
    }
    note_life(worker);
    return true;
}

void Coordinator::note_life(WorkerId worker) {
    if (!watch_.heard(worker, Clock::now())) {
        return;
    }
    log_info("worker is heard again: worker={}", worker.value);
    if (workers_.at(worker).is_settled) {
        act(dispatcher().worker_heard(worker));
        feed();
    }
}

/// Counts received bytes as a sign of life, since a large message arrives slowly.
void Coordinator::hear_bytes() {
    std::vector<WorkerId> heard;
    for (auto& [id, link] : workers_) {
        const std::uint64_t bytes = link.channel->traffic().bytes_received;
        if (std::exchange(link.bytes_seen, bytes) != bytes && link.channel->is_open()) {
            heard.push_back(id);
        }
    }
    for (const WorkerId worker : heard) {
        note_life(worker);
    }
}

void Coordinator::worker_unheard(WorkerId worker, const Channel& channel) {
    if (is_its_channel(worker, channel)) {
        watch_.unheard(worker);
    }
}

void Coordinator::connection_ended(WorkerId worker,
                                   const Channel& channel,
                                   const std::string& why) {
    if (closed_ || !is_its_channel(worker, channel)) {
        return;
    }
    const auto link = workers_.find(worker);
    const WorkerStatus status = dispatcher_.worker_status(worker);
    const bool is_cut_off = link->second.is_cut_off;
    const bool is_drained = status.draining && status.working == 0 && !is_cut_off;
    if (is_drained || link->second.quarantined || link->second.is_dismissed) {
        return worker_left(worker, why);
    }
    if (is_cut_off) {
        return worker_lost(worker, why);
    }
    log_warning("connection broke: worker={} name={} working={} reason=\"{}\"",
                worker.value,
                link->second.author->name,
                status.working,
                why);
    link->second.is_settled = false;
    blocks_.worker_detached(worker);
    watch_.detached(worker, Clock::now());
    act(dispatcher().worker_silent(worker));
    check_workers();
    feed();
}

asio::awaitable<void> Coordinator::watch_workers() {
    const auto timer = watch_timer_;
    while (!closed_ && watch_.size() != 0) {
        const FailureTimes::Duration period = parts_.times.heartbeat / 2;
        const bool is_at_end = dispatcher_.is_at_end();
        timer->expires_after(is_at_end ? std::min(period, limits::end_check_period) : period);
        boost::system::error_code ignored;
        co_await timer->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        if (!closed_) {
            check_workers();
        }
        if (!closed_ && is_at_end) {
            feed(); // A straggler may need a speculative copy.
        }
    }
    watch_timer_.reset();
}

void Coordinator::check_workers() {
    hear_bytes();
    for (const WorkerWatch::Change& change : watch_.time_is(Clock::now())) {
        if (!change.state) {
            log_info("worker forgotten: worker={}", change.worker.value);
            lost_.erase(change.worker);
        } else if (*change.state == WorkerState::Lost) {
            worker_lost(change.worker, "nothing was heard of it");
        } else {
            log_warning("worker is silent: worker={}", change.worker.value);
            act(dispatcher().worker_silent(change.worker));
            feed();
        }
    }
}

void Coordinator::close() {
    closed_ = true;
    *closing_ = true;
    blocks_.close();
    if (watch_timer_ != nullptr) {
        watch_timer_->cancel();
    }
    if (awaited_until_ != nullptr) {
        awaited_until_->cancel();
    }
    retries_.close();
    references_.close();
}

// ---- Leaving ----------------------------------------------------------------------------------

void Coordinator::worker_draining(WorkerId worker) {
    log_info("worker draining: worker={}", worker.value);
    act(dispatcher().worker_draining(worker));
    feed();
}

std::vector<WorkerId> Coordinator::workers_here() const {
    std::vector<WorkerId> here;
    for (const auto& [worker, link] : workers_) {
        here.push_back(worker);
    }
    return here;
}

void Coordinator::drain_worker(WorkerId worker) {
    const auto channel = workers_.at(worker).channel;
    worker_draining(worker);
    channel->send(Drain{}); // Sent after everything queued for the worker.
}

void Coordinator::terminate_worker(WorkerId worker) {
    log_info("worker told to end at once: worker={}", worker.value);
    WorkerLink& link = workers_.at(worker);
    link.is_dismissed = true;
    take_all_back(worker);
    if (link.channel->is_open()) {
        link.channel->send(Terminate{"an admin has sent it away"});
        link.channel->close(true);
    } else {
        worker_left(worker, "sent away while it had no connection");
    }
    feed();
}

void Coordinator::cut_off(WorkerId worker, const Error& why) {
    const auto link = workers_.find(worker);
    if (link == workers_.end() || link->second.is_cut_off) {
        return;
    }
    log_error("worker cut off: worker={} error=\"{}\"", worker.value, why.detail);
    link->second.is_cut_off = true;
    // Closing ends the conversation, and the worker is lost.
    if (link->second.channel->is_open()) {
        link->second.channel->close();
    } else {
        worker_lost(worker, why.detail);
    }
}

void Coordinator::worker_lost(WorkerId worker, const std::string& why) {
    const auto link = workers_.find(worker);
    if (link == workers_.end()) {
        return;
    }
    WorkerStatus last = worker_status(worker, link->second);
    log_warning("worker lost: worker={} name={} given_back={} reason=\"{}\"",
                worker.value,
                last.name,
                last.working,
                why);
    ++workers_lost_;
    scenarios_given_back_ += last.working;
    last.state = WorkerState::Lost;
    lost_.emplace(worker, LostWorker{std::move(last), link->second.author->process});
    watch_.lost(worker);
    link->second.channel->close();
    worker_left(worker, why);
}

void Coordinator::worker_left(WorkerId worker, const std::string& why) {
    log_info("worker left: worker={} reason=\"{}\"", worker.value, why);
    workers_.erase(worker);
    if (!lost_.contains(worker)) {
        watch_.left(worker);
    }
    blocks_.worker_left(worker);
    writer_.forget(worker);
    forget_late_results(worker);
    forget_tasks(worker);
    act(dispatcher().worker_lost(worker));
    feed();
}

} // namespace cd
