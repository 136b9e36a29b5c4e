// What `cdctl job check` prints: the bodies of a scene, its rules and its coverage.
#pragma once

#include "client/scene/prepared_scene.hpp"

#include <string>

namespace cd {

/// Describes a scene in lines with newlines: the bodies by the entries of [bodies]; for each rule
/// how many pairs of bodies it names, and about how many it decides; the steps, and what becomes of
/// the pairs of bodies at all of them.
[[nodiscard]] std::string check_text(const JobSpec& spec, const PreparedScene& prepared);

} // namespace cd
