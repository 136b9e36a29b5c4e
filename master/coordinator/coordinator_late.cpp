// Late results: resent in another session, so that they belong to no task. They are compared while
// their job runs, and only acknowledged afterwards.
#include "master/coordinator/coordinator.hpp"

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
    const MasterJob* job = jobs_.find_running(late.message->job);
    if (job == nullptr) {
        // Nobody needs the results: the job has ended or was never acknowledged to a client.
        writer_.promise(Delivery{late.author->worker, late.message->sequence});
        writer_.announce();
        writer_.when_room(late.done);
    } else if (job->material != nullptr) {
        check_late_results(*job, std::move(late));
    } else {
        put_away(std::move(late));
    }
}

void Coordinator::put_away(LateResults late) {
    const LateKey key{late.message->job, late.author->worker, late.message->sequence};
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
        const bool is_its = late.second.author->worker == worker;
        if (is_its) {
            take_up(*late.second.message);
        }
        return is_its;
    });
}

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
            ResultsInHand{late.author, nullptr, late.message, std::move(taken), late.done, {}});
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
    LateResults late{hand->author, hand->message, hand->done};
    if (job == nullptr) {
        return late_results_came(std::move(late));
    }
    const bool others_wait = has_late_results(id);
    put_away(std::move(late));
    if (!others_wait) {
        wait_for_disk(*job, hand->taken.error(), [this, id](MasterJob* running) {
            if (running != nullptr && !has_late_results(id)) { // The worker has left.
                return disk_gives(*running);
            }
            look_at_late_results(id);
        });
    }
}

} // namespace cd
