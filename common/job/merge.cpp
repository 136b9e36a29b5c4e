#include "common/job/merge.hpp"

#include "common/core/check.hpp"

namespace cd {

ResultMerger::ResultMerger(std::uint64_t scenarios) {
    summary_.total = scenarios;
}

ResultMerger::Outcome ResultMerger::add(const ScenarioResult& result) {
    return add(result, digest_of(result));
}

ResultMerger::Outcome ResultMerger::add(const ScenarioResult& result, const Sha256& digest) {
    if (result.index >= summary_.total) {
        return Outcome::Foreign;
    }
    if (has(result.index)) {
        return digests_[result.index] == digest ? Outcome::Repeated : Outcome::Differs;
    }
    if (result.index >= digests_.size()) {
        digests_.resize(result.index + 1);
        merged_.resize(result.index + 1);
    }
    digests_[result.index] = digest;
    merged_[result.index] = true;
    count(result);
    return Outcome::Added;
}

bool ResultMerger::has(std::uint64_t index) const {
    return index < merged_.size() && merged_[index];
}

void ResultMerger::count(const ScenarioResult& result) {
    switch (result.kind) {
    case ScenarioClass::Separate:
        ++summary_.separate;
        break;
    case ScenarioClass::Touch:
        ++summary_.touch;
        break;
    case ScenarioClass::Cross:
        ++summary_.cross;
        break;
    case ScenarioClass::Inside:
        ++summary_.inside;
        break;
    case ScenarioClass::Contact:
        ++summary_.contact;
        break;
    case ScenarioClass::Undecided:
        ++summary_.undecided;
        break;
    case ScenarioClass::Failed:
        ++summary_.failed;
        break;
    }
    summary_.pairs += result.pair_count;
    summary_.surfaces_only += result.surfaces_only ? 1 : 0;
    summary_.cut += result.is_cut() ? 1 : 0;
}

std::optional<Sha256> ResultMerger::digest() const {
    if (!summary_.is_complete()) {
        return std::nullopt;
    }
    CD_CHECK(digests_.size() == summary_.total);
    Sha256Stream stream;
    stream.update(std::as_bytes(std::span<const Sha256>(digests_)));
    return stream.finish();
}

} // namespace cd
