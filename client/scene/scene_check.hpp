// What `cdctl job check` prints: the bodies of a scene, its rules and its coverage.
#pragma once

#include "client/scene/prepared_scene.hpp"

#include <string>

namespace cd {

/// Says how far the rounding of a scene's keys has moved the bodies: "keys of motions are rounded
/// to a grid: rounding moved no body by more than 2.3e-13 m".
[[nodiscard]] std::string keys_text(double moved, const std::string& unit);

/// Describes a scene in lines with newlines: the bodies by the entries of [bodies]; for each rule
/// how many pairs of bodies it names, and about how many it decides; the steps, and what becomes of
/// the pairs of bodies at all of them.
/// Of motions it also says how far the rounding of keys moves the bodies, and of lines how many
/// bundles there are.
[[nodiscard]] std::string check_text(const JobSpec& spec, const PreparedScene& prepared);

} // namespace cd
