// Poses in memory, packed as a client packs them.
#pragma once

#include "common/job/poses/ordered_poses.hpp"
#include "common/job/poses/pose_order.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <span>
#include <vector>

namespace cd::tests {

/// The packed runs of scenarios, as a client sends them.
inline std::vector<Bytes> packed_runs(std::span<const Scenario> scenarios) {
    std::vector<Bytes> runs;
    while (!scenarios.empty()) {
        const std::size_t window =
            std::min<std::size_t>(scenarios.size(), limits::order_window_scenarios);
        for (Bytes& run : pack_in_order(scenarios.first(window))) {
            runs.push_back(std::move(run));
        }
        scenarios = scenarios.subspan(window);
    }
    return runs;
}

/// Counts reads. Reads fail for runs from `broken_from` on, and while `failures` is above 0, which
/// each of them lowers.
class PackedPoses final : public PoseRuns {
  public:
    explicit PackedPoses(std::span<const Scenario> scenarios)
        : count_(scenarios.size()), runs_(packed_runs(scenarios)) {}

    [[nodiscard]] std::uint64_t count() const override { return count_; }
    [[nodiscard]] Result<PackedScenarios> run(std::uint64_t number) const override {
        ++reads;
        const bool fails = failures > 0 && failures-- > 0;
        if (fails || number >= broken_from) {
            return Error{ErrorCode::Io, "the disk is gone"};
        }
        return PackedScenarios::open(runs_.at(number), limits::pose_run_scenarios);
    }

    mutable std::atomic<int> reads = 0;
    mutable std::atomic<int> failures = 0;
    std::uint64_t broken_from = UINT64_MAX;

  private:
    std::uint64_t count_ = 0;
    std::vector<Bytes> runs_;
};

inline std::shared_ptr<OrderedPoses> ordered(std::span<const Scenario> scenarios) {
    return std::make_shared<OrderedPoses>(std::make_shared<PackedPoses>(scenarios));
}

} // namespace cd::tests
