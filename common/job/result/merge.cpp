#include "common/job/result/merge.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <span>

namespace cd {

namespace {

/// Hashes all digests, one block of the list at a time. A block's elements are contiguous.
void update_all(Sha256Stream& stream, const GrowingList<Sha256>& digests) {
    for (std::size_t from = 0; from < digests.size(); from += growing_list_block) {
        const std::size_t count = std::min(growing_list_block, digests.size() - from);
        const std::span block(&digests[from], count);
        CD_CHECK(&digests[from + count - 1] == &block.back());
        stream.update(std::as_bytes(block));
    }
}

} // namespace

ScenarioFacts facts_of(const ScenarioResult& result) {
    return {result.kind,
            result.surfaces_only,
            result.insides_skipped,
            result.is_cut(),
            result.nearest.has_value(),
            result.pair_count,
            result.near_count};
}

ResultMerger::ResultMerger(std::uint64_t scenarios, std::optional<SceneHead> scene)
    : scene_(scene) {
    summary_.total = scenarios;
}

ResultMerger::Outcome ResultMerger::add(const ScenarioResult& result) {
    return add(result, cd::digest_of(result));
}

ResultMerger::Outcome ResultMerger::add(const ScenarioResult& result, const Sha256& digest) {
    return add(result.index, facts_of(result), digest);
}

ResultMerger::Outcome
ResultMerger::add(std::uint64_t index, const ScenarioFacts& facts, const Sha256& digest) {
    CD_CHECK(is_open());
    if (index >= summary_.total) {
        return Outcome::Foreign;
    }
    if (has(index)) {
        return digests_[index] == digest ? Outcome::Repeated : Outcome::Differs;
    }
    if (index >= places()) {
        grow_to(index);
    }
    digests_[index] = digest;
    merged_[index] = true;
    if (scene_) {
        tell_[index] = facts.tells();
    }
    count(facts);
    return Outcome::Added;
}

void ResultMerger::grow_to(std::uint64_t index) {
    constexpr std::uint64_t block = growing_list_block;
    const std::uint64_t places = std::min(summary_.total, (index / block + 1) * block);
    digests_.resize(places);
    merged_.resize(places);
    tell_.resize(scene_ ? places : 0);
}

void ResultMerger::remove(std::uint64_t index, const ScenarioFacts& facts) {
    CD_CHECK(is_open() && has(index));
    merged_[index] = false;
    --count_of(facts.kind);
    summary_.pairs -= facts.pair_count;
    summary_.near_pairs -= facts.near_count;
    summary_.surfaces_only -= facts.surfaces_only ? 1 : 0;
    summary_.insides_skipped -= facts.insides_skipped ? 1 : 0;
    summary_.cut -= facts.is_cut ? 1 : 0;
}

std::uint64_t& ResultMerger::count_of(ScenarioClass kind) {
    switch (kind) {
    case ScenarioClass::Separate:
        return summary_.separate;
    case ScenarioClass::Touch:
        return summary_.touch;
    case ScenarioClass::Cross:
        return summary_.cross;
    case ScenarioClass::Inside:
        return summary_.inside;
    case ScenarioClass::Contact:
        return summary_.contact;
    case ScenarioClass::Undecided:
        return summary_.undecided;
    case ScenarioClass::Near:
        return summary_.near;
    case ScenarioClass::Failed:
        break;
    }
    return summary_.failed;
}

void ResultMerger::count(const ScenarioFacts& facts) {
    ++count_of(facts.kind);
    summary_.pairs += facts.pair_count;
    summary_.near_pairs += facts.near_count;
    summary_.surfaces_only += facts.surfaces_only ? 1 : 0;
    summary_.insides_skipped += facts.insides_skipped ? 1 : 0;
    summary_.cut += facts.is_cut ? 1 : 0;
}

const Sha256& ResultMerger::digest_of(std::uint64_t index) const {
    CD_CHECK(is_open() && has(index));
    return digests_[index];
}

void ResultMerger::close() {
    GrowingList<Sha256>().swap(digests_);
    tell_ = {};
}

std::optional<Sha256> ResultMerger::digest() const {
    if (!summary_.is_complete()) {
        return std::nullopt;
    }
    CD_CHECK(is_open() && digests_.size() == summary_.total);
    Sha256Stream stream;
    if (!scene_) {
        update_all(stream, digests_);
        return stream.finish();
    }
    stream.update(scene_->hash.bytes);
    for (std::size_t i = 0; i < digests_.size(); ++i) {
        if (tell_[i]) {
            stream.update(digests_[i].bytes);
        }
    }
    return stream.finish();
}

} // namespace cd
