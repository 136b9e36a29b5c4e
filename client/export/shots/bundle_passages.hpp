// The passages of a bundle's lines through all bodies of a step.
#pragma once

#include "client/export/shots/passages.hpp"
#include "client/export/shots/shot_job.hpp"
#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// A body that a bundle hits, by a scenario of its own.
struct HitBody {
    std::uint32_t body = 0;
    std::uint64_t scenario = 0;
    /// Where it stands; nothing for body A of two bodies, and where poses are not at hand.
    std::optional<Pose> pose;
};

/// A passage through one of the bodies.
struct BodyPassage {
    Passage way;
    std::uint32_t place = 0; ///< In `BundlePassages::bodies`.
};

struct BundlePassages {
    std::uint64_t bundle = 0; ///< Its number in the step; of two bodies the scenario.
    std::vector<HitBody> bodies;
    /// By line, and of each line by the rounded depth where they begin; at equal depths those of
    /// earlier bodies come first.
    std::vector<BodyPassage> passages;
};

/// Gathers the results of each bundle. Those of one bundle follow each other.
class PassageGatherer {
  public:
    explicit PassageGatherer(std::shared_ptr<const ShotJob> job) : job_(std::move(job)) {}

    /// Adds the next result in submitted order, and returns the passages of the bundle before if
    /// that is whole now. Errors: those of the poses; BadFrame for a result of other bodies.
    [[nodiscard]] Result<std::optional<BundlePassages>> add(const ScenarioResult& result);
    /// Returns the passages of the last bundle, if there is one.
    [[nodiscard]] std::optional<BundlePassages> finish();

  private:
    [[nodiscard]] Result<std::optional<Pose>> pose_of(std::uint64_t scenario);
    void add_passages(const ScenarioResult& result, const std::optional<Pose>& pose);

    std::shared_ptr<const ShotJob> job_;
    std::optional<std::uint64_t> key_; ///< Names the bundle and the step; nothing before the first.
    BundlePassages gathered_;
    std::vector<Scenario> window_; ///< Scenarios that were read together.
};

} // namespace cd
