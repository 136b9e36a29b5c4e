// The colliding pairs of roots of each scenario of a task.
#pragma once

#include "worker/execution/descent.hpp"

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

    void add(DescentResult::Waiting found) {
        found_.emplace(found.scenario, std::move(found.pairs));
    }
    /// The pairs of a scenario, which must be known.
    [[nodiscard]] std::span<const RootPair> of(std::size_t scenario) const {
        if (offsets_.empty()) {
            return found_.at(scenario);
        }
        const std::uint32_t begin = offsets_[scenario];
        return std::span(pairs_).subspan(begin, offsets_[scenario + 1] - begin);
    }

  private:
    std::vector<std::uint32_t> offsets_; ///< Empty unless the unit is analysed.
    std::vector<RootPair> pairs_;
    std::unordered_map<std::size_t, std::vector<RootPair>> found_; ///< Pairs that descents found.
};

} // namespace cd
