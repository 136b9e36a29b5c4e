// The order in which a job hands out its scenarios: consecutive scenarios touch nearly equal parts
// of the bodies.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/scenario.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace cd {

/// A range of consecutive positions in the job's hand-out order.
struct PositionRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;

    [[nodiscard]] std::uint64_t end() const { return first + count; }

    friend bool operator==(const PositionRange&, const PositionRange&) = default;
};

/// A window of consecutive scenarios that are ordered together. They are accessible by position in
/// the job's hand-out order and by index as submitted.
class PoseWindow {
  public:
    /// Orders `scenarios`, which are given in submitted order with consecutive indices.
    explicit PoseWindow(std::vector<Scenario> scenarios);

    /// Smallest index in the window, which is also the window's first position.
    [[nodiscard]] std::uint64_t first() const { return first_; }
    [[nodiscard]] std::span<const Scenario> at(const PositionRange& places) const;
    /// Returns the position of the scenario with the given index, which is in the window.
    [[nodiscard]] std::uint64_t place_of(std::uint64_t index) const;
    [[nodiscard]] bool has(std::uint64_t index) const {
        return index >= first_ && index - first_ < ordered_.size();
    }

  private:
    std::uint64_t first_ = 0;
    std::vector<Scenario> ordered_;
    std::vector<std::uint32_t> places_; ///< Position - `first_`, by index - `first_`.
};

/// A job's scenarios by position in the hand-out order. Each window of
/// `limits::order_window_scenarios` consecutive scenarios has the order of `coherent_order`, which
/// depends on the window alone. A grid keeps its order, because consecutive poses of a grid are
/// similar. Any thread may call any member.
class OrderedPoses final : public PoseSource {
  public:
    explicit OrderedPoses(std::shared_ptr<PoseSource> source);

    [[nodiscard]] std::uint64_t count() const override { return source_->count(); }
    [[nodiscard]] const Grid* grid() const override { return source_->grid(); }
    /// Reads the scenarios at positions [first, first + count); each has its submitted index.
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Returns the window that contains a position, which exists. The source must not be a grid.
    /// The two windows used last are cached. Errors: those of the source.
    [[nodiscard]] Result<std::shared_ptr<const PoseWindow>> window_of(std::uint64_t place);

  private:
    std::shared_ptr<PoseSource> source_;
    std::mutex mutex_;
    std::deque<std::shared_ptr<const PoseWindow>> kept_; ///< The most recently used is last.
};

} // namespace cd
