#include "web/server/cluster/result_records.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"

namespace cd {

Result<std::vector<PlacedResult>>
unpack_results(const ResultsPart& part, const ResultsQuery& query, std::uint64_t scenarios) {
    // The decoder of messages has checked that the intervals in `part.held` ascend and lie within
    // [part.first, part.next).
    if (part.first != query.first || part.next <= query.first ||
        part.next - query.first > query.count) {
        return Error{ErrorCode::BadFrame, "the master sent other results than were asked for"};
    }
    Bytes unpacked;
    const auto records = CD_TRY(received_records(part.records, part.are_packed, unpacked));
    std::vector<PlacedResult> results;
    ByteReader in(records);
    for (const ScenarioInterval& run : part.held) {
        // `run.count` is untrusted, but the loop ends when `records` has no more bytes.
        for (std::uint64_t i = 0; i < run.count; ++i) {
            const auto record = in.get_bytes(in.get<std::uint32_t>());
            if (in.failed()) {
                break;
            }
            ScenarioResult result = CD_TRY(decode_result(record));
            const std::uint64_t place = run.first + i;
            if (result.index != sampled_scenario(place, query.sample, scenarios)) {
                return Error{ErrorCode::BadFrame, "the master sent results out of their order"};
            }
            results.push_back({place, std::move(result)});
        }
    }
    if (!in.complete()) {
        return Error{ErrorCode::BadFrame, "the master sent results that are cut short or too long"};
    }
    return results;
}

Status for_each_result(ResultsQuery query,
                       std::uint64_t scenarios,
                       const std::function<Result<ResultsPart>(const ResultsQuery&)>& ask,
                       const std::function<Status(std::uint64_t, const ScenarioResult&)>& take) {
    const std::uint64_t end = query.first + query.count;
    while (query.first < end) {
        query.count = end - query.first;
        const ResultsPart part = CD_TRY(ask(query));
        const auto results = CD_TRY(unpack_results(part, query, scenarios));
        for (const PlacedResult& each : results) {
            CD_TRY(take(each.place, each.result));
        }
        query.first = part.next;
    }
    return Done{};
}

} // namespace cd
