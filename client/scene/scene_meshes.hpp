// The mesh files of a scene.
#pragma once

#include "client/spec/scene_spec.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <memory>
#include <string>
#include <vector>

namespace cd {

struct SceneMeshes {
    /// The mesh of each entry of [bodies]. Entries that read one file alike share a mesh.
    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
};

/// Imports the mesh files of a scene, each once. Unless `quiet`, a line on stderr names each that
/// takes longer than half a second. Errors: those of `import_mesh`.
[[nodiscard]] Result<SceneMeshes>
import_meshes(const SceneSpec& scene, const std::string& job_unit, bool quiet);

} // namespace cd
