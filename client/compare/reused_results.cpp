#include "client/compare/reused_results.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"

#include <utility>
#include <vector>

namespace cd {

namespace {

/// True if a result is what a run of the same scenario gives, its part of a contact map included.
bool is_reusable(const ScenarioResult& result, bool has_maps) {
    const bool has_pairs = result.pair_count > 0 || result.near_count > 0;
    const bool lists_all = !has_pairs || (result.level >= Level::Pairs && !result.is_cut());
    return result.kind != ScenarioClass::Failed && (!has_maps || lists_all);
}

/// Returns for each scenario of the earlier run whether its result can be reused.
Result<std::vector<bool>> reusable_in(const RecordFile& records,
                                      std::uint64_t scenarios,
                                      bool has_maps,
                                      const StopCheck& stop) {
    std::vector<bool> reusable(scenarios);
    CD_TRY(records.for_each([&](const RecordView& record) -> Status {
        if (stop && stop()) {
            return interrupted();
        }
        if (record.result.index < scenarios) {
            reusable[record.result.index] = is_reusable(record.result, has_maps);
        }
        return Done{};
    }));
    return reusable;
}

} // namespace

Result<ReusedResults> ReusedResults::find(RecordFile& records,
                                          PoseSource& earlier,
                                          PoseSource& poses,
                                          const Query& query,
                                          const StopCheck& stop) {
    auto match = CD_TRY(match_poses(earlier, poses, Repeats::Share, stop));
    const auto reusable = CD_TRY(reusable_in(records, earlier.count(), query.maps, stop));
    match.keep_if(poses.count(), [&](std::uint64_t index) { return reusable[index]; });
    return ReusedResults(records, std::move(match), poses.count(), query.maps);
}

std::unique_ptr<PoseSubset> ReusedResults::rest(PoseSource& poses, std::uint64_t first) const {
    std::vector<std::uint64_t> indices;
    for (std::uint64_t index = first; index < scenarios_; ++index) {
        if (!has(index)) {
            indices.push_back(index);
        }
    }
    return std::make_unique<PoseSubset>(poses, std::move(indices));
}

Status ReuseMerge::pass_until(std::uint64_t end) {
    for (; next_ < end; ++next_) {
        if (stop_ && stop_()) {
            return interrupted();
        }
        const ScenarioResult* const found = CD_TRY(results_.of(next_));
        CD_CHECK(found != nullptr); // The rest has all other scenarios.
        ScenarioResult result = *found;
        result.index = next_;
        std::vector<ContactPair> pairs;
        if (reused_.has_maps()) {
            pairs = result.pairs;
        }
        CD_TRY(take_(done_scenario(std::move(result), std::move(pairs))));
    }
    return Done{};
}

Status ReuseMerge::add(const DoneScenario& done) {
    const std::uint64_t index = rest_.index_of(done.result.index);
    CD_TRY(pass_until(index));
    ScenarioResult result = done.result;
    result.index = index;
    ++next_;
    return take_(done_scenario(std::move(result), done.found));
}

Status ReuseMerge::finish() {
    return pass_until(reused_.scenarios());
}

} // namespace cd
