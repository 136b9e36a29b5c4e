// The order in which a job's scenarios are handed out: neighbours touch nearly equal parts of
// bodies.
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

/// A range of consecutive places in a job's order.
struct PlaceRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;

    [[nodiscard]] std::uint64_t end() const { return first + count; }

    friend bool operator==(const PlaceRange&, const PlaceRange&) = default;
};

/// The scenarios of one window, accessible by place and by index.
class PoseWindow {
  public:
    /// Orders `scenarios`, given as submitted; their indices are consecutive.
    explicit PoseWindow(std::vector<Scenario> scenarios);

    /// Index of the window's first scenario, which is also the window's first place.
    [[nodiscard]] std::uint64_t first() const { return first_; }
    [[nodiscard]] std::span<const Scenario> at(const PlaceRange& places) const;
    /// Returns the place of a scenario of the window.
    [[nodiscard]] std::uint64_t place_of(std::uint64_t index) const;
    [[nodiscard]] bool has(std::uint64_t index) const {
        return index >= first_ && index - first_ < ordered_.size();
    }

  private:
    std::uint64_t first_ = 0;
    std::vector<Scenario> ordered_;
    std::vector<std::uint32_t> places_; ///< Places within the window, by index.
};

/// A job's scenarios by place. Each window of `limits::order_window_scenarios` consecutive
/// scenarios has the order of `coherent_order`, which depends on the window alone; a grid keeps its
/// order, since consecutive places are neighbours. Any thread may call any member.
class OrderedPoses final : public PoseSource {
  public:
    explicit OrderedPoses(std::shared_ptr<PoseSource> source);

    [[nodiscard]] std::uint64_t count() const override { return source_->count(); }
    [[nodiscard]] const Grid* grid() const override { return source_->grid(); }
    /// Reads scenarios by place; each names its index.
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Returns the window of an existing place. The source is no grid. The last windows are cached.
    /// Errors: the source's.
    [[nodiscard]] Result<std::shared_ptr<const PoseWindow>> window_of(std::uint64_t place);

  private:
    std::shared_ptr<PoseSource> source_;
    std::mutex mutex_;
    std::deque<std::shared_ptr<const PoseWindow>> kept_; ///< Ends with the last used.
};

} // namespace cd
