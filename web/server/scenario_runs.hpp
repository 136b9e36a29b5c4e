// Runs scenarios for the page, one at a time.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "web/server/page_source.hpp"
#include "web/server/page_values.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace cd {

/// Runs one scenario at a time on a pool. The page asks for a scenario, its pairs and its points at
/// once, so one run answers all requests for a scenario, and the last scenarios are kept. All
/// members are called on the executor's thread.
class ScenarioRuns {
  public:
    /// A job's id and a scenario.
    using Key = std::pair<std::string, std::uint64_t>;
    using View = std::shared_ptr<const ScenarioView>;
    /// Runs a scenario, on a thread of the pool.
    using Run = std::function<Result<View>()>;

    /// The pool outlives this object, and runs what was posted before it ends.
    ScenarioRuns(asio::any_io_executor executor, Pool& pool);
    ScenarioRuns(const ScenarioRuns&) = delete;
    ScenarioRuns& operator=(const ScenarioRuns&) = delete;
    /// Drops all requests.
    ~ScenarioRuns();

    /// Calls `take` with the scenario, at once if it is kept. Errors: TooLarge if too many other
    /// scenarios wait; those of `run`.
    void ask(const Key& key, Run run, Take<View> take);

  private:
    struct State;
    std::shared_ptr<State> state_;
};

} // namespace cd
