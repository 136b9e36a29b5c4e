#include "master/journal/ledger.hpp"

#include "common/core/check.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <utility>

namespace cd {

Ledger::Block& Ledger::block_of(Job& job, std::uint64_t scenario) {
    std::unique_ptr<Block>& block = job.blocks[scenario / block_scenarios];
    if (block == nullptr) {
        block = std::make_unique<Block>();
    }
    return *block;
}

void Ledger::open_job(JobId job) {
    const bool is_new = jobs_.try_emplace(job).second;
    CD_CHECK(is_new);
}

void Ledger::close_job(JobId job) {
    jobs_.erase(job);
}

void Ledger::restore(JobId job, std::uint64_t scenario) {
    Job& entry = jobs_.at(job);
    Block& block = block_of(entry, scenario);
    const std::uint64_t bit = scenario % block_scenarios;
    CD_CHECK(!block.written[bit]);
    block.written.set(bit);
    block.durable.set(bit);
    ++entry.durable;
}

template <class Take>
void Ledger::for_each_bit(Job& job, std::uint64_t first, std::uint64_t end, const Take& take) {
    while (first < end) {
        Block& block = block_of(job, first);
        const std::uint64_t bit = first % block_scenarios;
        const std::uint64_t bits = std::min(end - first, block_scenarios - bit);
        for (std::uint64_t i = bit; i < bit + bits; ++i) {
            take(block, i);
        }
        first += bits;
    }
}

void Ledger::write(JobId job, std::uint64_t first, std::uint64_t position, std::uint64_t count) {
    CD_CHECK(position > committed_);
    CD_CHECK(entries_.empty() || entries_.back().position <= position);
    for_each_bit(jobs_.at(job), first, first + count, [](Block& block, std::uint64_t bit) {
        CD_CHECK(!block.written[bit]);
        block.written.set(bit);
    });
    entries_.push_back({position, job, first, count});
}

void Ledger::withdraw(JobId id, std::span<const std::uint64_t> scenarios) {
    if (scenarios.empty()) {
        return;
    }
    Job& job = jobs_.at(id);
    for (const std::uint64_t scenario : scenarios) {
        Block& block = block_of(job, scenario);
        const std::uint64_t bit = scenario % block_scenarios;
        CD_CHECK(block.written[bit]);
        job.durable -= block.durable[bit] ? 1 : 0;
        block.written.reset(bit);
        block.durable.reset(bit);
    }
    for (const Entry& entry : std::exchange(entries_, {})) {
        if (entry.job != id) {
            entries_.push_back(entry);
            continue;
        }
        // A withdrawn scenario may be written again, so its old entry must not keep it.
        for (std::uint64_t scenario = entry.first; scenario < entry.end(); ++scenario) {
            if (state(id, scenario) != State::Unknown) {
                entries_.push_back({entry.position, id, scenario, 1});
            }
        }
    }
}

void Ledger::promise(const Promise& promise, std::uint64_t position) {
    const bool is_early =
        (mutated(Mutation::JobAcceptedTooEarly) && std::holds_alternative<JobAccepted>(promise)) ||
        (mutated(Mutation::EndToldTooEarly) && std::holds_alternative<JobEnded>(promise));
    if (position <= committed_ || is_early) {
        kept_.push_back(promise);
    } else {
        promises_.emplace(position, promise);
    }
}

void Ledger::promise(const Delivery& delivery,
                     JobId job,
                     std::span<const std::uint64_t> scenarios) {
    const bool is_pending =
        std::any_of(scenarios.begin(), scenarios.end(), [&](std::uint64_t scenario) {
            return state(job, scenario) == State::Written && !mutated(Mutation::AnswerKeptTooEarly);
        });
    // Waits for the last uncommitted entry: no entry of these scenarios comes after it.
    promise(delivery, is_pending ? entries_.back().position : committed_);
}

void Ledger::forget(WorkerId worker) {
    const auto is_its = [&](const Promise& promise) {
        const auto* delivery = std::get_if<Delivery>(&promise);
        return delivery != nullptr && delivery->worker == worker;
    };
    std::erase_if(promises_, [&](const auto& entry) { return is_its(entry.second); });
    std::erase_if(kept_, is_its);
}

void Ledger::committed(std::uint64_t position) {
    CD_CHECK(position >= committed_);
    committed_ = position;
    for (; !entries_.empty() && entries_.front().position <= position; entries_.pop_front()) {
        const Entry& entry = entries_.front();
        const auto job = jobs_.find(entry.job);
        if (job != jobs_.end()) {
            for_each_bit(job->second,
                         entry.first,
                         entry.end(),
                         [](Block& block, std::uint64_t bit) { block.durable.set(bit); });
            job->second.durable += entry.count;
        }
    }
    const auto end = promises_.upper_bound(position);
    for (auto promise = promises_.begin(); promise != end; ++promise) {
        kept_.push_back(promise->second);
    }
    promises_.erase(promises_.begin(), end);
}

std::vector<Promise> Ledger::take_kept() {
    return std::exchange(kept_, {});
}

Ledger::State Ledger::state(JobId job, std::uint64_t scenario) const {
    const auto found = jobs_.find(job);
    if (found == jobs_.end()) {
        return State::Unknown;
    }
    const auto block = found->second.blocks.find(scenario / block_scenarios);
    if (block == found->second.blocks.end()) {
        return State::Unknown;
    }
    const std::uint64_t bit = scenario % block_scenarios;
    return block->second->durable[bit]   ? State::Durable
           : block->second->written[bit] ? State::Written
                                         : State::Unknown;
}

std::uint64_t Ledger::durable(JobId job) const {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? 0 : found->second.durable;
}

void Ledger::check_invariants() const {
    std::unordered_map<JobId, std::uint64_t> written;
    std::uint64_t before = committed_;
    for (const Entry& entry : entries_) {
        CD_CHECK(entry.position > committed_);
        CD_CHECK(entry.position >= before);
        before = entry.position;
        for (std::uint64_t scenario = entry.first;
             jobs_.contains(entry.job) && scenario < entry.end();
             ++scenario) {
            CD_CHECK(state(entry.job, scenario) == State::Written);
            ++written[entry.job];
        }
    }
    for (const auto& [id, job] : jobs_) {
        std::uint64_t durable = 0;
        std::uint64_t known = 0;
        for (const auto& [number, block] : job.blocks) {
            CD_CHECK((block->durable & ~block->written).none());
            durable += block->durable.count();
            known += block->written.count();
        }
        CD_CHECK(durable == job.durable);
        CD_CHECK(known - durable == written[id]);
    }
    for (const auto& [position, promise] : promises_) {
        CD_CHECK(position > committed_);
    }
}

} // namespace cd
