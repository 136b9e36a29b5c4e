// The order in which a job's scenarios are handed out: neighbours touch the same parts.
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

/// Consecutive places of a job's order.
struct PlaceRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;

    [[nodiscard]] std::uint64_t end() const { return first + count; }

    friend bool operator==(const PlaceRange&, const PlaceRange&) = default;
};

/// The scenarios of one window, by place and by index.
class PoseWindow {
  public:
    /// `scenarios` as submitted; their indices are consecutive.
    explicit PoseWindow(std::vector<Scenario> scenarios);

    /// The index of its first scenario, which is also its first place.
    [[nodiscard]] std::uint64_t first() const { return first_; }
    [[nodiscard]] std::span<const Scenario> at(const PlaceRange& places) const;
    /// The place of a scenario; the window has it.
    [[nodiscard]] std::uint64_t place_of(std::uint64_t index) const;
    [[nodiscard]] bool has(std::uint64_t index) const {
        return index >= first_ && index - first_ < ordered_.size();
    }

  private:
    std::uint64_t first_ = 0;
    std::vector<Scenario> ordered_;
    std::vector<std::uint32_t> places_; ///< In the window, by index.
};

/// A job's scenarios by place. Each window of `limits::order_window_scenarios` consecutive
/// scenarios is in the order of `coherent_order`, which is a function of the window alone; a grid
/// stays as it is, since its neighbours are neighbours. Any thread may call any member.
class OrderedPoses final : public PoseSource {
  public:
    explicit OrderedPoses(std::shared_ptr<PoseSource> source);

    [[nodiscard]] std::uint64_t count() const override { return source_->count(); }
    [[nodiscard]] const Grid* grid() const override { return source_->grid(); }
    /// By place; the scenarios name their indices.
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// The window of a place that exists. Not of a grid. The last ones are kept. Errors: the
    /// source's.
    [[nodiscard]] Result<std::shared_ptr<const PoseWindow>> window_of(std::uint64_t place);

  private:
    std::shared_ptr<PoseSource> source_;
    std::mutex mutex_;
    std::deque<std::shared_ptr<const PoseWindow>> kept_; ///< The last used at the end.
};

} // namespace cd
