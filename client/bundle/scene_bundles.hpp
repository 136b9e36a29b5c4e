// The scenarios of lines through a scene: for each step and bundle the bodies that may be hit.
#pragma once

#include "client/bundle/bundle_poses.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/scene/step_index.hpp"
#include "common/scene/step_poses.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace cd {

/// The bodies of a scene that lines may hit.
struct LineTargets {
    std::vector<PlacedBody> bodies;
    std::vector<bool> are_ignored; ///< By body: no line is tested against it.
};

/// Returns the world's box around all targets at all steps. Errors: those of `StepPoses::read`;
/// BadInput if no target is there at any step; Interrupted.
[[nodiscard]] Result<Aabb>
box_of_steps(const LineTargets& targets, StepPoses& poses, const StopCheck& stop = {});

/// The bundles of lines that stand in a scene, the same at each step.
struct StandingBundles {
    std::vector<BundlePose> poses; ///< Those of a direction follow each other.
    Aabb lines;                    ///< Of the mesh of lines, in its coordinates.
};

/// The scenarios of lines through the bodies of a scene, in the order (step, bundle, body). Body A
/// is a body of the scene, and body B, which follows all of them, the lines. The step of a scenario
/// is step * bundles + bundle: so it names the bundle, too, and no two scenarios have the same step
/// and bodies.
///
/// A bundle is tested with each body that is present, is not ignored, and whose box overlaps that
/// of the bundle in the bundle's axes. Fixed bodies are tested at each step, since the lines of a
/// step pass through all bodies together.
///
/// Memory: some 60 bytes a step, and the pairs of two steps. Any thread may read.
class SceneBundles final : public PoseSource {
  public:
    /// Counts the scenarios of all steps, which reads all poses once. Errors: those of
    /// `StepPoses::read`; TooLarge above `limits::scenarios_max` scenarios; Interrupted.
    [[nodiscard]] static Result<std::unique_ptr<SceneBundles>>
    create(LineTargets targets,
           StandingBundles bundles,
           std::unique_ptr<StepPoses> poses,
           const StopCheck& stop = {});

    [[nodiscard]] std::uint64_t count() const override { return index_->count(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Returns the steps: their scenarios, and what became of all pairs of a body and a bundle.
    [[nodiscard]] const std::shared_ptr<const StepIndex>& steps() const { return index_; }
    /// Returns at how many steps each body is absent.
    [[nodiscard]] std::span<const std::uint64_t> absences() const { return absences_; }

  private:
    /// A body and a bundle that may meet.
    struct Meeting {
        std::uint32_t body = 0;
        std::uint32_t bundle = 0;
    };
    struct Step {
        std::uint64_t number = 0;
        PosesOfStep poses;
        std::vector<Meeting> meetings; ///< By bundle, then body.
    };
    /// A direction: the turn from the world to its axes, and its bundles.
    struct Direction {
        Mat3 to_axes;
        std::uint32_t first = 0;
        std::vector<Vec3> origins; ///< Of its bundles, in its axes.
    };

    SceneBundles(LineTargets targets, StandingBundles bundles, std::unique_ptr<StepPoses> poses);

    [[nodiscard]] Status count_steps(const StopCheck& stop);
    [[nodiscard]] StepCoverage covered_by(const Step& step) const;
    [[nodiscard]] Result<Step> read_step(std::uint64_t number);
    [[nodiscard]] Result<const Step*> find_step(std::uint64_t number);
    void add_meetings(const Direction& direction, Step& step) const;
    [[nodiscard]] Scenario scenario_of(const Step& step, std::uint64_t index) const;

    LineTargets targets_;
    StandingBundles bundles_;
    std::vector<Direction> directions_;
    std::unique_ptr<StepPoses> poses_;
    std::shared_ptr<const StepIndex> index_;
    std::vector<std::uint64_t> absences_;
    std::mutex mutex_;      ///< Guards `poses_` and `kept_`.
    std::deque<Step> kept_; ///< The steps that were read last; that of a run and that of an export.
};

} // namespace cd
