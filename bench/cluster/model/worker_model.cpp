#include "bench/cluster/model/worker_model.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/worker.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cd::bench {

WorkerModel::WorkerModel(WorkerId id, const Workload& workload, std::uint64_t cache_bytes)
    : id_(id), workload_(workload), cache_bytes_(cache_bytes) {
    for (std::size_t tree = 0; tree < slots_.size(); ++tree) {
        slots_[tree].resize(workload.trees[tree].size() + 1, Slot::Absent);
    }
}

Messages WorkerModel::take(const WorkUnit& unit) {
    Task& task = tasks_[unit.task];
    task.job = unit.job;
    results_wait_ = 1e-3 * unit.results_wait_ms;
    task.open = unit.count;
    task.first = unit.first;
    task.count = unit.count;
    task.is_range = unit.scenarios.empty();
    if (!task.is_range || (has({0, top_root}) && has({1, top_root}))) {
        return by_tree<WantSubtrees>(begin(unit));
    }
    ranges_.push_back(unit);
    std::vector<BlockId> wanted;
    for (const BlockId top : {BlockId{0, top_root}, BlockId{1, top_root}}) {
        if (slot(top) == Slot::Absent) {
            want(top, wanted);
        }
    }
    return by_tree<WantSubtrees>(std::move(wanted));
}

std::vector<BlockId> WorkerModel::begin(const WorkUnit& unit) {
    std::vector<BlockId> wanted;
    for (const std::uint64_t scenario : scenarios_in(unit)) {
        if (takes_turns_) {
            turns_.emplace_back(scenario, unit.task);
        } else {
            admit(scenario, unit.task, wanted);
        }
    }
    return wanted;
}

void WorkerModel::admit(std::uint64_t scenario, TaskId task, std::vector<BlockId>& wanted) {
    std::size_t missing = 0;
    for (const BlockId& block : workload_.scenario(scenario).blocks) {
        pin(block);
        if (has(block)) {
            continue;
        }
        if (slot(block) == Slot::Absent) {
            want(block, wanted);
        }
        waiting_for_[block].push_back(scenario);
        ++missing;
    }
    const bool is_new = scenarios_.emplace(scenario, Waiting{task, missing}).second;
    CD_CHECK(is_new);
    if (missing == 0) {
        ready_.push_back(scenario);
    }
}

Messages WorkerModel::proceed() {
    std::vector<BlockId> wanted;
    if (scenarios_.empty() && !turns_.empty()) {
        const auto [scenario, task] = turns_.front();
        turns_.pop_front();
        admit(scenario, task, wanted);
    }
    return by_tree<WantSubtrees>(std::move(wanted));
}

void WorkerModel::take(const Hint& hint) {
    for (const RootIndex root : hint.roots) {
        hinted_.push_back(block_id(hint.tree, root));
    }
}

Messages WorkerModel::ahead() {
    std::vector<BlockId> wanted;
    const bool needs_some = std::ranges::any_of(
        waiting_for_, [](const auto& waiting) { return !waiting.second.empty(); });
    while (!needs_some && !hinted_.empty() && wanted_bytes_ < limits::hinted_bytes_max) {
        const BlockId block = hinted_.front();
        hinted_.pop_front();
        const std::uint64_t bytes =
            memory_bytes_ + wanted_bytes_ + workload_.block(block).memory_bytes;
        const bool has_room = cache_bytes_ == 0 || bytes <= cache_bytes_;
        if (has_room && slot(block) == Slot::Absent) {
            want(block, wanted);
        }
    }
    return by_tree<WantSubtrees>(std::move(wanted));
}

void WorkerModel::want(const BlockId& block, std::vector<BlockId>& wanted) {
    slot(block) = Slot::Wanted;
    wanted_bytes_ += workload_.block(block).memory_bytes;
    wanted.push_back(block);
}

std::optional<Recalled> WorkerModel::take(const Recall& recall) {
    const auto task = tasks_.find(recall.task);
    if (task == tasks_.end()) {
        return std::nullopt;
    }
    Task& of = task->second;
    const auto give_back = [&](std::uint64_t scenario) {
        const auto place = scenarios_.find(scenario);
        if (place != scenarios_.end() && place->second.task == recall.task &&
            !place->second.has_begun) {
            drop(scenario);
            of.given_back.insert(scenario);
        }
    };
    std::ranges::for_each(recall.scenarios, give_back);
    for (std::uint64_t position = of.count; of.is_range && position > recall.kept; --position) {
        give_back(of.first + position - 1);
    }
    return Recalled{recall.task, {of.given_back.begin(), of.given_back.end()}, of.count};
}

bool WorkerModel::take(const DropScenario& loser) {
    const auto place = scenarios_.find(loser.scenario);
    if (place == scenarios_.end() || place->second.task != loser.task) {
        return false;
    }
    if (!place->second.has_begun) {
        drop(loser.scenario);
        return false;
    }
    place->second.is_called_off = true;
    return true;
}

void WorkerModel::drop(std::uint64_t scenario) {
    if (!ready_.empty() && ready_.back() == scenario) {
        ready_.pop_back(); // The last scenario of a range.
    } else {
        std::erase(ready_, scenario);
    }
    for (const BlockId& block : workload_.scenario(scenario).blocks) {
        if (const auto waiting = waiting_for_.find(block); waiting != waiting_for_.end()) {
            std::erase(waiting->second, scenario);
        }
        unpin(block);
    }
    --tasks_.at(scenarios_.at(scenario).task).open;
    scenarios_.erase(scenario);
}

double WorkerModel::open_seconds(const Subtrees& blocks) const {
    double seconds = 0;
    for (const SubtreeBlock& block : blocks.blocks) {
        seconds += workload_.block(block_id(blocks.tree, block.root)).open_seconds;
    }
    return seconds;
}

Messages WorkerModel::opened(const Subtrees& blocks) {
    std::vector<BlockId> held;
    for (const SubtreeBlock& one : blocks.blocks) {
        const BlockId block = block_id(blocks.tree, one.root);
        Slot& slot = this->slot(block);
        // The master also sends a block that a slow peer was to give.
        if (slot != Slot::Wanted) {
            ++blocks_again_;
            continue;
        }
        slot = Slot::Here;
        held.push_back(block);
        ++received_blocks_;
        memory_bytes_ += workload_.block(block).memory_bytes;
        wanted_bytes_ -= workload_.block(block).memory_bytes;
        if (cache_bytes_ != 0 && one.root != top_root && !pins_.contains(block)) {
            set_idle(block);
        }
        const auto waiting = waiting_for_.find(block);
        if (waiting == waiting_for_.end()) {
            continue; // The block was only hinted.
        }
        for (const std::uint64_t scenario : waiting->second) {
            if (--scenarios_.at(scenario).missing == 0) {
                ready_.push_back(scenario);
            }
        }
        waiting_for_.erase(waiting);
    }
    evict();
    Messages messages = by_tree<Held>(std::move(held));
    if (!ranges_.empty() && has({0, top_root}) && has({1, top_root})) {
        std::vector<BlockId> wanted;
        for (const WorkUnit& range : std::exchange(ranges_, {})) {
            std::ranges::copy(begin(range), std::back_inserter(wanted));
        }
        std::ranges::move(by_tree<WantSubtrees>(std::move(wanted)), std::back_inserter(messages));
    }
    return messages;
}

void WorkerModel::pin(const BlockId& block) {
    if (cache_bytes_ == 0 || ++pins_[block] != 1) {
        return;
    }
    if (const auto idle = last_use_.find(block); idle != last_use_.end()) {
        idle_.erase({idle->second, block});
        last_use_.erase(idle);
    }
}

void WorkerModel::unpin(const BlockId& block) {
    if (cache_bytes_ == 0 || --pins_.at(block) != 0) {
        return;
    }
    pins_.erase(block);
    // Blocks of a dropped scenario may not have arrived yet.
    if (has(block)) {
        set_idle(block);
    }
}

void WorkerModel::set_idle(const BlockId& block) {
    idle_.emplace(++uses_, block);
    last_use_.emplace(block, uses_);
}

void WorkerModel::evict() {
    while (cache_bytes_ != 0 && memory_bytes_ > cache_bytes_ && !idle_.empty()) {
        const BlockId block = idle_.begin()->second;
        idle_.erase(idle_.begin());
        last_use_.erase(block);
        slot(block) = Slot::Absent;
        memory_bytes_ -= workload_.block(block).memory_bytes;
        evicted_.push_back(block);
    }
}

std::uint64_t WorkerModel::next() {
    CD_CHECK(!ready_.empty());
    const std::uint64_t scenario = ready_.front();
    ready_.pop_front();
    scenarios_.at(scenario).has_begun = true;
    return scenario;
}

void WorkerModel::ran(std::uint64_t scenario, double now, double seconds) {
    const auto place = scenarios_.find(scenario);
    CD_CHECK(place != scenarios_.end());
    Task& task = tasks_.at(place->second.task);
    for (const BlockId& block : workload_.scenario(scenario).blocks) {
        unpin(block);
    }
    evict();
    const bool is_called_off = place->second.is_called_off;
    scenarios_.erase(place);
    --task.open;
    if (is_called_off) {
        return;
    }
    if (task.unsent.empty()) {
        task.unsent_since = now;
    }
    task.unsent.push_back(scenario);
    task.compute_seconds += seconds;
}

bool WorkerModel::has_unsent() const {
    return std::ranges::any_of(tasks_,
                               [](const auto& task) { return !task.second.unsent.empty(); });
}

Messages WorkerModel::due(double now, double period) {
    Messages due;
    for (auto place = tasks_.begin(); place != tasks_.end();) {
        auto& [id, task] = *place;
        const bool has_ended = task.open == 0;
        const bool is_old = has_ended || now - task.unsent_since >= period;
        if (is_old && !task.unsent.empty()) {
            Results results;
            results.task = id;
            results.job = task.job;
            set_scenarios(results, std::exchange(task.unsent, {}));
            results.compute_seconds = std::exchange(task.compute_seconds, 0);
            results.sequence = ++sequence_;
            due.emplace_back(std::move(results));
        }
        if (has_ended) {
            due.emplace_back(EndOfTask{id});
        }
        place = has_ended ? tasks_.erase(place) : std::next(place);
    }
    return due;
}

} // namespace cd::bench
