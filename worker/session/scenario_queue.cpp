#include "worker/session/scenario_queue.hpp"

#include <algorithm>
#include <iterator>

namespace cd {

ScenarioQueue::Token ScenarioQueue::add(TaskId task, std::size_t scenario) {
    const Token token = ++last_;
    entries_.emplace(token, Entry{token, task, scenario, nullptr});
    return token;
}

void ScenarioQueue::set_ready(std::span<const Token> tokens) {
    ready_.insert(ready_.end(), tokens.begin(), tokens.end());
}

std::optional<ScenarioQueue::Entry> ScenarioQueue::begin_next() {
    if (ready_.empty()) {
        return std::nullopt;
    }
    Entry& entry = entries_.at(ready_.front());
    ready_.pop_front();
    entry.has_begun = std::make_shared<std::atomic<bool>>(false);
    return entry;
}

std::optional<ScenarioQueue::Entry> ScenarioQueue::finish(Token token) {
    const auto node = entries_.extract(token);
    return node ? std::optional(node.mapped()) : std::nullopt;
}

std::vector<ScenarioQueue::Entry>
ScenarioQueue::drop_unbegun(const std::function<bool(const Entry&)>& concerned) {
    std::vector<Entry> dropped;
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const auto next = std::next(entry);
        const std::shared_ptr<std::atomic<bool>>& has_begun = entry->second.has_begun;
        if (concerned(entry->second) && (has_begun == nullptr || !has_begun->exchange(true))) {
            dropped.push_back(entry->second);
            entries_.erase(entry);
        }
        entry = next;
    }
    std::erase_if(ready_, [&](Token token) { return !entries_.contains(token); });
    return dropped;
}

} // namespace cd
