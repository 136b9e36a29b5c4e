#include "master/workers/worker_directory.hpp"

#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/host/log.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace cd {

namespace {

InstanceId number_in(const Sha256& hash) {
    return std::max<InstanceId>(1, ByteReader(hash.bytes).get<InstanceId>());
}

/// Returns the worker's instance id, or a random one if it sends none. With a certificate, hashes
/// the id with the holder, so that nobody can impersonate another holder's process.
InstanceId process_that_greets(const Hello& hello, const std::string& holder) {
    if (hello.instance == 0) {
        return number_in(random_secret());
    }
    if (holder.empty()) {
        return hello.instance;
    }
    const std::string text = "process " + std::to_string(hello.instance) + " " + holder;
    return number_in(sha256(std::as_bytes(std::span(text))));
}

} // namespace

void Worker::send(const WorkerSupply::Messages& messages) const {
    for (const Message& message : messages) {
        channel->send(message);
    }
}

WorkerDirectory::WorkerDirectory(const FailureTimes& times,
                                 std::uint64_t epoch,
                                 WorkerEvents& events,
                                 std::function<Time()> now)
    : epoch_(epoch), events_(events), now_(std::move(now)), watch_(times) {}

// ---- Joining and returning --------------------------------------------------------------------

Reception WorkerDirectory::receive(const Hello& hello, const std::string& holder) {
    const WorkerId before{hello.resumed.id};
    const Worker* worker = find(before);
    const bool is_of_this_life = hello.resumed.epoch == epoch_ || mutated(Mutation::OldEpochTaken);
    if (is_of_this_life && worker != nullptr && !worker->is_cut_off &&
        worker->instance == hello.instance && worker->author->holder == holder) {
        return {before, worker->key, true, holder};
    }
    return {WorkerId{++last_}, random_secret(), false, holder};
}

void WorkerDirectory::join(const Reception& reception,
                           const Hello& hello,
                           std::shared_ptr<Channel> channel) {
    const WorkerId id = reception.worker;
    if (reception.is_resumed) {
        return resume(id, std::move(channel));
    }
    const InstanceId process = process_that_greets(hello, reception.holder);
    end_earlier_sessions(process);
    log_info("worker joined: worker={} name={} holder=\"{}\" threads={} cache_bytes={} peer={}",
             id.value,
             hello.name,
             reception.holder,
             hello.threads,
             hello.cache_bytes,
             channel->peer());
    Worker worker;
    worker.channel = std::move(channel);
    worker.key = reception.key;
    worker.author = std::make_shared<const Author>(
        Author{process, id, hello.name, reception.holder, hello.build});
    worker.threads = std::max(1u, hello.threads);
    worker.instance = hello.instance;
    worker.meter = WorkerMeter(hello.cache_bytes);
    workers_.emplace(id, std::move(worker));
    watch_.joined(id, now_());
    events_.worker_joined(id, hello);
}

void WorkerDirectory::end_earlier_sessions(InstanceId process) {
    std::vector<WorkerId> earlier;
    for (const auto& [id, worker] : workers_) {
        if (worker.author->process == process) {
            earlier.push_back(id);
        }
    }
    for (const WorkerId id : earlier) {
        events_.worker_replaced(id);
        lose(id, "it has begun another session");
    }
    std::erase_if(lost_, [&](const auto& lost) {
        const bool is_its = lost.second.process == process;
        if (is_its) {
            watch_.left(lost.first);
        }
        return is_its;
    });
}

void WorkerDirectory::resume(WorkerId id, std::shared_ptr<Channel> channel) {
    Worker* worker = find(id);
    if (worker == nullptr) {
        return channel->close();
    }
    log_info("worker came back: worker={} name={} peer={}",
             id.value,
             worker->author->name,
             channel->peer());
    ++counts_.resumed;
    worker->channel->close();
    worker->channel = std::move(channel);
    worker->is_settled = false;
    watch_.heard(id, now_());
    events_.worker_resumed(id);
}

std::shared_ptr<WorkerIntake> WorkerDirectory::intake_of(WorkerId worker) {
    std::erase_if(intakes_, [](const auto& intake) { return intake.second.expired(); });
    std::weak_ptr<WorkerIntake>& known = intakes_[workers_.at(worker).author->process];
    std::shared_ptr<WorkerIntake> intake = known.lock();
    if (intake == nullptr) {
        intake = std::make_shared<WorkerIntake>();
        known = intake;
    }
    return intake;
}

// ---- Silence ----------------------------------------------------------------------------------

bool WorkerDirectory::is_its_channel(WorkerId id, const Channel& channel) const {
    const auto worker = workers_.find(id);
    return worker != workers_.end() && worker->second.channel.get() == &channel;
}

bool WorkerDirectory::heard(WorkerId worker, const Channel& channel) {
    if (!is_its_channel(worker, channel)) {
        return false;
    }
    note_life(worker);
    return true;
}

void WorkerDirectory::unheard(WorkerId worker, const Channel& channel) {
    if (is_its_channel(worker, channel)) {
        watch_.unheard(worker);
    }
}

void WorkerDirectory::note_life(WorkerId worker) {
    if (!watch_.heard(worker, now_())) {
        return;
    }
    log_info("worker is heard again: worker={}", worker.value);
    if (workers_.at(worker).is_settled) {
        events_.worker_heard_again(worker);
    }
}

void WorkerDirectory::heartbeat_came(WorkerId id, const Heartbeat& heartbeat) {
    if (Worker* worker = find(id)) {
        worker->meter.heartbeat_came(heartbeat);
    }
}

void WorkerDirectory::settle(WorkerId worker) {
    workers_.at(worker).is_settled = true;
}

void WorkerDirectory::check() {
    hear_bytes();
    for (const WorkerWatch::Change& change : watch_.time_is(now_())) {
        if (!change.state) {
            log_info("worker forgotten: worker={}", change.worker.value);
            lost_.erase(change.worker);
        } else if (*change.state == WorkerState::Lost) {
            lose(change.worker, "nothing was heard of it");
        } else {
            log_warning("worker is silent: worker={}", change.worker.value);
            events_.worker_silent(change.worker);
        }
    }
}

/// Counts received bytes as a sign of life: a large message may take long to arrive.
void WorkerDirectory::hear_bytes() {
    std::vector<WorkerId> heard;
    for (auto& [id, worker] : workers_) {
        if (worker.meter.bytes_came(worker.channel->traffic().bytes_received) &&
            worker.channel->is_open()) {
            heard.push_back(id);
        }
    }
    for (const WorkerId worker : heard) {
        note_life(worker);
    }
}

// ---- Leaving ----------------------------------------------------------------------------------

void WorkerDirectory::connection_ended(WorkerId id,
                                       const Channel& channel,
                                       const std::string& why) {
    if (is_closed_ || !is_its_channel(id, channel)) {
        return;
    }
    Worker& worker = workers_.at(id);
    const WorkerStatus work = events_.work_of(id);
    const bool is_drained = work.draining && work.working == 0 && !worker.is_cut_off;
    if (is_drained || worker.is_quarantined || worker.is_dismissed) {
        return leave(id, why);
    }
    if (worker.is_cut_off) {
        return lose(id, why);
    }
    log_warning("connection broke: worker={} name={} working={} reason=\"{}\"",
                id.value,
                worker.author->name,
                work.working,
                why);
    worker.is_settled = false;
    watch_.detached(id, now_());
    events_.worker_detached(id);
    check();
}

void WorkerDirectory::cut_off(WorkerId id, const Error& why) {
    Worker* worker = find(id);
    if (worker == nullptr || worker->is_cut_off) {
        return;
    }
    log_error("worker cut off: worker={} error=\"{}\"", id.value, why.detail);
    worker->is_cut_off = true;
    // When the closed connection ends, `connection_ended` declares the worker lost.
    if (worker->channel->is_open()) {
        worker->channel->close();
    } else {
        lose(id, why.detail);
    }
}

void WorkerDirectory::dismiss(WorkerId id) {
    Worker& worker = workers_.at(id);
    worker.is_dismissed = true;
    if (worker.channel->is_open()) {
        worker.channel->send(Terminate{"an admin has sent it away"});
        worker.channel->close(true);
    } else {
        leave(id, "sent away while it had no connection");
    }
}

std::vector<WorkerId> WorkerDirectory::quarantine(InstanceId process) {
    std::vector<WorkerId> sessions;
    for (auto& [id, worker] : workers_) {
        if (worker.author->process == process) {
            worker.is_quarantined = true;
            sessions.push_back(id);
        }
    }
    return sessions;
}

void WorkerDirectory::lose(WorkerId id, const std::string& why) {
    const Worker* worker = find(id);
    if (worker == nullptr) {
        return;
    }
    WorkerStatus last = status(id, *worker);
    log_warning("worker lost: worker={} name={} given_back={} reason=\"{}\"",
                id.value,
                last.name,
                last.working,
                why);
    ++counts_.lost;
    counts_.given_back += last.working;
    last.state = WorkerState::Lost;
    lost_.emplace(id, Lost{std::move(last), worker->author->process});
    watch_.lost(id);
    worker->channel->close();
    leave(id, why);
}

void WorkerDirectory::leave(WorkerId worker, const std::string& why) {
    log_info("worker left: worker={} reason=\"{}\"", worker.value, why);
    workers_.erase(worker);
    if (!lost_.contains(worker)) {
        watch_.left(worker);
    }
    events_.worker_left(worker);
}

// ---- Views ------------------------------------------------------------------------------------

Worker* WorkerDirectory::find(WorkerId worker) {
    const auto found = workers_.find(worker);
    return found == workers_.end() ? nullptr : &found->second;
}

WorkerStatus WorkerDirectory::status(WorkerId id, const Worker& worker) const {
    const Time now = now_();
    WorkerStatus status = events_.work_of(id);
    status.worker = id;
    status.name = worker.author->name;
    status.quarantined = worker.is_quarantined;
    status.state = watch_.state(id).value_or(WorkerState::Alive);
    status.silent_seconds = watch_.silence(id, now).count();
    status.bytes_sent = worker.channel->traffic().bytes_sent;
    status.bytes_received = worker.channel->traffic().bytes_received;
    worker.meter.add_to(status, now);
    return status;
}

std::vector<WorkerStatus> WorkerDirectory::statuses() const {
    std::vector<WorkerStatus> all;
    for (const auto& [id, worker] : workers_) {
        all.push_back(status(id, worker));
    }
    for (const auto& [id, lost] : lost_) {
        all.push_back(lost.status);
        all.back().silent_seconds = watch_.silence(id, now_()).count();
    }
    return all;
}

void WorkerDirectory::check_invariants() const {
    CD_CHECK(watch_.size() == workers_.size() + lost_.size());
    for (const auto& [id, worker] : workers_) {
        const auto state = watch_.state(id);
        CD_CHECK(state == WorkerState::Alive || state == WorkerState::Silent);
    }
    for (const auto& [id, lost] : lost_) {
        CD_CHECK(watch_.state(id) == WorkerState::Lost);
    }
}

} // namespace cd
