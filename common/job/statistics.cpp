#include "common/job/statistics.hpp"

#include <chrono>

namespace cd {

InsideStatistics& InsideStatistics::operator+=(const InsideStatistics& other) {
    scenarios += other.scenarios;
    seconds += other.seconds;
    work += other.work;
    return *this;
}

JobStatistics& JobStatistics::operator+=(const JobStatistics& other) {
    search += other.search;
    inside += other.inside;
    return *this;
}

InsideStatistics settle_with_cost(const ObbTree& a,
                                  const ObbTree& b,
                                  const Scenario& scenario,
                                  const Query& query,
                                  ScenarioResult& result,
                                  const SettleOptions& options) {
    using Clock = std::chrono::steady_clock;
    const bool is_work = settling_is_work(a, b, result);
    const Clock::time_point start = is_work ? Clock::now() : Clock::time_point();
    const SettleStatistics work = settle_class(a, b, scenario, query, result, options);
    if (!is_work) {
        return {0, 0, work};
    }
    return {1, std::chrono::duration<double>(Clock::now() - start).count(), work};
}

} // namespace cd
