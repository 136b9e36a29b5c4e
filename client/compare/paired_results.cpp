#include "client/compare/paired_results.hpp"

#include "client/compare/matched_records.hpp"
#include "common/core/errors.hpp"

#include <string>
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
    const Status read = run.records.for_each([&](const KeptRecord& record) -> Status {
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

} // namespace

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
            }
            return take(pair);
        });
    if (!read || match.count() == earlier.scenarios) {
        return read;
    }
    return for_each_scenario(
        earlier, stop, [&](std::uint64_t index, const ScenarioResult* result) -> Status {
            return is_matched[index] ? Status(Done{})
                                     : take({index, std::nullopt, result, nullptr});
        });
}

} // namespace cd
