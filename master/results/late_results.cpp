#include "master/results/late_results.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"

#include <string>
#include <unordered_set>
#include <utility>

namespace cd {

bool agrees(ScenarioResult late, const ScenarioResult& settled) {
    // Allows exactly the changes that `Settler` may make.
    const std::pair kinds(late.kind, settled.kind);
    if (kinds == std::pair(ScenarioClass::Separate, ScenarioClass::Inside) ||
        kinds == std::pair(ScenarioClass::Touch, ScenarioClass::Cross)) {
        late.kind = settled.kind;
    }
    late.surfaces_only = settled.surfaces_only;
    late.insides_skipped = settled.insides_skipped;
    return encode_result(late) == encode_result(settled);
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
        return Error{ErrorCode::Io, records.error().detail};
    }
    ByteReader in(records.value());
    Result<ScenarioResult> result = decode_result(in.get_bytes(in.get<std::uint32_t>()));
    return result ? std::move(result) : Error{ErrorCode::Io, result.error().detail};
}

Result<std::optional<LateDifference>>
late_difference(const ResultStore& kept, const Results& late, const StopCheck& stop) {
    const Result<Bytes> records = unpack_records(late.records, limits::results_bytes_max);
    if (!records) {
        return records.error();
    }
    std::unordered_set<std::uint64_t> seen;
    std::optional<LateDifference> first;
    ByteReader in(records.value());
    for (std::uint32_t i = 0; i < late.count && !in.failed() && !first; ++i) {
        Result<ScenarioResult> one = decode_result(in.get_bytes(in.get<std::uint32_t>()));
        if (!one) {
            return one.error();
        }
        if (stop && stop()) {
            return Error{ErrorCode::Interrupted, "the master ends"};
        }
        const std::uint64_t scenario = one.value().index;
        if (!seen.insert(scenario).second) {
            return Error{ErrorCode::BadFrame, "two results of one scenario in a message"};
        }
        if (!kept.has(scenario)) {
            continue;
        }
        Result<ScenarioResult> merged = kept_result(kept, scenario);
        if (!merged) {
            return merged.error();
        }
        if (merged.value().kind != ScenarioClass::Failed && !agrees(one.value(), merged.value())) {
            first = LateDifference{std::move(one.value()), std::move(merged.value())};
        }
    }
    if (!first && !in.complete()) {
        return Error{ErrorCode::BadFrame, "results that are not as many as announced"};
    }
    return first;
}

} // namespace cd
