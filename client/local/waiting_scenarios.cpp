#include "client/local/waiting_scenarios.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cd {

std::uint64_t WaitingScenarios::first() const {
    const Block& block = blocks_.front();
    return block.scenarios[block.begin].index;
}

/// Returns whether the second scenarios follow the first ones, and both make no more than a block.
bool WaitingScenarios::fits_behind(const std::vector<Scenario>& first,
                                   const std::vector<Scenario>& second) const {
    return first.size() + second.size() <= block_max_ &&
           first.back().index + 1 == second.front().index;
}

void WaitingScenarios::add(std::vector<Scenario> scenarios) {
    if (scenarios.empty()) {
        return;
    }
    size_ += scenarios.size();
    if (!blocks_.empty() && fits_behind(blocks_.back().scenarios, scenarios)) {
        auto& last = blocks_.back().scenarios;
        last.reserve(block_max_);
        std::ranges::move(scenarios, std::back_inserter(last));
        return;
    }
    blocks_.push_back({std::move(scenarios), 0});
}

void WaitingScenarios::give_back(std::vector<Scenario> scenarios) {
    if (scenarios.empty()) {
        return;
    }
    size_ += scenarios.size();
    const auto after = std::ranges::find_if(blocks_, [&](const Block& block) {
        return block.scenarios[block.begin].index > scenarios.front().index;
    });
    blocks_.insert(after, {std::move(scenarios), 0});
}

std::vector<Scenario> WaitingScenarios::take(std::size_t count) {
    Block& block = blocks_.front();
    std::vector<Scenario> taken;
    if (block.size() <= count && block.begin == 0) {
        taken = std::move(block.scenarios);
    } else {
        const auto begin = block.scenarios.begin() + static_cast<std::ptrdiff_t>(block.begin);
        const auto end = begin + static_cast<std::ptrdiff_t>(std::min(count, block.size()));
        taken.assign(std::move_iterator(begin), std::move_iterator(end));
        block.begin += taken.size();
    }
    if (block.size() == 0) {
        blocks_.pop_front();
    }
    size_ -= taken.size();
    return taken;
}

} // namespace cd
