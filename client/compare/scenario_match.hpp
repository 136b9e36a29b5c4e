// Which scenarios of an earlier and of a later run are the same.
#pragma once

#include "client/folder/run_manifest.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

/// By what scenarios are matched: their index, the pose file's ids, the bits of the poses, or the
/// step and the two bodies in a scene.
enum class MatchedBy : std::uint8_t { Index, Id, Poses, Step };

[[nodiscard]] std::string_view to_text(MatchedBy by);

/// What scenarios of the earlier run several equal scenarios of the later run may have.
enum class Repeats : std::uint8_t {
    Share, ///< All have the first one.
    Pair,  ///< The n-th has the n-th one.
};

/// For each scenario of the later run the same scenario of the earlier run, if there is one.
/// Memory: four bytes a scenario, except for a match by index; a bit more after `keep_if`.
class ScenarioMatch {
  public:
    /// Matches the first `scenarios` scenarios of both runs by their index.
    [[nodiscard]] static ScenarioMatch by_index(std::uint64_t scenarios);

    [[nodiscard]] MatchedBy by() const { return by_; }
    /// Number of scenarios of the later run that have one of the earlier run.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Returns the earlier run's index of a scenario of the later run.
    [[nodiscard]] std::optional<std::uint64_t> earlier(std::uint64_t index) const;
    /// Removes the scenarios whose earlier scenario `keeps` refuses. `scenarios` is the later run's
    /// number of scenarios. May be called once.
    void keep_if(std::uint64_t scenarios, const std::function<bool(std::uint64_t earlier)>& keeps);

  private:
    friend class ScenarioMatcher;

    MatchedBy by_ = MatchedBy::Index;
    std::uint64_t count_ = 0;
    std::uint64_t by_index_ = 0;           ///< The first so many scenarios have equal indices.
    std::vector<std::uint32_t> earlier_{}; ///< By index, if not matched by index.
    std::vector<bool> dropped_{};          ///< By index, what `keep_if` removed; empty at first.
};

/// The scenarios of a run, as far as they are matched.
struct MatchedRun {
    PoseSource& poses;
    const PoseLabels& labels;
    bool is_scene = false;
};

/// Matches scenarios whose poses have equal forms and numbers, -0 as 0. Equal grids are matched by
/// index. Errors: from reading poses; TooLarge; Interrupted.
[[nodiscard]] Result<ScenarioMatch>
match_poses(PoseSource& earlier, PoseSource& later, Repeats repeats, const StopCheck& stop);

/// Matches the scenarios of two runs: by index if `are_poses_equal`, else by step and bodies if
/// both are scenes, else by id if both runs have ids, else by poses. Errors: as `match_poses`.
[[nodiscard]] Result<ScenarioMatch> match_runs(const MatchedRun& earlier,
                                               const MatchedRun& later,
                                               bool are_poses_equal,
                                               const StopCheck& stop);

} // namespace cd
