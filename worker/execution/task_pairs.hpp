// The colliding pairs of roots of each scenario of a task.
#pragma once

#include "worker/execution/walk.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cd {

/// The pairs of all scenarios, as an analysed unit lists them, or those that descents have found.
class TaskPairs {
  public:
    TaskPairs() = default;
    /// The pairs of scenario i are [offsets[i], offsets[i + 1]) of `pairs`.
    TaskPairs(std::vector<std::uint32_t> offsets, std::vector<RootPair> pairs)
        : offsets_(std::move(offsets)), pairs_(std::move(pairs)) {}

    /// Sets the pairs that a scenario needs now, instead of those known before.
    void set(Walked::Waiting found) {
        const std::size_t scenario = found.scenario;
        found_.insert_or_assign(scenario, std::move(found));
    }
    /// The pairs of a scenario, which must be known.
    [[nodiscard]] std::span<const RootPair> of(std::size_t scenario) const {
        if (const auto found = found_.find(scenario); found != found_.end()) {
            return found->second.pairs;
        }
        const std::uint32_t begin = offsets_.at(scenario);
        return std::span(pairs_).subspan(begin, offsets_.at(scenario + 1) - begin);
    }
    /// Number of pairs that may have a scenario's answer, of which `of` has those needed now.
    [[nodiscard]] std::size_t named(std::size_t scenario) const {
        const auto found = found_.find(scenario);
        return found != found_.end() ? found->second.named : of(scenario).size();
    }
    /// Whether a further descent answers a scenario.
    [[nodiscard]] bool walks_again(std::size_t scenario) const {
        const auto found = found_.find(scenario);
        return found != found_.end() && found->second.walks_again;
    }

  private:
    std::vector<std::uint32_t> offsets_; ///< Empty unless the unit is analysed.
    std::vector<RootPair> pairs_;
    std::unordered_map<std::size_t, Walked::Waiting> found_; ///< What descents found.
};

} // namespace cd
