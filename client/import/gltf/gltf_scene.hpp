// Traverses a glTF scene and builds its mesh.
#pragma once

#include "client/import/gltf/gltf_buffers.hpp"
#include "client/import/gltf/gltf_document.hpp"
#include "client/import/imported_mesh.hpp"
#include "client/import/mesh_builder.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace cd {

class GltfScene {
  public:
    /// `document` and `buffers` have to outlive the scene.
    GltfScene(const GltfDocument& document,
              const GltfBuffers& buffers,
              const ImportOptions& options);

    /// Builds the mesh; call it once. Errors: BadInput naming the node or primitive.
    [[nodiscard]] Result<ImportedMesh> read();

  private:
    [[nodiscard]] Status add_node(std::size_t node, const Eigen::Matrix4d& to_world);
    [[nodiscard]] Status check_rigid(std::size_t node) const;
    [[nodiscard]] Result<std::vector<Eigen::Matrix4d>> instances(const GltfNode& node) const;
    [[nodiscard]] Status add_primitive(const GltfPrimitive& primitive,
                                       const Eigen::Matrix4d& to_world);
    [[nodiscard]] std::string part_name(std::size_t node, std::size_t primitive) const;

    const GltfDocument& document_;
    const GltfBuffers& buffers_;
    double factor_;
    MeshBuilder builder_;
    ImportedMesh imported_;
};

} // namespace cd
