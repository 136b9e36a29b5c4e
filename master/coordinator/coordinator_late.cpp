// Late results: resent in another session, or received after their job has ended. An ended job is
// not corrected, since its digest is published. The master still finds out who was wrong, and
// raises an alarm for those who hold the results.
#include "common/core/host/log.hpp"
#include "common/job/run_scenario.hpp"
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/jobs/job_geometry.hpp"

#include <utility>

namespace cd {

namespace {

std::uint64_t bytes_of(const Results& message) {
    return sizeof(message) + message.records.size() + message.map.size();
}

} // namespace

void Coordinator::set_aside(const Results& message, std::function<void()>& done) {
    aside_bytes_ += bytes_of(message);
    if (aside_bytes_ <= parts_.results_aside_bytes_max) {
        std::exchange(done, [] {})();
    }
}

void Coordinator::take_up(const Results& message) {
    aside_bytes_ -= bytes_of(message);
}

void Coordinator::late_results_came(LateResults late) {
    const JobId id = late.message->job;
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        // The job was never acknowledged to a client, or its results are dropped: discard.
        ledger_.promise(Delivery{late.worker, late.message->sequence}, written_);
        keep_promises();
        late.done();
    } else if (job->is_running() && job->material != nullptr) {
        check_late_results(*job, std::move(late));
    } else if (job->state == JobState::Running) {
        put_away(std::move(late));
    } else {
        spawn(parts_.executor, "late results", compare_late_results(std::move(late), job->results));
    }
}

void Coordinator::put_away(LateResults late) {
    const LateKey key{late.message->job, late.worker, late.message->sequence};
    const auto [place, is_new] = late_results_.try_emplace(key, std::move(late));
    if (is_new) {
        set_aside(*place->second.message, place->second.done);
    } else {
        late.done(); // Duplicate of a message received over another connection.
    }
}

bool Coordinator::has_late_results(JobId job) const {
    const auto first = late_results_.lower_bound({job, WorkerId{}, 0});
    return first != late_results_.end() && std::get<JobId>(first->first) == job;
}

void Coordinator::look_at_late_results(JobId job) {
    std::vector<LateResults> all;
    while (has_late_results(job)) {
        const auto first = late_results_.lower_bound({job, WorkerId{}, 0});
        take_up(*first->second.message);
        all.push_back(std::move(first->second));
        late_results_.erase(first);
    }
    for (LateResults& late : all) {
        late_results_came(std::move(late));
    }
}

void Coordinator::forget_late_results(WorkerId worker) {
    std::erase_if(late_results_, [&](const auto& late) {
        const bool is_its = late.second.worker == worker;
        if (is_its) {
            take_up(*late.second.message);
        }
        return is_its;
    });
}

// ---- Late results of a running job ------------------------------------------------------------

void Coordinator::check_late_results(const MasterJob& job, LateResults late) {
    awaited_.check_begins(job.id);
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
    const JobId id = hand->message->job;
    awaited_.check_ends(id);
    MasterJob* job = jobs_.find_running(id);
    if (hand->taken || hand->taken.error().code != ErrorCode::Io) {
        if (job != nullptr) {
            disk_gives(*job);
        }
        take_in(std::move(hand));
        return feed();
    }
    // The worker is not to blame if the poses cannot be read.
    LateResults late{hand->worker, hand->message, hand->done};
    if (job == nullptr) {
        return late_results_came(std::move(late));
    }
    const bool others_wait = has_late_results(id);
    put_away(std::move(late));
    if (!others_wait) {
        wait_for_disk(*job, hand->taken.error(), [this, id] {
            if (!has_late_results(id)) { // The worker has left.
                return disk_gives(*jobs_.find(id));
            }
            look_at_late_results(id);
        });
    }
}

// ---- Late results of an ended job ---------------------------------------------------------------

asio::awaitable<void> Coordinator::compare_late_results(LateResults late,
                                                        std::shared_ptr<const ResultStore> kept) {
    const JobId id = late.message->job;
    auto compare = [kept, message = late.message, stop = closing_] {
        return late_difference(*kept, *message, [stop] { return stop->load(); });
    };
    Result<std::optional<LateDifference>> found = co_await run_on(parts_.blocking, compare);
    if (closed_) {
        co_return; // The worker resends it to the next incarnation of the master.
    }
    if (!found && found.error().code != ErrorCode::Io) {
        cut_off(late.worker, found.error());
    } else if (!found) {
        log_warning(
            "late results are not compared: job={} error=\"{}\"", id.value, found.error().detail);
    } else if (found.value()) {
        late_cases_.push_back({std::move(late), std::move(*found.value())});
        if (late_cases_.size() == 1) {
            co_await judge_late_cases();
        }
        co_return;
    }
    finish(late);
}

void Coordinator::finish(const LateResults& late) {
    ledger_.promise(Delivery{late.worker, late.message->sequence}, written_);
    keep_promises();
    go_on(late.done);
}

/// Runs one scenario of an ended job again.
struct Coordinator::EndedRun {
    GeometryStore& store;
    Submit submit;
    std::filesystem::path poses;
    std::uint64_t scenario = 0;

    /// May take long. Errors: those of missing meshes or poses; Interrupted.
    [[nodiscard]] Result<ScenarioResult> run(const StopCheck& stop) const {
        const auto a = store.tree(submit.bodies[0].mesh);
        const auto b = store.tree(submit.bodies[1].mesh);
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

/// Judges one case at a time: a run may take long, and the first wrong result discards all further
/// cases of that worker.
asio::awaitable<void> Coordinator::judge_late_cases() {
    while (!late_cases_.empty() && !closed_) {
        const LateCase& next = late_cases_.front();
        const JobId id = next.late.message->job;
        const MasterJob* job = jobs_.find(id);
        if (job != nullptr && !is_distrusted(next.late.worker)) {
            Result<ScenarioResult> right =
                Error{ErrorCode::NotFound, "not all of its query was kept"};
            if (!job->has_dropped_bulk) {
                auto run = [again = EndedRun{parts_.geometry,
                                             job->submit,
                                             parts_.journal.poses_path(id),
                                             next.difference.late.index},
                            stop = closing_] { return again.run([stop] { return stop->load(); }); };
                right = co_await run_on(parts_.blocking, run);
            }
            if (closed_) {
                co_return;
            }
            judge(next, right);
        }
        const LateResults late = std::move(late_cases_.front().late);
        late_cases_.pop_front();
        finish(late);
    }
}

void Coordinator::judge(const LateCase& late, const Result<ScenarioResult>& right) {
    const WorkerId worker = late.late.worker;
    const std::uint64_t index = late.difference.late.index;
    MasterJob* job = jobs_.find(late.late.message->job);
    if (job == nullptr || is_distrusted(worker)) {
        return; // The results are dropped, or another case has judged the worker.
    }
    const std::uint64_t alarms_before = alarms_.count;
    const std::string where = "results of job " + std::to_string(job->id.value) +
                              ", which has ended, scenario " + std::to_string(index) + ", differ";
    log_error(
        "late results differ: job={} scenario={} worker={}", job->id.value, index, worker.value);
    const auto repeat = [&](const std::string& why) {
        if (!std::exchange(job->is_to_be_repeated, true)) {
            alarm(where + why + "; submit the job again");
        }
    };
    if (!right) {
        repeat(", the later one of " + name_of(worker) +
               ", and which is right cannot be found out: " + right.error().detail);
    } else {
        if (encode_result(late.difference.kept) != encode_result(right.value())) {
            const WorkerId author{index < job->authors.size() ? job->authors[index] : 0};
            repeat(", and the master's own says that what was kept, of " +
                   (author == WorkerId{} ? "an unknown worker" : name_of(author)) + ", is wrong");
            quarantine(author);
        }
        if (!agrees(late.difference.late, right.value()) && !is_quarantined(worker)) {
            alarm(where + ", and the master's own says that " + name_of(worker) + " is wrong");
            quarantine(worker);
        }
    }
    if (alarms_.count != alarms_before) {
        AddResults verdict{job->id, job->results, {}, job->progress(Clock::now()), {}};
        verdict.alarms = alarms_;
        write(std::move(verdict));
    }
    feed();
}

} // namespace cd
