// When two bodies of a scene are in contact: runs of consecutive steps.
#pragma once

#include "common/job/result/result.hpp"
#include "common/job/result/severity.hpp"
#include "common/scene/box_sweep.hpp"
#include "common/scene/step_index.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace cd {

/// Consecutive steps at which two bodies are in contact or near.
struct BodyEpisode {
    BodyPair bodies;
    std::uint64_t first_step = 0;
    std::uint64_t last_step = 0;
    Badness badness;                              ///< Of the worst scenario (severity.hpp).
    ScenarioClass worst = ScenarioClass::Contact; ///< Its class.
    std::uint64_t worst_scenario = 0;             ///< Of equally bad ones the first.

    friend bool operator==(const BodyEpisode&, const BodyEpisode&) = default;
};

/// Joins the results of a scene into episodes. A pair of two fixed bodies, which only step 0 tests,
/// has an episode of all steps. Memory: the episodes that have not ended.
class EpisodeSum {
  public:
    /// `are_fixed` says of each body whether it has one pose at all steps.
    EpisodeSum(std::shared_ptr<const StepIndex> steps, std::vector<bool> are_fixed);

    /// Adds the next result in submitted order. Returns the episodes that ended before its step, in
    /// the order of their last steps, then of their bodies.
    [[nodiscard]] std::vector<BodyEpisode> add(const ScenarioResult& result);
    /// Returns the episodes that have not ended.
    [[nodiscard]] std::vector<BodyEpisode> finish();

  private:
    [[nodiscard]] std::vector<BodyEpisode> take_ended(std::uint64_t step);
    void add_hit(const ScenarioResult& result, std::uint64_t step);

    std::shared_ptr<const StepIndex> steps_;
    std::vector<bool> are_fixed_;
    std::map<BodyPair, BodyEpisode> open_;
    std::uint64_t step_ = 0; ///< The step of the latest result.
};

} // namespace cd
