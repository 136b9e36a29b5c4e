// Reads results that a master sends.
#pragma once

#include "common/core/result.hpp"
#include "common/job/result/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace cd {

/// A result and its place in a query: the scenario, or with a sample the place in it.
struct PlacedResult {
    std::uint64_t place = 0;
    ScenarioResult result;
};

/// Returns the results of places [query.first, part.next) in order. `part` is untrusted; it must
/// begin at `query.first` and cover 1 to `query.count` places. `scenarios` is the job's number of
/// them, which only a sample needs. Errors: BadFrame if the part is another; TooLarge.
[[nodiscard]] Result<std::vector<PlacedResult>>
unpack_results(const ResultsPart& part, const ResultsQuery& query, std::uint64_t scenarios);

/// Calls `take` with each existing result of a query, in order. `ask` answers a query with its
/// first part. Errors: those of `ask`, `take` and `unpack_results`.
[[nodiscard]] Status
for_each_result(ResultsQuery query,
                std::uint64_t scenarios,
                const std::function<Result<ResultsPart>(const ResultsQuery&)>& ask,
                const std::function<Status(std::uint64_t place, const ScenarioResult&)>& take);

} // namespace cd
