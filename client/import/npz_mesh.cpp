#include "client/import/npz_mesh.hpp"

#include "client/formats/npz_file.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": " + detail};
}

bool is_triples(const NpyHeader& header) {
    return header.shape.size() == 2 && header.shape[1] == 3;
}

/// Calls `take` with the array's elements in C order: in pieces, or as a whole for an array in
/// Fortran order.
template <class Take>
Status each_piece(const NpzFile& file, const std::string& name, NpzArray& array, Take take) {
    if (array.header().is_fortran) {
        const auto whole = file.read(name);
        return whole ? take(whole.value()) : Status(whole.error());
    }
    for (;;) {
        const auto piece = array.next();
        if (!piece) {
            return piece.error();
        }
        if (piece.value().data.empty()) {
            return Done{};
        }
        if (Status taken = take(piece.value()); !taken) {
            return taken;
        }
    }
}

class NpzMeshReader {
  public:
    NpzMeshReader(const std::filesystem::path& path, const NpzFile& file, double factor)
        : path_(path), file_(file), factor_(factor) {}

    Result<MeshArrays> read() {
        auto vertices = file_.array("vertices");
        auto faces = file_.array("faces");
        if (!vertices || !faces) {
            return vertices ? faces.error() : vertices.error();
        }
        if (!is_triples(vertices.value().header()) || !is_triples(faces.value().header())) {
            return bad(path_, "'vertices' must be of shape (N, 3) and 'faces' of shape (M, 3)");
        }
        if (vertices.value().header().shape[0] > limits::mesh_vertices_max ||
            faces.value().header().shape[0] > limits::mesh_triangles_max) {
            return bad(path_, "has more vertices or faces than a mesh may have");
        }
        arrays_.vertices.reserve(vertices.value().header().shape[0]);
        arrays_.triangles.reserve(faces.value().header().shape[0]);
        Status read = each_piece(file_, "vertices", vertices.value(), [&](const NpyArray& piece) {
            return add_vertices(piece);
        });
        if (read) {
            read = each_piece(file_, "faces", faces.value(), [&](const NpyArray& piece) {
                return add_faces(piece);
            });
        }
        if (!read) {
            return read.error();
        }
        arrays_.precision = Precision::Double;
        arrays_.parts.push_back(
            {nameless_part, 0, static_cast<std::uint32_t>(arrays_.triangles.size())});
        return std::move(arrays_);
    }

  private:
    Status add_vertices(const NpyArray& piece) {
        const std::vector<double> values = piece.to_doubles();
        for (std::size_t i = 0; i < values.size(); i += 3) {
            arrays_.vertices.emplace_back(factor_ * Vec3(values[i], values[i + 1], values[i + 2]));
        }
        return Done{};
    }

    Status add_faces(const NpyArray& piece) {
        const auto indices = piece.to_integers();
        if (!indices) {
            return bad(path_, "'faces': " + indices.error().detail);
        }
        for (std::size_t i = 0; i < indices.value().size(); i += 3) {
            Triangle triangle{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t index = indices.value()[i + k];
                if (index < 0 || static_cast<std::uint64_t>(index) >= arrays_.vertices.size()) {
                    return bad(path_,
                               "face " + std::to_string(arrays_.triangles.size()) +
                                   " names vertex " + std::to_string(index) + " of " +
                                   std::to_string(arrays_.vertices.size()));
                }
                triangle[k] = static_cast<std::uint32_t>(index);
            }
            arrays_.triangles.push_back(triangle);
        }
        return Done{};
    }

    const std::filesystem::path& path_;
    const NpzFile& file_;
    double factor_;
    MeshArrays arrays_;
};

} // namespace

Result<ImportedMesh> import_npz(const std::filesystem::path& path, const ImportOptions& options) {
    const auto file = NpzFile::open(path);
    if (!file) {
        return Error{ErrorCode::BadInput, file.error().detail};
    }
    const std::vector<std::string> names = file.value().names();
    const auto has = [&](const char* name) {
        return std::ranges::find(names, name) != names.end();
    };
    if (!has("vertices") || !has("faces")) {
        return bad(path, "has no arrays 'vertices' and 'faces'");
    }
    auto arrays = NpzMeshReader(path, file.value(), options.unit_factor).read();
    if (!arrays) {
        return arrays.error();
    }
    auto mesh = Mesh::create(std::move(arrays.value()));
    if (!mesh) {
        return bad(path, mesh.error().detail);
    }
    ImportedMesh imported;
    imported.mesh = std::make_shared<const Mesh>(std::move(mesh.value()));
    return imported;
}

} // namespace cd
