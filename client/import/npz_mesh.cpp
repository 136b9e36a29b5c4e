#include "client/import/npz_mesh.hpp"

#include "client/npz.hpp"

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": " + detail};
}

} // namespace

Result<ImportedMesh> import_npz(const std::filesystem::path& path, const ImportOptions& options) {
    const auto arrays = read_npz(path);
    if (!arrays) {
        return Error{ErrorCode::BadInput, arrays.error().detail};
    }
    const auto vertices = arrays.value().find("vertices");
    const auto faces = arrays.value().find("faces");
    if (vertices == arrays.value().end() || faces == arrays.value().end()) {
        return bad(path, "has no arrays 'vertices' and 'faces'");
    }
    const auto is_triples = [](const NpyArray& array) {
        return array.shape.size() == 2 && array.shape[1] == 3;
    };
    if (!is_triples(vertices->second) || !is_triples(faces->second)) {
        return bad(path, "'vertices' must be of shape (N, 3) and 'faces' of shape (M, 3)");
    }
    const auto indices = faces->second.to_integers();
    if (!indices) {
        return bad(path, "'faces': " + indices.error().detail);
    }
    MeshArrays arrays_out;
    arrays_out.precision = Precision::Double;
    const std::vector<double> values = vertices->second.to_doubles();
    for (std::size_t i = 0; i < values.size(); i += 3) {
        arrays_out.vertices.emplace_back(options.unit_factor *
                                         Vec3(values[i], values[i + 1], values[i + 2]));
    }
    for (std::size_t i = 0; i < indices.value().size(); i += 3) {
        Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t index = indices.value()[i + k];
            if (index < 0 || static_cast<std::uint64_t>(index) >= arrays_out.vertices.size()) {
                return bad(path,
                           "face " + std::to_string(i / 3) + " names vertex " +
                               std::to_string(index) + " of " +
                               std::to_string(arrays_out.vertices.size()));
            }
            triangle[k] = static_cast<std::uint32_t>(index);
        }
        arrays_out.triangles.push_back(triangle);
    }
    arrays_out.parts.push_back(
        {nameless_part, 0, static_cast<std::uint32_t>(arrays_out.triangles.size())});
    auto mesh = Mesh::create(std::move(arrays_out));
    if (!mesh) {
        return bad(path, mesh.error().detail);
    }
    ImportedMesh imported;
    imported.mesh = std::make_shared<const Mesh>(std::move(mesh.value()));
    return imported;
}

} // namespace cd
