// The scenarios of a scene of many bodies: for each step the pairs of bodies that may touch.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/scene/box_sweep.hpp"
#include "common/scene/pair_set.hpp"
#include "common/scene/step_index.hpp"
#include "common/scene/step_poses.hpp"
#include "common/scene/world_box.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// The bodies of a scene, and which pairs of them are tested.
struct Scene {
    std::vector<PlacedBody> bodies;
    PairSet ignored;  ///< Pairs that no step tests.
    double reach = 0; ///< Pairs that are at most this far apart in the world are tested; finite.
    /// Of motions, whose step k leads from the poses at step k to those at step k + 1; nothing if
    /// bodies rest at each step. Positive and finite. The reach of motions is `reach_of_motions`.
    std::optional<double> resolution = std::nullopt;
};

/// The scenarios of a scene, in the order (step, a, b) with a < b. A step has those pairs of bodies
/// that are not ignored, are present, and whose world boxes, grown by half the reach, overlap.
/// Pairs of two fixed bodies are tested at step 0 alone.
///
/// Of motions there is one step less than of poses. A body is present if it is at both ends, and
/// its box is that of the whole motion (`swept_box`). The poses are keys on one grid (`SceneKeys`).
///
/// Memory: some 60 bytes a step, and the poses of a few steps. Any thread may read.
class ScenePoses final : public PoseSource {
  public:
    /// Counts the scenarios of all steps, which reads all poses once, and of motions also what
    /// `SceneKeys` reads. Errors: those of `StepPoses::read`; TooLarge above
    /// `limits::scenarios_max` scenarios; Interrupted. Of motions also those of `SceneKeys`;
    /// BadInput for a single step; TooLarge, naming step and bodies, for a motion that needs more
    /// halvings than any may have.
    [[nodiscard]] static Result<std::unique_ptr<ScenePoses>>
    create(Scene scene, std::unique_ptr<StepPoses> poses, const StopCheck& stop = {});

    [[nodiscard]] std::uint64_t count() const override { return index_->count(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Returns the steps: their scenarios, and what became of all pairs of bodies.
    [[nodiscard]] const std::shared_ptr<const StepIndex>& steps() const { return index_; }
    /// Returns at how many steps each body is absent.
    [[nodiscard]] std::span<const std::uint64_t> absences() const { return absences_; }
    /// Returns how far the rounding of keys has moved a point of any body, at most, in the job's
    /// unit; nothing without motions.
    [[nodiscard]] std::optional<double> moved() const { return moved_; }
    /// Returns how far that moves any point of a body at most, at any time of the motions.
    [[nodiscard]] std::optional<double> moved_between() const { return moved_between_; }

  private:
    /// A step's poses and the pairs that it tests, sorted.
    struct Step {
        std::uint64_t number = 0;
        PosesOfStep poses;
        PosesOfStep to; ///< Of motions, those at the end, for the same bodies; else empty.
        std::vector<BodyPair> pairs;
    };

    ScenePoses(Scene scene, std::unique_ptr<StepPoses> poses);

    [[nodiscard]] Status take_keys(const StopCheck& stop);
    [[nodiscard]] Status count_steps(const StopCheck& stop);
    [[nodiscard]] Status check_motions(const Step& step) const;
    [[nodiscard]] StepCoverage covered_by(const Step& step) const;
    [[nodiscard]] Result<Step> read_step(std::uint64_t number);
    [[nodiscard]] Result<std::vector<WorldBox>>
    boxes_of(const Step& step, std::span<const std::uint32_t> bodies) const;
    [[nodiscard]] Result<std::vector<BodyPair>> pairs_of(const Step& step) const;
    [[nodiscard]] Scenario scenario_of(const Step& step, std::uint64_t index) const;

    Scene scene_;
    std::unique_ptr<StepPoses> poses_;
    std::uint64_t ignored_pairs_ = 0; ///< Pairs that are ignored.
    std::uint64_t fixed_pairs_ = 0;   ///< Pairs of fixed bodies that are not ignored.
    std::shared_ptr<const StepIndex> index_;
    std::vector<std::uint64_t> absences_;
    std::optional<double> moved_;
    std::optional<double> moved_between_;
    std::mutex mutex_;         ///< Guards `poses_` and `kept_`.
    std::optional<Step> kept_; ///< The step that was read last.
};

} // namespace cd
