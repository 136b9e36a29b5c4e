#include "client/compare/paired_results.hpp"

#include "client/compare/matched_records.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// Calls `take` with each scenario of a run and its result, which is null if it has none.
Status for_each_scenario(const ReadRun& run,
                         const StopCheck& stop,
                         const std::function<Status(std::uint64_t, const ScenarioResult*)>& take) {
    std::uint64_t next = 0;
    const auto skip_to = [&](std::uint64_t end) -> Status {
        for (; next < end; ++next) {
            CD_TRY(take(next, nullptr));
        }
        return Done{};
    };
    const Status read = run.records.for_each([&](const RecordView& record) -> Status {
        if (stop && stop()) {
            return interrupted();
        }
        if (record.result.index >= run.scenarios) {
            return Error{ErrorCode::Io,
                         "the run has a record of scenario " + std::to_string(record.result.index) +
                             ", but only " + std::to_string(run.scenarios) + " scenarios"};
        }
        CD_TRY(skip_to(record.result.index));
        ++next;
        return take(record.result.index, &record.result);
    });
    return read ? skip_to(run.scenarios) : read;
}

/// Returns the result of a scenario of `tested` that follows for the other run.
std::optional<ScenarioResult>
result_by_boxes(const ReadRun& tested, const ReadRun& other, const ScenarioResult* result) {
    if (tested.apart == nullptr || other.apart == nullptr || result == nullptr) {
        return std::nullopt;
    }
    return other.apart->result_of(
        tested.apart->step_of(result->index), result->body_a, result->body_b);
}

} // namespace

ApartPairs::ApartPairs(std::shared_ptr<const StepIndex> steps,
                       std::vector<bool> are_fixed,
                       const Query& query,
                       bool has_rules_of_other)
    : steps_(std::move(steps)),
      are_fixed_(std::move(are_fixed)),
      has_rules_of_other_(has_rules_of_other) {
    separate_.level = query.level;
    separate_.question = query.question;
    separate_.has_clearance = query.clearance.has_value();
    separate_.kind = ScenarioClass::Separate;
}

std::optional<ScenarioResult>
ApartPairs::result_of(std::uint64_t step, std::uint32_t body_a, std::uint32_t body_b) const {
    if (step >= steps_->steps() || std::max(body_a, body_b) >= are_fixed_.size()) {
        return std::nullopt;
    }
    const StepCoverage& coverage = steps_->coverage()[step];
    const bool is_decided_before = step > 0 && are_fixed_[body_a] && are_fixed_[body_b];
    if (coverage.absent != 0 || (coverage.ignored != 0 && !has_rules_of_other_) ||
        is_decided_before) {
        return std::nullopt;
    }
    ScenarioResult result = separate_;
    result.body_a = body_a;
    result.body_b = body_b;
    result.step = step;
    return result;
}

Status for_each_pair(const ReadRun& earlier,
                     const ReadRun& later,
                     const ScenarioMatch& match,
                     const StopCheck& stop,
                     const std::function<Status(const PairedResult&)>& take) {
    MatchedRecords records(earlier.records, match, later.scenarios);
    std::vector<bool> is_matched(earlier.scenarios);
    const Status read = for_each_scenario(
        later, stop, [&](std::uint64_t index, const ScenarioResult* result) -> Status {
            PairedResult pair{match.earlier(index), index, nullptr, result};
            if (pair.earlier) {
                pair.was = CD_TRY(records.of(index));
                is_matched[*pair.earlier] = true;
                return take(pair);
            }
            const auto was = result_by_boxes(later, earlier, result);
            pair.was = was ? &*was : nullptr;
            return take(pair);
        });
    if (!read || match.count() == earlier.scenarios) {
        return read;
    }
    return for_each_scenario(
        earlier, stop, [&](std::uint64_t index, const ScenarioResult* result) -> Status {
            if (is_matched[index]) {
                return Done{};
            }
            const auto is = result_by_boxes(earlier, later, result);
            return take({index, std::nullopt, result, is ? &*is : nullptr});
        });
}

} // namespace cd
