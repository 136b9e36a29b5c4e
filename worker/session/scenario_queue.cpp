#include "worker/session/scenario_queue.hpp"

#include <algorithm>
#include <iterator>

namespace cd {

ScenarioQueue::Token ScenarioQueue::add(TaskId task, std::size_t scenario) {
    const Token token = ++last_;
    places_.emplace(token, Place{token, task, scenario, nullptr});
    return token;
}

void ScenarioQueue::set_ready(std::span<const Token> tokens) {
    ready_.insert(ready_.end(), tokens.begin(), tokens.end());
}

std::optional<ScenarioQueue::Place> ScenarioQueue::begin_next() {
    if (ready_.empty()) {
        return std::nullopt;
    }
    Place& place = places_.at(ready_.front());
    ready_.pop_front();
    place.has_begun = std::make_shared<std::atomic<bool>>(false);
    return place;
}

std::optional<ScenarioQueue::Place> ScenarioQueue::finish(Token token) {
    const auto node = places_.extract(token);
    return node ? std::optional(node.mapped()) : std::nullopt;
}

std::vector<ScenarioQueue::Place>
ScenarioQueue::drop_unbegun(const std::function<bool(const Place&)>& concerned) {
    std::vector<Place> dropped;
    for (auto place = places_.begin(); place != places_.end();) {
        const auto next = std::next(place);
        const std::shared_ptr<std::atomic<bool>>& has_begun = place->second.has_begun;
        if (concerned(place->second) && (has_begun == nullptr || !has_begun->exchange(true))) {
            dropped.push_back(place->second);
            places_.erase(place);
        }
        place = next;
    }
    std::erase_if(ready_, [&](Token token) { return !places_.contains(token); });
    return dropped;
}

} // namespace cd
