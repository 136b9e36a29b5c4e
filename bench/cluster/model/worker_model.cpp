#include "bench/cluster/model/worker_model.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/worker.hpp"

#include <algorithm>
#include <utility>

namespace cd::bench {

WorkerModel::WorkerModel(WorkerId id, const Workload& workload, std::uint64_t cache_bytes)
    : id_(id), workload_(workload), cache_bytes_(cache_bytes) {
    for (std::size_t tree = 0; tree < slots_.size(); ++tree) {
        slots_[tree].resize(workload.trees[tree].size(), Slot::Absent);
    }
}

std::optional<BlocksWanted> WorkerModel::take(const BatchSent& batch) {
    BlocksWanted wanted{id_, {}};
    tasks_[batch.task].open = batch.scenarios.size();
    for (const std::uint64_t scenario : batch.scenarios) {
        std::size_t missing = 0;
        for (const BlockId& block : workload_.scenario(scenario).blocks) {
            Slot& slot = slots_[block.tree][block.root];
            pin(block);
            if (slot == Slot::Here) {
                continue;
            }
            if (slot == Slot::Absent) {
                want(block, wanted);
            }
            waiting_for_[block].push_back(scenario);
            ++missing;
        }
        const bool is_new = scenarios_.emplace(scenario, Waiting{batch.task, missing}).second;
        CD_CHECK(is_new);
        if (missing == 0) {
            ready_.push_back(scenario);
        }
    }
    std::ranges::sort(wanted.blocks);
    return wanted.blocks.empty() ? std::nullopt : std::optional(std::move(wanted));
}

void WorkerModel::take(const Hinted& hint) {
    hinted_.insert(hinted_.end(), hint.blocks.begin(), hint.blocks.end());
}

std::optional<BlocksWanted> WorkerModel::ahead() {
    BlocksWanted wanted{id_, {}};
    const bool needs_some = std::ranges::any_of(
        waiting_for_, [](const auto& waiting) { return !waiting.second.empty(); });
    while (!needs_some && !hinted_.empty() && wanted_bytes_ < limits::hinted_bytes_max) {
        const BlockId block = hinted_.front();
        hinted_.pop_front();
        const std::uint64_t bytes =
            memory_bytes_ + wanted_bytes_ + workload_.block(block).memory_bytes;
        const bool has_room = cache_bytes_ == 0 || bytes <= cache_bytes_;
        if (has_room && slots_[block.tree][block.root] == Slot::Absent) {
            want(block, wanted);
        }
    }
    std::ranges::sort(wanted.blocks);
    return wanted.blocks.empty() ? std::nullopt : std::optional(std::move(wanted));
}

void WorkerModel::want(const BlockId& block, BlocksWanted& wanted) {
    slots_[block.tree][block.root] = Slot::Wanted;
    wanted_bytes_ += workload_.block(block).memory_bytes;
    wanted.blocks.push_back(block);
}

GaveBack WorkerModel::take(const AskedBack& asked) {
    const auto task = tasks_.find(asked.task);
    if (task == tasks_.end()) {
        return {id_, asked.task, {}};
    }
    for (const std::uint64_t scenario : asked.scenarios) {
        const auto place = scenarios_.find(scenario);
        if (place != scenarios_.end() && place->second.task == asked.task &&
            !place->second.has_begun) {
            drop(scenario);
            task->second.given_back.insert(scenario);
        }
    }
    const auto& given_back = task->second.given_back;
    return {id_, asked.task, {given_back.begin(), given_back.end()}};
}

bool WorkerModel::take(const CalledOff& loser) {
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
    std::erase(ready_, scenario);
    for (const BlockId& block : workload_.scenario(scenario).blocks) {
        if (const auto waiting = waiting_for_.find(block); waiting != waiting_for_.end()) {
            std::erase(waiting->second, scenario);
        }
        unpin(block);
    }
    --tasks_.at(scenarios_.at(scenario).task).open;
    scenarios_.erase(scenario);
}

double WorkerModel::open_seconds(const BlocksSent& message) const {
    double seconds = 0;
    for (const BlockId& block : message.blocks) {
        seconds += workload_.block(block).open_seconds;
    }
    return seconds;
}

BlocksHeld WorkerModel::opened(const BlocksSent& message) {
    BlocksHeld held{id_, {}};
    for (const BlockId& block : message.blocks) {
        Slot& slot = slots_[block.tree][block.root];
        // The master also sends a block that a slow peer was to give.
        if (slot != Slot::Wanted) {
            continue;
        }
        slot = Slot::Here;
        held.blocks.push_back(block);
        ++received_blocks_;
        memory_bytes_ += workload_.block(block).memory_bytes;
        wanted_bytes_ -= workload_.block(block).memory_bytes;
        if (cache_bytes_ != 0 && !pins_.contains(block)) {
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
    return held;
}

std::optional<BlocksEvicted> WorkerModel::evicted() {
    if (evicted_.empty()) {
        return std::nullopt;
    }
    BlocksEvicted evicted{id_, std::exchange(evicted_, {})};
    std::ranges::sort(evicted.blocks);
    return evicted;
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
        slots_[block.tree][block.root] = Slot::Absent;
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

std::vector<ResultsSent> WorkerModel::due(double now, double period) {
    std::vector<ResultsSent> due;
    for (auto place = tasks_.begin(); place != tasks_.end();) {
        auto& [id, task] = *place;
        const bool has_ended = task.open == 0;
        const bool is_old = !task.unsent.empty() && now - task.unsent_since >= period;
        if (has_ended || is_old) {
            due.push_back({id_,
                           id,
                           std::exchange(task.unsent, {}),
                           std::exchange(task.compute_seconds, 0),
                           has_ended});
        }
        place = has_ended ? tasks_.erase(place) : std::next(place);
    }
    return due;
}

} // namespace cd::bench
