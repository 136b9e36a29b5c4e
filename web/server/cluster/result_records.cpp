#include "web/server/cluster/result_records.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"

namespace cd {

Result<std::vector<ScenarioResult>>
unpack_results(const ResultsPart& part, std::uint64_t first, std::uint64_t count) {
    // The decoder of messages has checked that the intervals in `part.held` ascend and lie within
    // [part.first, part.next).
    if (part.first != first || part.next <= first || part.next - first > count) {
        return Error{ErrorCode::BadFrame, "the master sent other results than were asked for"};
    }
    const Bytes records = CD_TRY(unpack_records(part.records, limits::results_bytes_max));
    std::vector<ScenarioResult> results;
    ByteReader in(records);
    for (const ScenarioInterval& run : part.held) {
        // `run.count` is untrusted, but the loop ends when `records` has no more bytes.
        for (std::uint64_t i = 0; i < run.count; ++i) {
            const auto record = in.get_bytes(in.get<std::uint32_t>());
            if (in.failed()) {
                break;
            }
            ScenarioResult result = CD_TRY(decode_result(record));
            if (result.index != run.first + i) {
                return Error{ErrorCode::BadFrame, "the master sent results out of their order"};
            }
            results.push_back(std::move(result));
        }
    }
    if (!in.complete()) {
        return Error{ErrorCode::BadFrame, "the master sent results that are cut short or too long"};
    }
    return results;
}

} // namespace cd
