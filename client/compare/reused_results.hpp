// Takes results of an earlier run for the scenarios that it has in common with a job.
#pragma once

#include "client/compare/matched_records.hpp"
#include "client/compare/pose_subset.hpp"
#include "client/compare/scenario_match.hpp"
#include "client/local/done_scenario.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/result/record_file.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace cd {

/// The scenarios of a job whose results an earlier run has, and these results.
class ReusedResults {
  public:
    /// Matches the scenarios of two runs with equal meshes and queries (`check_reusable`) by their
    /// poses. Leaves out scenarios that failed in the earlier run, and, if the query asks for maps,
    /// those whose record does not list all pairs. `records` outlives the object. Errors: as
    /// `match_poses`; Io; Interrupted.
    [[nodiscard]] static Result<ReusedResults> find(RecordFile& records,
                                                    PoseSource& earlier,
                                                    PoseSource& poses,
                                                    const Query& query,
                                                    const StopCheck& stop);

    /// Number of scenarios whose results are reused.
    [[nodiscard]] std::uint64_t count() const { return match_.count(); }
    [[nodiscard]] std::uint64_t scenarios() const { return scenarios_; }
    /// Returns the scenarios from `first` on that must be run. `poses` are those of the job, and
    /// outlive the subset.
    [[nodiscard]] std::unique_ptr<PoseSubset> rest(PoseSource& poses, std::uint64_t first) const;
    /// Returns a reader of the results, which this object must outlive.
    [[nodiscard]] MatchedRecords results() { return {*records_, match_, scenarios_}; }
    [[nodiscard]] bool has(std::uint64_t index) const { return match_.earlier(index).has_value(); }
    /// True if the job has contact maps, to which each result brings its pairs.
    [[nodiscard]] bool has_maps() const { return has_maps_; }

  private:
    ReusedResults(RecordFile& records, ScenarioMatch match, std::uint64_t scenarios, bool has_maps)
        : records_(&records),
          match_(std::move(match)),
          scenarios_(scenarios),
          has_maps_(has_maps) {}

    RecordFile* records_;
    ScenarioMatch match_;
    std::uint64_t scenarios_;
    bool has_maps_;
};

/// Brings reused results and those of the rest into the job's submitted order.
class ReuseMerge {
  public:
    using Take = std::function<Status(const DoneScenario&)>;

    /// `rest` is what `reused.rest` returns for `first`. `take` gets each result from scenario
    /// `first` on, in order. Both references outlive the object.
    ReuseMerge(ReusedResults& reused,
               const PoseSubset& rest,
               std::uint64_t first,
               Take take,
               StopCheck stop)
        : reused_(reused),
          rest_(rest),
          results_(reused.results()),
          next_(first),
          take_(std::move(take)),
          stop_(std::move(stop)) {}

    /// Adds the next result of the rest, with its number there. Errors: of `take`; Io; Interrupted.
    [[nodiscard]] Status add(const DoneScenario& done);
    /// Passes on the results after the last one of the rest. Errors: as `add`.
    [[nodiscard]] Status finish();

  private:
    [[nodiscard]] Status pass_until(std::uint64_t end);

    ReusedResults& reused_;
    const PoseSubset& rest_;
    MatchedRecords results_;
    std::uint64_t next_; ///< The next scenario to pass on.
    Take take_;
    StopCheck stop_;
};

} // namespace cd
