// What is proven of a motion, as JSON.
#pragma once

#include "common/job/result/result.hpp"
#include "web/server/page_values.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace cd {

/// Returns the word for what a search along a motion is for: contact, free or end.
[[nodiscard]] std::string_view until_text(Until until);

/// Returns the outcome of a result that has one: `end`, `until`, `depth`, `t0`, `t1`, `event` (null
/// without one), `bound` (in the job's unit; null if it is not known) and `runs`, each with
/// `state`, `first`, `count`, and the first and last instant with the event or null. Instants are
/// in units of 2^-depth of the motion's time. `from` and `to` are the keys: for the bodies `a` and
/// `b` seven numbers w, x, y, z of the quaternion and x, y, z of the position in the world,
/// exactly.
///
/// Keys are of kind Quaternion.
[[nodiscard]] nlohmann::ordered_json motion_json(const ScenarioResult& result,
                                                 const MotionKeys& keys);

} // namespace cd
