// When a motion's bodies meet or part, in the time of its poses.
#pragma once

#include "client/report/first_event.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/result/result.hpp"
#include "common/scene/step_index.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cd {

/// Returns the word for how a motion ended: free, contact, start or limit.
[[nodiscard]] std::string_view to_text(MotionEnd end);

/// Whether the event of a motion that has one is that the bodies are near: they do not touch, but
/// one may be inside the other.
[[nodiscard]] inline bool is_near_event(const ScenarioResult& result) {
    return result.kind == ScenarioClass::Near || result.kind == ScenarioClass::Inside;
}

/// Turns instants of motions into the poses' time.
class MotionTimes {
  public:
    /// `labels` are those of all scenarios; null: scenario i lasts from i to i + 1.
    explicit MotionTimes(std::shared_ptr<const PoseLabels> labels = nullptr)
        : labels_(std::move(labels)) {}
    /// Those of a scene, whose motions last from step to step.
    explicit MotionTimes(std::shared_ptr<const StepIndex> steps) : steps_(std::move(steps)) {}

    /// Returns the time of an instant of the scenario's motion.
    [[nodiscard]] double at(const ScenarioResult& result, std::uint32_t instant) const;

    /// Returns t0 and t1: the bracket of the event, or for a search for the way out the event and
    /// when the bodies are free. If the search ended early, when. Nothing if the bodies are free of
    /// the event throughout, and for a failed motion.
    [[nodiscard]] std::optional<std::pair<double, double>>
    bracket(const ScenarioResult& result) const;

    /// Returns what the motion leads to: the event, or for a search for the way out that the bodies
    /// are free. Nothing if that is not known.
    [[nodiscard]] std::optional<FirstEvent> event(const ScenarioResult& result) const;

    /// Says what is proven: "contact between t 0.25 and 0.26", "free from t 0.4 on".
    [[nodiscard]] std::string text(const ScenarioResult& result) const;

  private:
    [[nodiscard]] std::string free_text(const ScenarioResult& result) const;

    std::shared_ptr<const PoseLabels> labels_;
    std::shared_ptr<const StepIndex> steps_; ///< Null unless of a scene.
};

} // namespace cd
