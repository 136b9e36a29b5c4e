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

/// An analysed unit lists the pairs of all its scenarios; otherwise descents find them one by one.
class TaskPairs {
  public:
    TaskPairs() = default;
    /// The pairs of scenario i are [offsets[i], offsets[i + 1]) of `pairs`.
    TaskPairs(std::vector<std::uint32_t> offsets, std::vector<RootPair> pairs)
        : offsets_(std::move(offsets)), pairs_(std::move(pairs)) {}

    void add(Walked::Waiting found) { found_.emplace(found.scenario, std::move(found.pairs)); }
    /// The pairs of the scenario must be known.
    [[nodiscard]] std::span<const RootPair> of(std::size_t scenario) const {
        if (offsets_.empty()) {
            return found_.at(scenario);
        }
        const std::uint32_t begin = offsets_[scenario];
        return std::span(pairs_).subspan(begin, offsets_[scenario + 1] - begin);
    }

  private:
    std::vector<std::uint32_t> offsets_; ///< Empty for a range.
    std::vector<RootPair> pairs_;
    std::unordered_map<std::size_t, std::vector<RootPair>> found_; ///< Of a range.
};

} // namespace cd
