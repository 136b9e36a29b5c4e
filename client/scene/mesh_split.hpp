// Splits a mesh into one mesh for each of its parts.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <memory>
#include <string>
#include <vector>

namespace cd {

/// A part of a mesh as a mesh of its own.
struct PartMesh {
    std::string name; ///< Different from those of the other parts.
    std::shared_ptr<const Mesh> mesh;
};

/// Splits a mesh into its parts, in their order. Each mesh has the triangles of its part in their
/// order, the vertices that these use, numbered by first use, and one part with the part's name.
///
/// The second part of a name is called NAME#2, the third NAME#3. Triangles of no part make up a
/// last part `others`. A mesh without parts gives one, `whole`. Errors: those of `Mesh::create`.
[[nodiscard]] Result<std::vector<PartMesh>> split_mesh(const Mesh& mesh);

} // namespace cd
