// Results of no task: what a worker sends again in another session, and what comes when its job has
// ended. Such a job is not corrected any more, for its digest has been told; but who was wrong is
// found out, and whoever has the results learns of it.
#include "common/core/log.hpp"
#include "common/job/run_scenario.hpp"
#include "master/coordinator.hpp"
#include "master/job_geometry.hpp"
#include "master/run_on.hpp"

#include <utility>

namespace cd {

void Coordinator::late_results_came(LateResults late) {
    const JobId id = late.message->job;
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        // Of a job that nobody was ever told of, or whose results are gone: nobody wants them.
        ledger_.promise(Delivery{late.worker, late.message->sequence}, written_);
        keep_promises();
        late.done();
    } else if (job->is_running() && job->material != nullptr) {
        check_late_results(*job, std::move(late));
    } else if (job->state == JobState::Running) {
        late_results_.emplace(id, std::move(late));
    } else {
        spawn(parts_.executor, "late results", compare_late_results(std::move(late), job->results));
    }
}

void Coordinator::look_at_late_results(JobId job) {
    std::vector<LateResults> all;
    const auto [begin, end] = late_results_.equal_range(job);
    for (auto late = begin; late != end; ++late) {
        all.push_back(std::move(late->second));
    }
    late_results_.erase(begin, end);
    for (LateResults& late : all) {
        late_results_came(std::move(late));
    }
}

void Coordinator::check_late_results(const MasterJob& job, LateResults late) {
    parts_.blocking.post([this,
                          executor = parts_.executor,
                          id = job.id,
                          material = job.material,
                          poses = job.poses,
                          late = std::move(late)] {
        auto taken = take_late_results(id, material, *poses, *late.message);
        const auto hand = std::make_shared<ResultsInHand>(
            ResultsInHand{late.worker, nullptr, late.message, std::move(taken), late.done, {}});
        asio::post(executor, [this, hand] { late_results_checked(hand); });
    });
}

void Coordinator::late_results_checked(std::shared_ptr<ResultsInHand> hand) {
    if (hand->taken || hand->taken.error().code != ErrorCode::Io) {
        return take_in(std::move(hand));
    }
    // That their poses cannot be read is not the worker's fault.
    const JobId id = hand->message->job;
    LateResults late{hand->worker, hand->message, hand->done};
    MasterJob* job = jobs_.find_running(id);
    if (job == nullptr) {
        return late_results_came(std::move(late));
    }
    late_results_.emplace(id, std::move(late));
    wait_for_disk(*job, hand->taken.error(), [this, id] { look_at_late_results(id); });
}

asio::awaitable<void> Coordinator::compare_late_results(LateResults late,
                                                        std::shared_ptr<const ResultStore> kept) {
    const JobId id = late.message->job;
    auto compare = [kept, message = late.message] { return late_differences(*kept, *message); };
    Result<std::vector<LateDifference>> found = co_await run_on(parts_.blocking, compare);
    if (!found && found.error().code != ErrorCode::Io) {
        cut_off(late.worker, found.error());
    } else if (!found) {
        spdlog::error(
            "late results are not compared: job={} error=\"{}\"", id.value, found.error().detail);
    } else if (!found.value().empty() && !is_distrusted(late.worker)) {
        spdlog::error("late results differ: job={} scenarios={} first={} worker={}",
                      id.value,
                      found.value().size(),
                      found.value().front().late.index,
                      late.worker.value);
        // One tells who is to blame.
        LateDifference first = std::move(found.value().front());
        co_await judge_late(id, late.worker, std::move(first));
    }
    ledger_.promise(Delivery{late.worker, late.message->sequence}, written_);
    keep_promises();
    go_on(late.done);
}

/// A scenario of a job that has ended, to be run once more.
struct Coordinator::LateCase {
    GeometryStore& store;
    Submit submit;
    std::filesystem::path poses;
    std::uint64_t scenario = 0;

    /// May take long. Errors: those of what is gone; Interrupted.
    [[nodiscard]] Result<ScenarioResult> run(const StopCheck& stop) const {
        const auto a = store.tree(submit.bodies[0]);
        const auto b = store.tree(submit.bodies[1]);
        if (!a || !b) {
            return a ? b.error() : a.error();
        }
        const Result<std::shared_ptr<PoseSource>> source = open_poses(submit, poses);
        if (!source) {
            return source.error();
        }
        const Result<std::vector<Scenario>> read = source.value()->read(scenario, 1);
        if (!read) {
            return read.error();
        }
        const ScenarioRunner runner(*a.value(), *b.value(), submit.query, PairStage::Float, stop);
        ScenarioRun run;
        if (!stop()) {
            run = runner.run(read.value().front());
        }
        if (run.is_stopped || stop()) {
            return Error{ErrorCode::Interrupted, "the master ends"};
        }
        return std::move(run.result);
    }
};

asio::awaitable<void>
Coordinator::judge_late(JobId id, WorkerId worker, LateDifference difference) {
    const std::uint64_t index = difference.late.index;
    const auto stop = std::make_shared<std::atomic<bool>>(closed_);
    const auto judging = judging_.emplace(std::pair(id, index), stop);
    const MasterJob* job = jobs_.find(id);
    Result<ScenarioResult> right = no_job(id);
    if (job != nullptr && job->has_dropped_bulk) {
        right = Error{ErrorCode::NotFound, "its query was too large to be kept"};
    } else if (job != nullptr) {
        auto run =
            [again = LateCase{parts_.geometry, job->submit, parts_.journal.poses_path(id), index},
             stop] { return again.run([stop] { return stop->load(); }); };
        right = co_await run_on(parts_.blocking, run);
    }
    judging_.erase(judging);
    job = jobs_.find(id);
    if (job == nullptr || closed_ || is_distrusted(worker)) {
        co_return; // Its results are gone; or others have told who is wrong.
    }
    const std::string where = "results of job " + std::to_string(id.value) +
                              ", which has ended, scenario " + std::to_string(index) + ", differ";
    if (!right) {
        alarm(where + ", the later one of " + name_of(worker) +
              ", and which is right cannot be found out: " + right.error().detail +
              "; submit the job again");
    } else {
        const WorkerId author{index < job->authors.size() ? job->authors[index] : 0};
        if (!agrees(difference.kept, right.value())) {
            alarm(where + ", and the master's own says that what was kept, of " +
                  (author == WorkerId{} ? "an unknown worker" : name_of(author)) +
                  ", is wrong; submit the job again");
            quarantine(author);
        }
        if (!agrees(difference.late, right.value())) {
            alarm(where + ", and the master's own says that " + name_of(worker) + " is wrong");
            quarantine(worker);
        }
    }
    AddResults verdict{id, job->results, {}, job->progress(Clock::now()), {}};
    verdict.alarms = alarms_;
    write(std::move(verdict));
    feed();
}

} // namespace cd
