#include "client/scene/scene_meshes.hpp"

#include "client/base/slow_note.hpp"
#include "client/import/mesh_import.hpp"
#include "common/core/errors.hpp"

#include <array>
#include <map>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// What a file is read by; equal keys give equal meshes.
using MeshKey = std::tuple<std::string, std::string, std::string, bool, std::array<double, 3>>;

MeshKey key_of(const BodySpec& body) {
    return {body.path.string(), body.unit, body.up, body.rounds_to_float, body.origin};
}

} // namespace

Result<SceneMeshes> import_meshes(const SceneSpec& scene, const std::string& job_unit, bool quiet) {
    SceneMeshes read;
    std::map<MeshKey, std::shared_ptr<const Mesh>> known;
    for (const SceneBodySpec& body : scene.bodies) {
        std::shared_ptr<const Mesh>& mesh = known[key_of(body.mesh)];
        if (mesh == nullptr) {
            const auto options = CD_TRY(import_options(body.mesh, job_unit));
            const SlowNote note("reading " + body.mesh.path.filename().string() + "...", quiet);
            auto imported = CD_TRY(import_mesh(body.mesh.path, options));
            mesh = std::move(imported.mesh);
            read.warnings.insert(
                read.warnings.end(), imported.warnings.begin(), imported.warnings.end());
        }
        read.meshes.push_back(mesh);
    }
    return read;
}

} // namespace cd
