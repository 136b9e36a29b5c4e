// Performs the dispatcher's actions.
#include "master/coordinator/coordinator.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"

#include <random>

namespace cd {

Coordinator::Coordinator(CoordinatorParts parts)
    : parts_(std::move(parts)),
      workers_(parts_.times,
               std::random_device{}() | std::uint64_t{std::random_device{}()} << 32,
               *this,
               Clock::now),
      blocks_(parts_.executor, trees_),
      jobs_(limits::results_ended_kept_max, parts_.retention),
      writer_([executor = parts_.executor](
                  std::function<void()> run) { asio::post(executor, std::move(run)); },
              parts_.journal),
      retries_(parts_.executor),
      references_(parts_.executor, parts_.blocking) {}
Coordinator::~Coordinator() = default;

double Coordinator::now() const {
    return std::chrono::duration<double>(Clock::now() - started_).count();
}

Dispatcher& Coordinator::dispatcher() {
    dispatcher_.time_is(now());
    return dispatcher_;
}

void Coordinator::act(Actions actions) {
    std::move(actions.begin(), actions.end(), std::back_inserter(actions_));
    // An action may cause further ones; they queue up behind it.
    if (acting_) {
        return;
    }
    acting_ = true;
    while (!actions_.empty()) {
        const Action action = std::move(actions_.front());
        actions_.pop_front();
        std::visit([this](const auto& one) { perform(one); }, action);
    }
    acting_ = false;
}

void Coordinator::perform(const SendBatch& action) {
    Worker* worker = workers_.find(action.worker);
    if (worker == nullptr) {
        return; // The worker has left; the dispatcher knows.
    }
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        act(dispatcher().task_ended(action.worker, action.task));
        return;
    }
    auto content = std::make_shared<TaskContent>();
    content->job = job->id;
    content->material = job->material;
    Batch batch{action.task, job->id, {}, {0}, {}};
    std::vector<Scenario> scenarios;
    for (const std::uint64_t index : action.scenarios) {
        const auto& analysis = job->open.at(index);
        scenarios.push_back(analysis->scenario);
        batch.pairs.insert(batch.pairs.end(), analysis->pairs.begin(), analysis->pairs.end());
        batch.pair_offsets.push_back(static_cast<std::uint32_t>(batch.pairs.size()));
        content->scenarios.push_back(analysis);
    }
    batch.scenarios = pack_scenarios(scenarios);
    add_job_to(*worker, *job);
    worker->channel->send(batch);
    RunningTask task{action.worker, std::move(content)};
    task.is_copy = action.is_copy;
    job->help.copies += action.is_copy ? action.scenarios.size() : 0;
    tasks_.emplace(action.task, std::move(task));
    note_work(action.worker);
}

void Coordinator::perform(const AskBack& action) {
    if (const Worker* worker = workers_.find(action.worker)) {
        worker->channel->send(Recall{action.task, action.scenarios, action.places});
    }
}

void Coordinator::perform(const CallOff& action) {
    if (const Worker* worker = workers_.find(action.worker)) {
        worker->channel->send(DropScenario{action.job, action.scenario, action.task});
    }
}

void Coordinator::perform(const SendHint& action) {
    Worker* worker = workers_.find(action.worker);
    const MasterJob* job = jobs_.find_running(action.job);
    if (worker != nullptr && job != nullptr) {
        add_job_to(*worker, *job);
        worker->channel->send(Hint{action.job, action.tree, action.roots});
    }
}

void Coordinator::perform(const GiveUp& action) {
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        return;
    }
    const auto analysis = job->open.at(action.scenario);
    log_error("scenario given up: job={} scenario={}", job->id.value, action.scenario);
    const std::string why = "lost with " + std::to_string(limits::scenario_losses_max) +
                            " workers, one after the other, or with fewer again and again";
    fail_scenario(*job, analysis->scenario, why);
}

StatusView Coordinator::status() const {
    return {jobs_, workers_, alarms_, writer_.paused(), Clock::now()};
}

ClusterStatus Coordinator::cluster_status() const {
    ClusterStatus status = this->status().cluster();
    status.uptime_seconds = now();
    status.meshes = parts_.geometry.meshes();
    return status;
}

} // namespace cd
