#include "web/server/motion_json.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace cd {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> until_names{"contact", "free", "end"};
constexpr std::array<std::string_view, 4> end_names{"free", "contact", "start", "limit"};

Json run_json(const CellRun& run) {
    const bool has_event = run.has_event();
    return {{"state", run.state == CellState::Free ? "free" : "open"},
            {"first", run.first},
            {"count", run.count},
            {"event_first", has_event ? Json(run.event_first) : Json()},
            {"event_last", has_event ? Json(run.event_last) : Json()}};
}

Json keys_json(const PosePair& poses) {
    return {{"a", key_numbers(poses.a)}, {"b", key_numbers(poses.b)}};
}

} // namespace

std::string_view until_text(Until until) {
    return until_names[static_cast<std::size_t>(until)];
}

Json motion_json(const ScenarioResult& result, const MotionKeys& keys) {
    const MotionOutcome& motion = *result.motion;
    const std::optional<std::uint32_t> event = motion.event();
    const bool is_bounded =
        result.kind == ScenarioClass::Undecided && std::isfinite(result.distance_bound);
    Json json{{"end", end_names[static_cast<std::size_t>(motion.end)]},
              {"until", until_text(motion.until)},
              {"depth", motion.depth},
              {"t0", motion.t0},
              {"t1", motion.t1},
              {"event", event ? Json(*event) : Json()},
              {"bound", is_bounded ? Json(result.distance_bound) : Json()},
              {"runs", Json::array()},
              {"from", keys_json(keys.from)},
              {"to", keys_json(keys.to)}};
    for (const CellRun& run : motion.runs) {
        json["runs"].push_back(run_json(run));
    }
    return json;
}

} // namespace cd
