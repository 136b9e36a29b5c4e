#include "web/server/scenario_runs.hpp"

#include "common/core/limits/web.hpp"

#include <algorithm>
#include <deque>
#include <vector>

namespace cd {

namespace {

struct WaitingRun {
    ScenarioRuns::Key key;
    ScenarioRuns::Run run;
    std::vector<Take<ScenarioRuns::View>> takers;
};

} // namespace

struct ScenarioRuns::State : std::enable_shared_from_this<State> {
    State(asio::any_io_executor executor_of_takers, Pool& pool_of_runs)
        : executor(std::move(executor_of_takers)), pool(pool_of_runs) {}

    /// Starts the first waiting run.
    void start() {
        pool.post([self = shared_from_this(), run = waiting.front().run] {
            Result<View> found = run();
            asio::post(self->executor, [self, found = std::move(found)] { self->ended(found); });
        });
    }

    void ended(const Result<View>& found) {
        if (waiting.empty()) {
            return; // The owner is gone.
        }
        const WaitingRun done = std::move(waiting.front());
        waiting.pop_front();
        if (!waiting.empty()) {
            start();
        }
        // A scenario without a result may get one.
        if (found && found.value()->result) {
            kept.emplace_back(done.key, found.value());
            if (kept.size() > limits::page_runs_kept) {
                kept.pop_front();
            }
        }
        for (const auto& take : done.takers) {
            take(found);
        }
    }

    asio::any_io_executor executor;
    Pool& pool;
    std::deque<WaitingRun> waiting; ///< The first is running.
    std::deque<std::pair<Key, View>> kept;
};

ScenarioRuns::ScenarioRuns(asio::any_io_executor executor, Pool& pool)
    : state_(std::make_shared<State>(std::move(executor), pool)) {}

ScenarioRuns::~ScenarioRuns() {
    state_->waiting.clear();
}

void ScenarioRuns::ask(const Key& key, Run run, Take<View> take) {
    const auto kept = std::ranges::find(state_->kept, key, &std::pair<Key, View>::first);
    if (kept != state_->kept.end()) {
        return take(kept->second);
    }
    const auto same = std::ranges::find(state_->waiting, key, &WaitingRun::key);
    if (same != state_->waiting.end()) {
        same->takers.push_back(std::move(take));
        return;
    }
    if (state_->waiting.size() > limits::page_runs_waiting_max) {
        return take(Error{ErrorCode::TooLarge, "other scenarios are being run; try again"});
    }
    state_->waiting.push_back({key, std::move(run), {std::move(take)}});
    if (state_->waiting.size() == 1) {
        state_->start();
    }
}

} // namespace cd
