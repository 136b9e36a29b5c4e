#include "master/dispatch/job/job_meters.hpp"

#include "common/core/limits/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void RangePace::add(WorkerId worker, std::uint64_t scenarios, double seconds) {
    general_.add(static_cast<double>(scenarios), seconds);
    of_workers_[worker].add(static_cast<double>(scenarios), seconds);
}

double RangePace::per_thread(WorkerId worker, double otherwise) const {
    const double general = general_.value_or(otherwise);
    const auto own = of_workers_.find(worker);
    return own == of_workers_.end() ? general : own->second.value_or(general);
}

void ScenarioAverage::add(double sum, double scenarios) {
    constexpr double kept = 0.9;
    sum_ = kept * sum_ + sum;
    scenarios_ = kept * scenarios_ + scenarios;
}

std::optional<double> ScenarioAverage::value() const {
    return scenarios_ > 0 ? std::optional(sum_ / scenarios_) : std::nullopt;
}

void MissingMeter::add_sample(double seconds_any) {
    any_.add(seconds_any, 1);
    if (held_ > 1) { // Nothing was matched before the first sample.
        matched_.add(seconds_, period);
    }
    seconds_ = 0;
}

void MissingMeter::ranges_answered(std::uint64_t scenarios) {
    any_.add(std::exchange(in_ranges_, 0), static_cast<double>(scenarios));
}

void MissingMeter::tell(MissingCosts& costs) const {
    if (matched_.value() && any_.value()) {
        costs.matched = matched_.value();
        costs.any = any_.value();
    }
}

void CopyBudget::remove_work(std::uint64_t cost_ns) {
    work_ns_ -= std::min(work_ns_, cost_ns);
}

std::uint64_t CopyBudget::left_ns() const {
    const auto most =
        static_cast<std::uint64_t>(limits::copies_share_max * static_cast<double>(work_ns_));
    return most - std::min(most, copied_ns_);
}

} // namespace cd
