#include "tests/faults/lies.hpp"

#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"

#include <optional>

namespace cd::tests {

namespace {

bool concerns(unsigned liar, std::uint64_t scenario) {
    const std::uint64_t mixed = (scenario + 1) * 0x9E3779B97F4A7C15u;
    return (mixed >> 32) % Lies::liars_max == liar;
}

/// Returns a result of a motion to its first contact that has it at the motion's begin. It lists
/// the same pairs, so that sums of the listed pairs stay right.
ScenarioResult in_contact_at_start(ScenarioResult result) {
    if (result.level == Level::Any) {
        result.kind = ScenarioClass::Contact;
    }
    result.distance_bound = 0;
    result.motion->end = MotionEnd::Start;
    result.motion->t0 = 0;
    result.motion->t1 = 0;
    result.motion->runs.clear();
    return result;
}

/// Returns nothing if a wrong result would be noticed at once.
std::optional<ScenarioResult> falsified(ScenarioResult truth) {
    if (truth.motion) {
        const bool lists_none = truth.level == Level::Pairs && truth.pairs.empty();
        if (truth.motion->end == MotionEnd::Start || lists_none) {
            return std::nullopt;
        }
        truth = in_contact_at_start(std::move(truth));
    } else if (truth.nearest) {
        truth.nearest->distance /= 2;
    } else if (truth.level == Level::Any && truth.kind == ScenarioClass::Separate) {
        truth.kind = ScenarioClass::Contact;
    } else if (truth.pair_count != 0) {
        ++truth.pair_count;
    } else {
        return std::nullopt;
    }
    return truth;
}

} // namespace

Results Lies::told_by(std::uint64_t host, unsigned liar, const Results& truth) {
    Bytes unpacked;
    ByteReader in(received_records(truth.records, truth.are_packed, unpacked).value());
    ByteWriter out;
    for (std::uint32_t i = 0; i < truth.count; ++i) {
        const ScenarioResult result = decode_result(in.get_bytes(in.get<std::uint32_t>())).value();
        const auto lie = concerns(liar, result.index) ? falsified(result) : std::nullopt;
        if (lie) {
            told_.insert({truth.job, result.index, host});
            liars_.insert(host);
        }
        const Bytes record = encode_result(lie.value_or(result));
        out.put_text({reinterpret_cast<const char*>(record.data()), record.size()});
    }
    Results told = truth;
    told.records = pack_records(out.take());
    told.are_packed = true;
    return told;
}

std::uint64_t Lies::author_of(JobId job, std::uint64_t scenario) const {
    const auto found = told_.lower_bound({job, scenario, 0});
    const bool is_of_it =
        found != told_.end() && std::get<JobId>(*found) == job && std::get<1>(*found) == scenario;
    return is_of_it ? std::get<2>(*found) : 0;
}

} // namespace cd::tests
