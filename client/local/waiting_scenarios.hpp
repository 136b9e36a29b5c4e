// Scenarios that wait for a thread, in order.
#pragma once

#include "common/job/scenario.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace cd {

/// A queue of scenarios by index. Moves whole blocks where it can.
class WaitingScenarios {
  public:
    /// Scenarios that are added in pieces are joined to blocks of at most `block_max`.
    explicit WaitingScenarios(std::size_t block_max) : block_max_(block_max) {}

    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Returns the least index. There is a scenario.
    [[nodiscard]] std::uint64_t first() const;

    /// Adds scenarios that follow all others. Their indices are consecutive.
    void add(std::vector<Scenario> scenarios);
    /// Adds the last ones of those that a call of `take` returned.
    void give_back(std::vector<Scenario> scenarios);
    /// Takes the first scenarios: at most `count`, 1 or more, and at least one. There is one. Their
    /// indices are consecutive.
    [[nodiscard]] std::vector<Scenario> take(std::size_t count);

  private:
    /// Scenarios from position `begin` on; at least one. Later blocks have higher indices.
    struct Block {
        std::vector<Scenario> scenarios;
        std::size_t begin = 0;
        [[nodiscard]] std::size_t size() const { return scenarios.size() - begin; }
    };

    [[nodiscard]] bool fits_behind(const std::vector<Scenario>& first,
                                   const std::vector<Scenario>& second) const;

    std::size_t block_max_;
    std::deque<Block> blocks_;
    std::size_t size_ = 0;
};

} // namespace cd
