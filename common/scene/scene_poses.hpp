// The scenarios of a scene of many bodies: for each step the pairs of bodies that may touch.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/scene/box_sweep.hpp"
#include "common/scene/pair_set.hpp"
#include "common/scene/step_index.hpp"
#include "common/scene/world_box.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// The poses of all bodies at a step, by the bodies' indices: nothing for a body that is absent.
using PosesOfStep = std::vector<std::optional<Pose>>;

/// The poses of a scene's bodies, step by step.
class StepPoses {
  public:
    StepPoses() = default;
    StepPoses(const StepPoses&) = delete;
    StepPoses& operator=(const StepPoses&) = delete;
    virtual ~StepPoses() = default;

    /// Number of steps, at least 1.
    [[nodiscard]] virtual std::uint64_t steps() const = 0;
    /// Reads the poses at a step, which exists. The result depends on the step alone. Errors: Io;
    /// BadInput naming the row.
    [[nodiscard]] virtual Result<PosesOfStep> read(std::uint64_t step) = 0;
    /// Returns the time of each step, in the unit of the user's file; empty if none are given.
    [[nodiscard]] virtual std::vector<double> times() const { return {}; }
};

/// A body of a scene.
struct PlacedBody {
    Aabb box;              ///< Of its mesh, in its coordinates; not empty.
    bool is_fixed = false; ///< Its pose is the same at all steps, and it is never absent.
};

/// The bodies of a scene, and which pairs of them are tested.
struct Scene {
    std::vector<PlacedBody> bodies;
    PairSet ignored;  ///< Pairs that no step tests.
    double reach = 0; ///< Pairs that are at most this far apart in the world are tested; finite.
};

/// The scenarios of a scene, in the order (step, a, b) with a < b. A step has those pairs of bodies
/// that are not ignored, are present, and whose world boxes, grown by half the reach, overlap.
/// Pairs of two fixed bodies are tested at step 0 alone.
///
/// Memory: some 60 bytes a step, and the poses of one step. Any thread may read.
class ScenePoses final : public PoseSource {
  public:
    /// Counts the scenarios of all steps, which reads all poses once. Errors: those of
    /// `StepPoses::read`; TooLarge above `limits::scenarios_max` scenarios; Interrupted.
    [[nodiscard]] static Result<std::unique_ptr<ScenePoses>>
    create(Scene scene, std::unique_ptr<StepPoses> poses, const StopCheck& stop = {});

    [[nodiscard]] std::uint64_t count() const override { return index_->count(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Returns the steps: their scenarios, and what became of all pairs of bodies.
    [[nodiscard]] const std::shared_ptr<const StepIndex>& steps() const { return index_; }
    /// Returns at how many steps each body is absent.
    [[nodiscard]] std::span<const std::uint64_t> absences() const { return absences_; }

  private:
    /// A step's poses and the pairs that it tests, sorted.
    struct Step {
        std::uint64_t number = 0;
        PosesOfStep poses;
        std::vector<BodyPair> pairs;
    };

    ScenePoses(Scene scene, std::unique_ptr<StepPoses> poses);

    [[nodiscard]] Status count_steps(const StopCheck& stop);
    [[nodiscard]] StepCoverage covered_by(const Step& step) const;
    [[nodiscard]] Result<Step> read_step(std::uint64_t number);
    [[nodiscard]] std::vector<BodyPair> pairs_of(std::uint64_t step,
                                                 const PosesOfStep& poses) const;
    [[nodiscard]] bool is_tested(std::uint64_t step, BodyPair pair) const;

    Scene scene_;
    std::unique_ptr<StepPoses> poses_;
    std::uint64_t ignored_pairs_ = 0; ///< Pairs that are ignored.
    std::uint64_t fixed_pairs_ = 0;   ///< Pairs of fixed bodies that are not ignored.
    std::shared_ptr<const StepIndex> index_;
    std::vector<std::uint64_t> absences_;
    std::mutex mutex_;         ///< Guards `poses_` and `kept_`.
    std::optional<Step> kept_; ///< The step that was read last.
};

} // namespace cd
