// Returns and drops scenarios of a session that have not begun.
#include "common/core/host/log.hpp"
#include "worker/session/session.hpp"

#include <algorithm>

namespace cd {

namespace {

bool names(const std::vector<std::uint64_t>& ascending, std::uint64_t scenario) {
    return std::binary_search(ascending.begin(), ascending.end(), scenario);
}

} // namespace

// ---- Messages from the master ---------------------------------------------------------------

Status Session::handle(Recall& recall) {
    const auto found = tasks_.find(recall.task);
    if (found == tasks_.end()) {
        return Done{}; // The task has ended, and its EndOfTask is in transit.
    }
    Task& task = found->second;
    const std::vector<Place> dropped = drop_unbegun([&](const Place& place) {
        return place.task == task.id() && names(recall.scenarios, task.index_of(place.scenario));
    });
    for (const Place& place : dropped) {
        task.give_back(task.index_of(place.scenario));
    }
    task.keep_places(recall.places);
    Recalled recalled = task.given_back();
    log_debug("recalled: task={} scenarios={} places_kept={}",
              task.id().value,
              recalled.scenarios.size(),
              recalled.places);
    channel_->send(recalled);
    settle_soon();
    return Done{};
}

Status Session::handle(DropScenario& drop) {
    const auto job = jobs_.find(drop.job);
    const auto task = tasks_.find(drop.task);
    if (job == jobs_.end() || (drop.task != TaskId{} && task == tasks_.end())) {
        return Done{};
    }
    if (drop.task == TaskId{}) {
        log_info("scenario dropped: job={} scenario={}", drop.job.value, drop.scenario);
        job->second->dropped->add(drop.scenario);
        return Done{};
    }
    task->second.answered_elsewhere()->add(drop.scenario);
    drop_unbegun([&](const Place& place) {
        return place.task == drop.task && task->second.index_of(place.scenario) == drop.scenario;
    });
    settle_soon();
    return Done{};
}

// ---- Dropping scenarios ---------------------------------------------------------------------

std::vector<Session::Place>
Session::drop_unbegun(const std::function<bool(const Place&)>& concerned) {
    std::vector<Place> dropped;
    std::vector<Token> tokens;
    for (const auto& [token, place] : places_) {
        const bool goes =
            concerned(place) && (place.has_begun == nullptr || !place.has_begun->exchange(true));
        if (goes) {
            dropped.push_back(place);
            tokens.push_back(token);
        }
    }
    std::erase_if(ready_, [&](Token token) {
        return std::binary_search(tokens.begin(), tokens.end(), token);
    });
    for (const Token token : tokens) {
        tasks_.at(places_.at(token).task).drop();
        places_.erase(token);
        fetcher_.finished(token);
    }
    return dropped;
}

void Session::drop_unstarted(const std::function<bool(const Task&)>& concerned) {
    drop_unbegun([&](const Place& place) { return concerned(tasks_.at(place.task)); });
    for (auto& [id, task] : tasks_) {
        if (concerned(task)) {
            task.drop_unwalked();
        }
    }
}

void Session::abandon(const std::function<bool(const Task&)>& concerned) {
    drop_unstarted(concerned);
    for (auto& [id, task] : tasks_) {
        if (concerned(task)) {
            task.abandon(); // Running scenarios stop soon, without a result.
        }
    }
}

} // namespace cd
