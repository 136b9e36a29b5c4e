#include "common/job/poses/ordered_poses.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace cd {

namespace {

/// Scenarios of one window are handed out while results of the previous window return.
constexpr std::size_t windows_kept = 2;

constexpr std::uint32_t no_position = UINT32_MAX;

} // namespace

// ---- PoseWindow ---------------------------------------------------------------------------------

Result<PoseWindow> PoseWindow::open(std::uint64_t first, std::vector<PackedScenarios> runs) {
    PoseWindow window;
    window.first_ = first;
    std::uint64_t count = 0;
    for (const PackedScenarios& run : runs) {
        if (count % limits::pose_run_scenarios != 0) {
            return Error{ErrorCode::BadFrame, "a run before the last is short"};
        }
        count += run.count();
    }
    window.positions_.assign(count, no_position);
    std::uint32_t position = 0;
    for (const PackedScenarios& run : runs) {
        for (std::uint64_t i = 0; i < run.count(); ++i) {
            const std::uint64_t index = run.index_at(i);
            if (!window.has(index) || window.positions_[index - first] != no_position) {
                return Error{ErrorCode::BadFrame,
                             "scenario " + std::to_string(index) +
                                 " is not of its window, or is there twice"};
            }
            window.positions_[index - first] = position++;
        }
    }
    window.runs_ = std::move(runs);
    return window;
}

std::uint64_t PoseWindow::index_at(std::uint64_t position) const {
    const std::uint64_t from = position - first_;
    return runs_[from / limits::pose_run_scenarios].index_at(from % limits::pose_run_scenarios);
}

ScenarioBodies PoseWindow::bodies_at(std::uint64_t position) const {
    const std::uint64_t from = position - first_;
    return runs_[from / limits::pose_run_scenarios].bodies_at(from % limits::pose_run_scenarios);
}

Result<Scenario> PoseWindow::at(std::uint64_t position) const {
    const std::uint64_t from = position - first_;
    return runs_[from / limits::pose_run_scenarios].at(from % limits::pose_run_scenarios);
}

Bytes PoseWindow::packed(const PositionRange& positions) const {
    CD_CHECK(positions.first >= first_ && positions.end() - first_ <= count());
    std::vector<PackedScenarios::Slice> slices;
    std::uint64_t next = positions.first - first_;
    const std::uint64_t end = positions.end() - first_;
    while (next < end) {
        const std::uint64_t skipped = next % limits::pose_run_scenarios;
        const std::uint64_t some = std::min(limits::pose_run_scenarios - skipped, end - next);
        slices.push_back({&runs_[next / limits::pose_run_scenarios], skipped, some});
        next += some;
    }
    return PackedScenarios::join(slices);
}

// ---- OrderedPoses -------------------------------------------------------------------------------

namespace {

/// Reads `count` scenarios from `first` on; `in_window` reads one from its window. On a grid,
/// position and index are equal.
Result<std::vector<Scenario>>
read_each(OrderedPoses& poses, std::uint64_t first, std::uint64_t count, const auto& in_window) {
    CD_CHECK(first <= poses.count() && count <= poses.count() - first);
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    std::shared_ptr<const PoseWindow> window;
    for (std::uint64_t next = first; next < first + count; ++next) {
        if (poses.grid() != nullptr) {
            scenarios.push_back(scenario_on(*poses.grid(), next));
            continue;
        }
        if (window == nullptr || !window->has(next)) {
            auto found = poses.window_of(next);
            if (!found) {
                return found.error();
            }
            window = std::move(found.value());
        }
        Result<Scenario> scenario = in_window(*window, next);
        if (!scenario) {
            return scenario.error();
        }
        scenarios.push_back(scenario.value());
    }
    return scenarios;
}

} // namespace

Result<std::vector<Scenario>> OrderedPoses::read(std::uint64_t first, std::uint64_t count) {
    return read_each(*this, first, count, [](const PoseWindow& window, std::uint64_t position) {
        return window.at(position);
    });
}

Result<std::vector<Scenario>> OrderedPoses::read_submitted(std::uint64_t first,
                                                           std::uint64_t count) {
    return read_each(*this, first, count, [](const PoseWindow& window, std::uint64_t index) {
        return window.at(window.position_of(index));
    });
}

Result<std::shared_ptr<const PoseWindow>> OrderedPoses::window_of(std::uint64_t position) {
    CD_CHECK(position < count());
    const std::uint64_t first = position - position % limits::order_window_scenarios;
    // Holds the lock while the runs are read: other callers need this window or have no other work.
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(
        kept_.begin(), kept_.end(), [&](const auto& window) { return window->first() == first; });
    if (found != kept_.end()) {
        std::rotate(found, found + 1, kept_.end());
        return kept_.back();
    }
    std::vector<PackedScenarios> runs;
    const std::uint64_t end = std::min(first + limits::order_window_scenarios, count());
    for (std::uint64_t next = first; next < end; next += limits::pose_run_scenarios) {
        Result<PackedScenarios> run = runs_->run(next / limits::pose_run_scenarios);
        if (!run) {
            return run.error();
        }
        runs.push_back(std::move(run.value()));
    }
    Result<PoseWindow> window = PoseWindow::open(first, std::move(runs));
    if (!window) {
        return Error{ErrorCode::Io, "damaged poses: " + window.error().detail};
    }
    kept_.push_back(std::make_shared<const PoseWindow>(std::move(window.value())));
    if (kept_.size() > windows_kept) {
        kept_.pop_front();
    }
    return kept_.back();
}

} // namespace cd
