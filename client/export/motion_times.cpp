#include "client/export/motion_times.hpp"

#include "common/core/words.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace cd {

namespace {

constexpr std::array<std::string_view, 4> end_words{"free", "contact", "start", "limit"};

/// Whether the bodies stay free of the event for all of the time.
bool is_free_throughout(const MotionOutcome& motion) {
    return motion.end == MotionEnd::Free && !motion.event();
}

} // namespace

std::string_view to_text(MotionEnd end) {
    return end_words[static_cast<std::size_t>(end)];
}

double MotionTimes::at(const ScenarioResult& result, std::uint32_t instant) const {
    const double tau = std::ldexp(instant, -static_cast<int>(result.motion->depth));
    if (steps_) {
        return steps_->time_at(steps_->step_of(result.index), tau);
    }
    return labels_ ? labels_->time_at(result.index, tau) : PoseLabels().time_at(result.index, tau);
}

std::optional<std::pair<double, double>> MotionTimes::bracket(const ScenarioResult& result) const {
    if (!result.motion || is_free_throughout(*result.motion)) {
        return std::nullopt;
    }
    return std::pair(at(result, result.motion->t0), at(result, result.motion->t1));
}

std::optional<FirstEvent> MotionTimes::event(const ScenarioResult& result) const {
    const auto times = bracket(result);
    if (!times || !result.motion->event()) {
        return std::nullopt;
    }
    FirstEvent event{FirstEvent::Kind::Contact, result.index, times->first, times->second};
    if (result.motion->until == Until::Free) {
        event.kind = FirstEvent::Kind::Free;
        return result.motion->end == MotionEnd::Free ? std::optional(event) : std::nullopt;
    }
    event.kind = is_near_event(result) ? FirstEvent::Kind::Near : event.kind;
    return event;
}

/// Says where a motion without an event is free; empty if some of its time is open. A search for
/// the way out ends where the bodies are free first.
std::string MotionTimes::free_text(const ScenarioResult& result) const {
    if (result.motion->until == Until::Free) {
        return "free at t " + exact_text(at(result, result.motion->t1));
    }
    return result.motion->has_open_run() ? "" : "free";
}

std::string MotionTimes::text(const ScenarioResult& result) const {
    const auto times = bracket(result);
    if (!times) {
        return result.motion ? free_text(result) : "";
    }
    const MotionOutcome& motion = *result.motion;
    const std::string begin = "t " + exact_text(times->first);
    const std::string end = exact_text(times->second);
    if (motion.until == Until::Free && motion.end == MotionEnd::Free) {
        return "free from t " + end + " on";
    }
    if (!motion.event()) {
        return "known up to t " + end;
    }
    const std::string event = is_near_event(result) ? "near" : "in contact";
    if (motion.until == Until::Free) {
        return event + " at " + begin + ", not free up to t " + end;
    }
    return times->first == times->second ? event + " at " + begin
                                         : "first " + event + " between " + begin + " and " + end;
}

} // namespace cd
