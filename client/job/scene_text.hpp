// Writes the scene of a job as the text of a job file.
#pragma once

#include "client/spec/scene_spec.hpp"

#include <string>

namespace cd {

/// Writes the tables [bodies], [poses] and [rules] as `read_scene` reads them back, without values
/// that have their default.
[[nodiscard]] std::string scene_text(const SceneSpec& scene);

} // namespace cd
