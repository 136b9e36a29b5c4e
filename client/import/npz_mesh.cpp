#include "client/formats/npz_file.hpp"
#include "client/import/mesh_readers.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <string_view>

namespace cd {

namespace {

bool has_array(const NpzFile& file, const std::string& name) {
    const std::vector<std::string> names = file.names();
    return std::ranges::find(names, name) != names.end();
}

bool is_triples(const std::vector<std::uint64_t>& shape) {
    return shape.size() == 2 && shape[1] == 3;
}

/// Passes the array's elements to `take` in C order. An array in C order is passed in pieces, an
/// array in Fortran order as a whole.
template <class Take>
Status each_piece(const NpzFile& file, const std::string& name, NpzArray& array, Take take) {
    if (array.header().is_fortran) {
        const auto whole = file.read(name);
        return whole ? take(whole.value()) : Status(whole.error());
    }
    for (;;) {
        const auto piece = CD_TRY(array.next());
        if (piece.data.empty()) {
            return Done{};
        }
        CD_TRY(take(piece));
    }
}

class NpzMeshReader {
  public:
    NpzMeshReader(const std::filesystem::path& path, const NpzFile& file, double factor)
        : path_(path), file_(file), factor_(factor) {}

    Result<MeshArrays> read() {
        auto vertices = CD_TRY(file_.array("vertices"));
        auto faces = CD_TRY(file_.array("faces"));
        const std::vector<std::uint64_t>& vertices_shape = vertices.header().shape;
        const std::vector<std::uint64_t>& faces_shape = faces.header().shape;
        if (!is_triples(vertices_shape) || !is_triples(faces_shape)) {
            return bad_input(path_,
                             "'vertices' must be of shape (N, 3) and 'faces' of shape (M, 3)");
        }
        if (vertices_shape[0] > limits::mesh_vertices_max ||
            faces_shape[0] > limits::mesh_triangles_max) {
            return bad_input(path_, "has more vertices or faces than a mesh may have");
        }
        arrays_.vertices.reserve(vertices_shape[0]);
        arrays_.triangles.reserve(faces_shape[0]);
        CD_TRY(each_piece(file_, "vertices", vertices, [&](const NpyArray& piece) {
            return add_vertices(piece);
        }));
        CD_TRY(each_piece(
            file_, "faces", faces, [&](const NpyArray& piece) { return add_faces(piece); }));
        arrays_.precision = Precision::Double;
        CD_TRY(add_parts());
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
            return bad_input(path_, "'faces': " + indices.error().detail);
        }
        for (std::size_t i = 0; i < indices.value().size(); i += 3) {
            Triangle triangle{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t index = indices.value()[i + k];
                if (index < 0 || static_cast<std::uint64_t>(index) >= arrays_.vertices.size()) {
                    return bad_input(path_,
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

    /// Reads the parts; a file without parts gets one part with all triangles.
    Status add_parts() {
        if (!has_array(file_, "parts") || !has_array(file_, "part_names")) {
            arrays_.parts.push_back(
                {nameless_part, 0, static_cast<std::uint32_t>(arrays_.triangles.size())});
            return Done{};
        }
        const NpyArray table = CD_TRY(file_.read("parts"));
        const NpyArray names = CD_TRY(file_.read("part_names"));
        const std::vector<std::uint64_t>& shape = table.shape;
        if (table.type != NpyType::U4 || shape.size() != 2 || shape[1] != 3 ||
            names.type != NpyType::U1) {
            return bad_input(path_, "'parts' must be <u4 of shape (P, 3), and 'part_names' |u1");
        }
        const std::vector<std::int64_t> values = table.to_integers().value();
        std::string_view rest(reinterpret_cast<const char*>(names.data.data()), names.data.size());
        for (std::size_t i = 0; i < values.size(); i += 3) {
            const auto name_bytes = static_cast<std::size_t>(values[i + 2]);
            if (name_bytes > rest.size()) {
                return bad_input(
                    path_, "'part_names' ends within the name of part " + std::to_string(i / 3));
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
        return bad_input(file.error().detail);
    }
    if (!has_array(file.value(), "vertices") || !has_array(file.value(), "faces")) {
        return bad_input(path, "has no arrays 'vertices' and 'faces'");
    }
    auto arrays = CD_TRY(NpzMeshReader(path, file.value(), options.unit_factor).read());
    auto mesh = CD_TRY(within(path.string() + ": ", Mesh::create(std::move(arrays))));
    ImportedMesh imported;
    imported.mesh = std::make_shared<const Mesh>(std::move(mesh));
    return imported;
}

} // namespace cd
