#include "client/result_records.hpp"

#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"

namespace cd {

Result<std::vector<ScenarioResult>>
unpack_results(const ResultsPart& part, std::uint64_t first, std::uint64_t count) {
    if (part.count == 0) {
        return Error{ErrorCode::Incomplete,
                     "the master has no result of scenario " + std::to_string(first)};
    }
    if (part.first != first || part.count > count) {
        return Error{ErrorCode::BadFrame, "the master sent other results than were asked for"};
    }
    const Result<Bytes> records = unpack_records(part.records, limits::results_bytes_max);
    if (!records) {
        return records.error();
    }
    std::vector<ScenarioResult> results;
    ByteReader in(records.value());
    for (std::uint64_t i = 0; i < part.count; ++i) {
        const auto record = in.get_array<std::uint8_t>(in.get<std::uint32_t>());
        if (in.failed()) {
            break;
        }
        Result<ScenarioResult> result = decode_result(std::as_bytes(std::span(record)));
        if (!result) {
            return result.error();
        }
        if (result.value().index != first + i) {
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
