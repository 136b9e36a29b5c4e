#include "client/import/float_rounding.hpp"

#include "client/import/mesh_builder.hpp"

#include <utility>

namespace cd {

namespace {

Corners in_floats(const Corners& corners) {
    Corners rounded = corners;
    for (Vec3& corner : rounded) {
        corner = corner.cast<float>().cast<double>().eval();
    }
    return rounded;
}

} // namespace

Result<ImportedMesh> rounded_to_floats(const std::filesystem::path& path, ImportedMesh imported) {
    const Mesh& mesh = *imported.mesh;
    if (mesh.precision() == Precision::Float) {
        return imported;
    }
    MeshBuilder builder;
    for (const Part& part : mesh.parts()) {
        builder.begin_part(part.name);
        for (std::uint32_t i = part.triangles_begin; i < part.triangles_end; ++i) {
            const Corners rounded = in_floats(mesh.corners(i));
            for (const Vec3& corner : rounded) {
                if (!corner.allFinite()) {
                    return Error{ErrorCode::BadInput,
                                 path.string() + ": triangle " + std::to_string(i) +
                                     " has a coordinate that no float holds; leave out precision = "
                                     "\"float\""};
                }
            }
            builder.add(rounded);
        }
    }
    auto rounded = builder.finish(Precision::Float);
    if (!rounded) {
        return Error{ErrorCode::BadInput, path.string() + ": " + rounded.error().detail};
    }
    imported.mesh = std::make_shared<const Mesh>(std::move(rounded.value()));
    imported.is_rounded = true;
    return imported;
}

} // namespace cd
