// Keys between the steps of a scene, along the curves of bodies whose rows have velocities.
#pragma once

#include "client/curves/row_curve.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/motion/body_path.hpp"
#include "common/scene/step_poses.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// A body of a scene, and the place of its pose in the rows of a file.
struct BodyColumn {
    std::uint32_t body = 0;
    std::size_t column = 0;
};

/// The velocities of a file's rows; there is a row for each step.
struct StepRates {
    std::vector<BodyColumn> bodies; ///< Each body at most once.
    std::size_t columns = 1;        ///< Poses in a row.
    std::vector<PoseRates> rates;   ///< Of each pose, row by row, in the job's unit.
    /// Names the place of a pose in its file: "log.csv: line 7".
    std::function<std::string(std::uint64_t step, std::size_t column)> name;
};

/// The poses of another source, and keys between its steps. Each step is cut into equal times, as
/// many as it takes that the motion from each key to the next changes no distance between points of
/// two bodies by more than `off_max` against their paths, at any time, even if the keys are then
/// rounded to a grid and that moves the motions by up to `grid_share` of it.
///
/// The path of a body with rates is the curve from its pose with the step's rates (`CurvePhase`)
/// until the next step, where its pose is the given one; it may miss that as `keys_between` says,
/// each of two bodies by half. Any other body goes straight from step to step (`BodyPath`). Its
/// keys are on that path, and between them it goes at another pace: with k = 2 tan(theta/4), for a
/// turn of theta, and n keys a step its angle errs by at most 0.1624 k^2 / n^2, since the second
/// derivative of 2 atan(k tau) is at most 1.2991 k^2, and by 0.04 k^3 / n^3, as in `keys_along` for
/// a turn of 2 k / n. A step of one key is as it was.
///
/// A body is absent between two steps if it is at one of them. Times are in seconds; without them
/// the steps are a second apart.
class CurvedSteps final : public StepPoses {
  public:
    /// Finds the keys of all steps, which reads all poses once. `bodies` are those of the scene,
    /// with radii and names. `given` has two steps or more. Errors begin with the name of a row, or
    /// with the step and the body: as `keys_between`; BadInput for a body without rates that turns
    /// by 180 degrees in a step; those of `StepPoses::read`; Interrupted.
    [[nodiscard]] static Result<std::unique_ptr<CurvedSteps>>
    create(std::unique_ptr<StepPoses> given,
           std::vector<StepRates> rates,
           std::vector<PlacedBody> bodies,
           double off_max,
           const StopCheck& stop = {});

    [[nodiscard]] std::uint64_t steps() const override { return begins_.back() + 1; }
    [[nodiscard]] std::vector<double> times() const override;
    [[nodiscard]] Result<PosesOfStep> read(std::uint64_t step) override;

  private:
    /// A given step and the next one.
    struct Span {
        std::uint64_t step = 0;
        PosesOfStep from;
        PosesOfStep to;
    };
    struct Source {
        const StepRates* rates = nullptr; ///< Null for a body that goes straight.
        std::size_t column = 0;
    };

    CurvedSteps(std::unique_ptr<StepPoses> given,
                std::vector<StepRates> rates,
                std::vector<PlacedBody> bodies,
                double off_max);

    [[nodiscard]] Status find_keys(const StopCheck& stop);
    [[nodiscard]] Result<double> parts_of(const Span& span) const;
    [[nodiscard]] Result<double> curve_parts(const Span& span, std::uint32_t body) const;
    [[nodiscard]] Result<BodyPath> straight_path(const Span& span, std::uint32_t body) const;
    [[nodiscard]] Result<double> straight_parts(const Span& span, std::uint32_t body) const;
    [[nodiscard]] Result<CurvePhase> curve(const Span& span, std::uint32_t body) const;
    [[nodiscard]] Result<Pose> pose_in(const Span& span, std::uint32_t body, double share) const;
    [[nodiscard]] double seconds(std::uint64_t step) const {
        return times_[step + 1] - times_[step];
    }
    [[nodiscard]] std::string name(std::uint64_t step, std::uint32_t body) const;

    std::unique_ptr<StepPoses> given_;
    std::vector<StepRates> rates_;
    std::vector<PlacedBody> bodies_;
    double off_max_;
    std::vector<Source> sources_;       ///< By body.
    std::vector<double> times_;         ///< Of the given steps.
    std::vector<std::uint64_t> begins_; ///< The first key of each given step.
    std::optional<Span> kept_;          ///< Read last.
};

} // namespace cd
