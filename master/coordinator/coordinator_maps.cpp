// Contact maps. A message has one map for all its scenarios, so it counts only if all are new. If
// some were merged before from another worker, the master recomputes the map of the others.
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
            hand->mapped = std::move(fresh);
            return make_map(*job, std::move(hand));
        }
    }
    results_taken(*hand, std::move(hand->taken));
    writer_.when_room(hand->done);
}

void Coordinator::make_map(const MasterJob& job, std::shared_ptr<ResultsInHand> hand) {
    parts_.blocking.post([this,
                          executor = parts_.executor,
                          material = job.material,
                          poses = job.poses,
                          hand = std::move(hand)] {
        auto map =
            std::make_shared<Result<ContactMap>>(reference_map(*material, *poses, hand->mapped));
        asio::post(executor, [this, hand, map] { map_made(hand, std::move(*map)); });
    });
}

void Coordinator::map_made(const std::shared_ptr<ResultsInHand>& hand, Result<ContactMap> map) {
    MasterJob* job = jobs_.find_running(hand->job());
    if (closed_) {
        return;
    }
    if (map || job == nullptr) {
        if (map) {
            hand->taken.value().map = std::move(map.value());
        }
        if (job != nullptr) {
            disk_gives(*job);
        }
        return take_in(hand);
    }
    set_aside(*hand->message, hand->done);
    wait_for_disk(*job, map.error(), [this, hand](const MasterJob* running) {
        take_up(*hand->message);
        if (running == nullptr) {
            take_in(hand);
        } else {
            make_map(*running, hand);
        }
    });
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
