#include "common/job/poses/made_poses.hpp"

#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/timing/engine.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <utility>

namespace cd {

namespace {

/// A window of consecutive scenarios. One thread computes it; others read it once it `is_whole`.
struct Window {
    std::vector<Scenario> scenarios;
    bool is_whole = false;
};

class ComputedSource final : public PoseSource {
  public:
    ComputedSource(std::uint64_t count, ScenarioMaker maker, unsigned threads, StopCheck stopped)
        : count_(count), maker_(std::move(maker)), stopped_(std::move(stopped)), pool_(threads) {}
    ~ComputedSource() override { is_ending_ = true; }

    [[nodiscard]] std::uint64_t count() const override { return count_; }

    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        CD_CHECK(first <= count_);
        CD_CHECK(count <= count_ - first);
        if (count == 1) {
            return std::vector<Scenario>{maker_(first)};
        }
        std::vector<Scenario> scenarios;
        scenarios.reserve(count);
        while (scenarios.size() < count) {
            const std::uint64_t index = first + scenarios.size();
            order_windows(index / window_size);
            const auto window = wait_for(index / window_size);
            if (!window) {
                return window.error();
            }
            const auto& whole = window.value()->scenarios;
            const std::uint64_t skipped = index % window_size;
            const std::uint64_t taken =
                std::min<std::uint64_t>(whole.size() - skipped, count - scenarios.size());
            const auto from = whole.begin() + static_cast<std::ptrdiff_t>(skipped);
            scenarios.insert(scenarios.end(), from, from + static_cast<std::ptrdiff_t>(taken));
        }
        return scenarios;
    }

  private:
    static constexpr std::uint64_t window_size = limits::computed_window_scenarios;

    /// Drops all windows except numbers [first, first + `computed_windows_max`), and schedules the
    /// computation of missing windows with these numbers.
    void order_windows(std::uint64_t first) {
        const std::uint64_t windows = (count_ + window_size - 1) / window_size;
        const std::uint64_t end = std::min(first + limits::computed_windows_max, windows);
        const std::lock_guard lock(mutex_);
        std::erase_if(windows_,
                      [&](const auto& entry) { return entry.first < first || entry.first >= end; });
        for (std::uint64_t number = first; number < end; ++number) {
            auto& window = windows_[number];
            if (window == nullptr) {
                window = std::make_shared<Window>();
                pool_.post([this, number, window] { compute(number, *window); });
            }
        }
    }

    void compute(std::uint64_t number, Window& window) {
        const std::uint64_t first = number * window_size;
        std::vector<Scenario> scenarios;
        for (std::uint64_t i = first; i < std::min(first + window_size, count_); ++i) {
            if (is_ending_) {
                return;
            }
            scenarios.push_back(maker_(i));
        }
        const std::lock_guard lock(mutex_);
        window.scenarios = std::move(scenarios);
        window.is_whole = true;
        window_came_.notify_all();
    }

    [[nodiscard]] Result<std::shared_ptr<const Window>> wait_for(std::uint64_t number) {
        std::unique_lock lock(mutex_);
        const std::shared_ptr<const Window> window = windows_.at(number);
        while (!window_came_.wait_for(
            lock, timing::stop_check_period, [&] { return window->is_whole; })) {
            if (stopped_()) {
                return interrupted();
            }
        }
        return window;
    }

    std::uint64_t count_;
    ScenarioMaker maker_;
    StopCheck stopped_;
    std::atomic<bool> is_ending_ = false;
    std::mutex mutex_;
    std::condition_variable window_came_;
    std::map<std::uint64_t, std::shared_ptr<Window>> windows_; ///< By window number.
    ThreadPool pool_; ///< Declared last, so that its threads end before the members they use.
};

} // namespace

std::unique_ptr<PoseSource> make_computed_source(std::uint64_t count,
                                                 ScenarioMaker maker,
                                                 unsigned threads,
                                                 StopCheck stopped) {
    return std::make_unique<ComputedSource>(count, std::move(maker), threads, std::move(stopped));
}

} // namespace cd
