#include "client/remote/result_records.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"

namespace cd {

Result<std::vector<ScenarioResult>>
unpack_results(const ResultsPart& part, std::uint64_t first, std::uint64_t count) {
    // The decoder has checked that `held` ascends within [first, next).
    if (part.first != first || part.next <= first || part.next - first > count) {
        return Error{ErrorCode::BadFrame, "the master sent other results than were asked for"};
    }
    const Result<Bytes> records = unpack_records(part.records, limits::results_bytes_max);
    if (!records) {
        return records.error();
    }
    std::vector<ScenarioResult> results;
    ByteReader in(records.value());
    std::vector<std::uint64_t> held;
    for (const ScenarioInterval& run : part.held) {
        for (std::uint64_t i = 0; i < run.count; ++i) {
            held.push_back(run.first + i);
        }
    }
    for (const std::uint64_t scenario : held) {
        const auto record = in.get_array<std::uint8_t>(in.get<std::uint32_t>());
        if (in.failed()) {
            break;
        }
        Result<ScenarioResult> result = decode_result(std::as_bytes(std::span(record)));
        if (!result) {
            return result.error();
        }
        if (result.value().index != scenario) {
            return Error{ErrorCode::BadFrame, "the master sent results out of their order"};
        }
        results.push_back(std::move(result.value()));
    }
    if (!in.complete()) {
        return Error{ErrorCode::BadFrame, "the master sent results that are cut short or too long"};
    }
    return results;
}

} // namespace cd
