// The order in which a job hands out its scenarios: consecutive scenarios touch nearly equal parts
// of the bodies.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/scenario.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace cd {

/// A range of consecutive positions in the job's hand-out order.
struct PositionRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;

    [[nodiscard]] std::uint64_t end() const { return first + count; }

    friend bool operator==(const PositionRange&, const PositionRange&) = default;
};

/// A job's scenarios as packed by `pack_in_order`: run k has the positions from
/// k * `limits::pose_run_scenarios` on. Any thread may call any member.
class PoseRuns {
  public:
    PoseRuns() = default;
    PoseRuns(const PoseRuns&) = delete;
    PoseRuns& operator=(const PoseRuns&) = delete;
    virtual ~PoseRuns() = default;

    /// Number of scenarios in all runs.
    [[nodiscard]] virtual std::uint64_t count() const = 0;
    /// Reads a run, which must exist. Errors: Io.
    [[nodiscard]] virtual Result<PackedScenarios> run(std::uint64_t number) const = 0;
};

/// A window of scenarios that are ordered together. They stay packed, and are accessible by
/// position in the job's hand-out order and by index as submitted.
class PoseWindow {
  public:
    /// `runs`: the window's runs; `first`: its first position, which is also its smallest index.
    /// Errors: BadFrame unless the runs have each index of the window once.
    [[nodiscard]] static Result<PoseWindow> open(std::uint64_t first,
                                                 std::vector<PackedScenarios> runs);

    [[nodiscard]] std::uint64_t first() const { return first_; }
    [[nodiscard]] std::uint64_t count() const { return positions_.size(); }
    [[nodiscard]] bool has(std::uint64_t index) const {
        return index >= first_ && index - first_ < count();
    }

    // ---- The position or index must be in the window --------------------------------------------
    [[nodiscard]] std::uint64_t position_of(std::uint64_t index) const {
        return first_ + positions_[index - first_];
    }
    [[nodiscard]] std::uint64_t index_at(std::uint64_t position) const;
    [[nodiscard]] ScenarioBodies bodies_at(std::uint64_t position) const;
    /// Unpacks the scenario at a position. Errors: those of `PackedScenarios::at`.
    [[nodiscard]] Result<Scenario> at(std::uint64_t position) const;
    /// Packs the scenarios at the positions as `pack_scenarios` does, without unpacking them.
    [[nodiscard]] Bytes packed(const PositionRange& positions) const;

  private:
    std::uint64_t first_ = 0;
    std::vector<PackedScenarios> runs_;
    std::vector<std::uint32_t> positions_; ///< Position - `first_`, by index - `first_`.
};

/// A job's scenarios by position in the hand-out order. Each window of
/// `limits::order_window_scenarios` consecutive scenarios is ordered by whoever packed it. A grid
/// keeps its order, because consecutive poses of a grid are similar. Any thread may call any
/// member.
class OrderedPoses {
  public:
    explicit OrderedPoses(const Grid& grid) : grid_(std::make_unique<const Grid>(grid)) {}
    explicit OrderedPoses(std::shared_ptr<const PoseRuns> runs) : runs_(std::move(runs)) {}

    [[nodiscard]] std::uint64_t count() const {
        return grid_ != nullptr ? grid_->count() : runs_->count();
    }
    /// The grid that gives the poses; null if there is none.
    [[nodiscard]] const Grid* grid() const { return grid_.get(); }
    /// Reads the scenarios at positions [first, first + count), which exist; each has its submitted
    /// index. Errors: Io, or BadInput naming a scenario without a valid pose.
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first, std::uint64_t count);
    /// Reads the scenarios with indices [first, first + count), which exist, in this order. Errors:
    /// those of `read`.
    [[nodiscard]] Result<std::vector<Scenario>> read_submitted(std::uint64_t first,
                                                               std::uint64_t count);

    /// Returns the window that contains a position, which exists. The job must not have a grid. A
    /// window orders scenarios among themselves, so it has an index where it has the position. The
    /// two windows used last are cached. Errors: Io.
    [[nodiscard]] Result<std::shared_ptr<const PoseWindow>> window_of(std::uint64_t position);

  private:
    std::unique_ptr<const Grid> grid_;
    std::shared_ptr<const PoseRuns> runs_;
    std::mutex mutex_;
    std::deque<std::shared_ptr<const PoseWindow>> kept_; ///< The most recently used is last.
};

} // namespace cd
