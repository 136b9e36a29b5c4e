#include "client/import/up_axis.hpp"

namespace cd {

Result<ImportedMesh> turned_to_z_up(ImportedMesh imported) {
    MeshArrays arrays{imported.mesh->vertices(),
                      imported.mesh->triangles(),
                      imported.mesh->parts(),
                      imported.mesh->precision()};
    for (Vec3& vertex : arrays.vertices) {
        vertex = Vec3(vertex.x(), 0.0 - vertex.z(), vertex.y()); // Avoids -0.
    }
    auto mesh = Mesh::create(std::move(arrays));
    if (!mesh) {
        return mesh.error();
    }
    imported.mesh = std::make_shared<const Mesh>(std::move(mesh.value()));
    return imported;
}

} // namespace cd
