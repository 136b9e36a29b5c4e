#include "client/import/npz_mesh.hpp"

#include "client/formats/npz_file.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <string_view>

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": " + detail};
}

bool has_array(const NpzFile& file, const std::string& name) {
    const std::vector<std::string> names = file.names();
    return std::ranges::find(names, name) != names.end();
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
        if (Status added = add_parts(); !added) {
            return added.error();
        }
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

    /// Reads the parts, or makes all triangles one part.
    Status add_parts() {
        if (!has_array(file_, "parts") || !has_array(file_, "part_names")) {
            arrays_.parts.push_back(
                {nameless_part, 0, static_cast<std::uint32_t>(arrays_.triangles.size())});
            return Done{};
        }
        const auto table = file_.read("parts");
        const auto names = file_.read("part_names");
        if (!table || !names) {
            return table ? names.error() : table.error();
        }
        const std::vector<std::uint64_t>& shape = table.value().shape;
        if (table.value().type != NpyType::U4 || shape.size() != 2 || shape[1] != 3 ||
            names.value().type != NpyType::U1) {
            return bad(path_, "'parts' must be <u4 of shape (P, 3), and 'part_names' |u1");
        }
        const std::vector<std::int64_t> values = table.value().to_integers().value();
        std::string_view rest(reinterpret_cast<const char*>(names.value().data.data()),
                              names.value().data.size());
        for (std::size_t i = 0; i < values.size(); i += 3) {
            const auto name_bytes = static_cast<std::size_t>(values[i + 2]);
            if (name_bytes > rest.size()) {
                return bad(path_,
                           "'part_names' ends within the name of part " + std::to_string(i / 3));
            }
            arrays_.parts.push_back({std::string(rest.substr(0, name_bytes)),
                                     static_cast<std::uint32_t>(values[i]),
                                     static_cast<std::uint32_t>(values[i + 1])});
            rest.remove_prefix(name_bytes);
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
    if (!has_array(file.value(), "vertices") || !has_array(file.value(), "faces")) {
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
