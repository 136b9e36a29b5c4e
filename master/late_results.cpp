#include "master/late_results.hpp"

#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"

#include <utility>

namespace cd {

bool agrees(ScenarioResult late, const ScenarioResult& kept) {
    // What settling may do (`settle_class`), and nothing else.
    const std::pair kinds(late.kind, kept.kind);
    if (kinds == std::pair(ScenarioClass::Separate, ScenarioClass::Inside) ||
        kinds == std::pair(ScenarioClass::Touch, ScenarioClass::Cross)) {
        late.kind = kept.kind;
    }
    late.surfaces_only = kept.surfaces_only;
    return encode_result(late) == encode_result(kept);
}

Result<ScenarioResult> kept_result(const ResultStore& results, std::uint64_t scenario) {
    const Result<ResultsPart> part = results.read(scenario, 1, 1);
    if (!part) {
        return part.error();
    }
    if (part.value().count == 0) {
        return Error{ErrorCode::Io, "scenario " + std::to_string(scenario) + " has no result yet"};
    }
    const Result<Bytes> records = unpack_records(part.value().records, limits::results_bytes_max);
    if (!records) {
        return records.error();
    }
    ByteReader in(records.value());
    return decode_result(in.get_bytes(in.get<std::uint32_t>()));
}

Result<std::vector<LateDifference>> late_differences(const ResultStore& kept, const Results& late) {
    const Result<Bytes> records = unpack_records(late.records, limits::results_bytes_max);
    if (!records) {
        return records.error();
    }
    std::vector<LateDifference> differences;
    ByteReader in(records.value());
    for (std::uint32_t i = 0; i < late.count && !in.failed(); ++i) {
        Result<ScenarioResult> one = decode_result(in.get_bytes(in.get<std::uint32_t>()));
        if (!one) {
            return one.error();
        }
        if (!kept.has(one.value().index)) {
            continue;
        }
        Result<ScenarioResult> merged = kept_result(kept, one.value().index);
        if (!merged) {
            return Error{ErrorCode::Io, merged.error().detail};
        }
        if (merged.value().kind != ScenarioClass::Failed && !agrees(one.value(), merged.value())) {
            differences.push_back({std::move(one.value()), std::move(merged.value())});
        }
    }
    if (!in.complete()) {
        return Error{ErrorCode::BadFrame, "results that are not as many as announced"};
    }
    return differences;
}

} // namespace cd
