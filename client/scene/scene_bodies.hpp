// The bodies of a scene, one by one: instances and parts of the entries of [bodies].
#pragma once

#include "client/poses/traffic.hpp"
#include "client/spec/scene_spec.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// A body of a scene. Its index is its place in the list of bodies.
struct NamedBody {
    std::string name;
    std::string group;       ///< Empty: none.
    std::uint32_t entry = 0; ///< Its entry in `SceneSpec::bodies`.
    std::uint32_t mesh = 0;  ///< Its mesh in `SceneBodies::meshes`.
};

struct SceneBodies {
    std::vector<NamedBody> bodies;                   ///< Of distinct names.
    std::vector<std::shared_ptr<const Mesh>> meshes; ///< Each once; instances share one.

    [[nodiscard]] const Mesh& mesh_of(const NamedBody& body) const { return *meshes[body.mesh]; }
};

/// Makes the bodies of all entries, in their order: NAME, or NAME.0, NAME.1, ... for instances, or
/// NAME.PART for each part (`split_mesh`), or the ids of the vehicles that `traffic` gives to the
/// entry. `meshes` has the mesh of each entry, and equal pointers for equal files. Errors: BadInput
/// naming the line, for two bodies of one name, for fewer than two bodies, or
/// with lines for none, and above `limits::bodies_max` or `limits::body_meshes_max`.
[[nodiscard]] Result<SceneBodies> expand_bodies(const SceneSpec& scene,
                                                std::span<const std::shared_ptr<const Mesh>> meshes,
                                                const std::filesystem::path& job_file,
                                                const RoadTraffic& traffic = {});

} // namespace cd
