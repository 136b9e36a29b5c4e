// Contact maps. A message has one map for all its scenarios, so it counts only if all are new. If
// some were merged before from another worker, the master recomputes the map of the others.
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"

namespace cd {

std::vector<std::uint64_t> Coordinator::new_scenarios(const MasterJob& job,
                                                      std::span<const TakenResult> results) {
    std::vector<std::uint64_t> scenarios;
    for (const TakenResult& one : results) {
        if (!job.merged.has(one.result.index)) {
            scenarios.push_back(one.result.index);
        }
    }
    return scenarios;
}

void Coordinator::take_in(std::shared_ptr<ResultsInHand> hand) {
    const MasterJob* job = jobs_.find_running(hand->job());
    if (job != nullptr && job->submit.query.maps && hand->taken) {
        TakenResults& taken = hand->taken.value();
        std::vector<std::uint64_t> fresh = new_scenarios(*job, taken.results);
        if (fresh.empty()) {
            taken.map = {};
        } else if (fresh.size() != taken.results.size() && fresh != hand->mapped) {
            return spawn(parts_.executor,
                         "a map of some scenarios",
                         make_map(job->id, std::move(hand), std::move(fresh)));
        }
    }
    results_taken(*hand, std::move(hand->taken));
    go_on(hand->done);
}

asio::awaitable<void> Coordinator::make_map(JobId id,
                                            std::shared_ptr<ResultsInHand> hand,
                                            std::vector<std::uint64_t> scenarios) {
    for (MasterJob* job = jobs_.find_running(id); job != nullptr;) {
        auto make = [material = job->material, poses = job->poses, &scenarios] {
            return reference_map(*material, *poses, scenarios);
        };
        Result<ContactMap> map = co_await run_on(parts_.blocking, make);
        if (map) {
            hand->taken.value().map = std::move(map.value());
            hand->mapped = std::move(scenarios);
            job = jobs_.find_running(id);
            if (job != nullptr) {
                disk_gives(*job);
            }
            break;
        }
        job = jobs_.find_running(id);
        if (job != nullptr) {
            set_aside(*hand->message, hand->done);
            job = co_await wait_until_mended(id, map.error());
            take_up(*hand->message);
        }
    }
    if (!closed_) {
        take_in(std::move(hand));
    }
}

void Coordinator::withdraw_map(MasterJob& job, const std::string& why) {
    if (job.submit.query.maps) {
        job.map.withdraw(why);
    }
}

Result<ContactMapAnswer> Coordinator::contact_map(JobId id) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return job_status(id).error();
    }
    if (job->state != JobState::Done) {
        return Error{ErrorCode::Refused, "the job is not done, so it has no map"};
    }
    return ContactMapAnswer{id, job->submit.query.maps, job->map.withdrawn(), job->map.packed()};
}

} // namespace cd
