#include "common/job/poses/ordered_poses.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/poses/pose_order.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Scenarios of one window are handed out while results of the previous window return.
constexpr std::size_t windows_kept = 2;

} // namespace

PoseWindow::PoseWindow(std::vector<Scenario> scenarios) {
    CD_CHECK(!scenarios.empty());
    first_ = scenarios.front().index;
    ordered_.reserve(scenarios.size());
    places_.resize(scenarios.size());
    for (const std::uint32_t submitted : coherent_order(scenarios)) {
        places_[submitted] = static_cast<std::uint32_t>(ordered_.size());
        ordered_.push_back(scenarios[submitted]);
    }
}

std::span<const Scenario> PoseWindow::at(const PositionRange& places) const {
    CD_CHECK(places.first >= first_ && places.end() - first_ <= ordered_.size());
    return std::span(ordered_).subspan(places.first - first_, places.count);
}

std::uint64_t PoseWindow::place_of(std::uint64_t index) const {
    return first_ + places_[index - first_];
}

OrderedPoses::OrderedPoses(std::shared_ptr<PoseSource> source) : source_(std::move(source)) {}

Result<std::vector<Scenario>> OrderedPoses::read(std::uint64_t first, std::uint64_t count) {
    CD_CHECK(first <= this->count() && count <= this->count() - first);
    if (grid() != nullptr) {
        return source_->read(first, count);
    }
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    while (scenarios.size() < count) {
        const std::uint64_t next = first + scenarios.size();
        const auto window = window_of(next);
        if (!window) {
            return window.error();
        }
        const std::uint64_t window_end = window.value()->first() + limits::order_window_scenarios;
        const std::uint64_t some = std::min(first + count, window_end) - next;
        const auto found = window.value()->at({next, some});
        scenarios.insert(scenarios.end(), found.begin(), found.end());
    }
    return scenarios;
}

Result<std::shared_ptr<const PoseWindow>> OrderedPoses::window_of(std::uint64_t place) {
    CD_CHECK(place < count());
    const std::uint64_t first = place - place % limits::order_window_scenarios;
    // Holds the lock while the source is read: other callers need this window or have no other
    // work.
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(
        kept_.begin(), kept_.end(), [&](const auto& window) { return window->first() == first; });
    if (found != kept_.end()) {
        std::rotate(found, found + 1, kept_.end());
        return kept_.back();
    }
    Result<std::vector<Scenario>> scenarios =
        source_->read(first, std::min(limits::order_window_scenarios, count() - first));
    if (!scenarios) {
        return scenarios.error();
    }
    kept_.push_back(std::make_shared<const PoseWindow>(std::move(scenarios.value())));
    if (kept_.size() > windows_kept) {
        kept_.pop_front();
    }
    return kept_.back();
}

} // namespace cd
