#include "common/scene/step_index.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <utility>

namespace cd {

StepCoverage& StepCoverage::operator+=(const StepCoverage& other) {
    tested += other.tested;
    apart += other.apart;
    ignored += other.ignored;
    fixed += other.fixed;
    absent += other.absent;
    return *this;
}

void StepIndex::add_step(const StepCoverage& coverage) {
    ends_.push_back(count() + coverage.tested);
    coverage_.push_back(coverage);
}

void StepIndex::set_times(std::vector<double> times) {
    CD_CHECK(times.empty() || times.size() == ends_.size());
    times_ = std::move(times);
}

std::uint64_t StepIndex::first_of(std::uint64_t step) const {
    CD_CHECK(step < ends_.size());
    return step == 0 ? 0 : ends_[step - 1];
}

std::uint64_t StepIndex::end_of(std::uint64_t step) const {
    CD_CHECK(step < ends_.size());
    return ends_[step];
}

std::uint64_t StepIndex::step_of(std::uint64_t scenario) const {
    CD_CHECK(scenario < count());
    const auto end = std::ranges::upper_bound(ends_, scenario);
    return static_cast<std::uint64_t>(end - ends_.begin());
}

double StepIndex::time_of(std::uint64_t step) const {
    CD_CHECK(step < ends_.size());
    return times_.empty() ? static_cast<double>(step) : times_[step];
}

} // namespace cd
