#include "client/import/mesh_import.hpp"

#include "client/import/foreign/ac3d_text.hpp"
#include "client/import/foreign/assimp_checks.hpp"
#include "client/import/foreign/assimp_import.hpp"
#include "client/import/foreign/foreign_format.hpp"
#include "client/import/mesh_builder.hpp"
#include "client/import/mesh_readers.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace cd {

namespace {

using Reader = Result<ImportedMesh> (*)(const MeshSource&);

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    return extension;
}

/// Warns about a body so far from the origin that the step between floats there is more than a
/// millionth of the body's diagonal.
void warn_of_coarse_floats(const std::filesystem::path& path, ImportedMesh& imported) {
    if (imported.mesh->precision() != Precision::Float) {
        return;
    }
    double farthest = 0;
    Aabb box;
    for (const Vec3& vertex : imported.mesh->vertices()) {
        farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
        box.add(vertex);
    }
    const auto corner = std::max(static_cast<float>(farthest), std::numeric_limits<float>::min());
    const double step = std::ldexp(1.0, std::ilogb(corner) - 23);
    if (step > 1e-6 * box.diagonal()) {
        imported.warnings.push_back(
            path.string() + ": floats are coarse here: at the far corner of the box they are " +
            exact_text(step) + " apart, and the diagonal is " + exact_text(box.diagonal()) +
            "; move the model to its origin, or use .npz, which keeps doubles (float64)");
    }
}

/// Returns the arrays of a mesh, to be changed.
MeshArrays arrays_of(const Mesh& mesh) {
    return {mesh.vertices(), mesh.triangles(), mesh.parts(), mesh.precision()};
}

/// Replaces the mesh. Errors: as `Mesh::create`, naming the file.
Result<ImportedMesh>
with_arrays(const std::filesystem::path& path, ImportedMesh imported, MeshArrays arrays) {
    imported.mesh = std::make_shared<const Mesh>(
        CD_TRY(within(path.string() + ": ", Mesh::create(std::move(arrays)))));
    return imported;
}

/// Rounds each coordinate of a mesh once to the nearest float. Triangles keep their numbers and
/// parts; positions that become equal share one vertex, and vertices that no triangle uses are
/// dropped. Errors: BadInput naming a triangle with a coordinate that no float holds.
Result<ImportedMesh> rounded_to_floats(const std::filesystem::path& path, ImportedMesh imported) {
    const Mesh& mesh = *imported.mesh;
    if (mesh.precision() == Precision::Float) {
        return imported;
    }
    MeshBuilder builder;
    for (const Part& part : mesh.parts()) {
        builder.begin_part(part.name);
        for (std::uint32_t i = part.triangles_begin; i < part.triangles_end; ++i) {
            Corners corners = mesh.corners(i);
            for (Vec3& corner : corners) {
                corner = corner.cast<float>().cast<double>().eval();
                if (!corner.allFinite()) {
                    return bad_input(
                        path,
                        "triangle " + std::to_string(i) +
                            " has a coordinate that no float holds; leave out precision = "
                            "\"float\"");
                }
            }
            builder.add(corners);
        }
    }
    imported.mesh = CD_TRY(finish_import(path, builder, Precision::Float)).mesh;
    imported.is_rounded = true;
    return imported;
}

/// Turns y into z and z into -y, exactly. Errors: as `Mesh::create`.
Result<ImportedMesh> turned_to_z_up(const std::filesystem::path& path, ImportedMesh imported) {
    MeshArrays arrays = arrays_of(*imported.mesh);
    for (Vec3& vertex : arrays.vertices) {
        vertex = Vec3(vertex.x(), 0.0 - vertex.z(), vertex.y()); // The subtraction never gives -0.
    }
    return with_arrays(path, std::move(imported), std::move(arrays));
}

/// Subtracts a point from all coordinates, each rounded once to double. The mesh uses floats if
/// they hold all differences. Errors: BadInput naming a vertex whose difference no double holds.
Result<ImportedMesh> moved_to_origin(const std::filesystem::path& path,
                                     ImportedMesh imported,
                                     const std::array<double, 3>& origin) {
    MeshArrays arrays = arrays_of(*imported.mesh);
    for (Vec3& vertex : arrays.vertices) {
        vertex -= Vec3(origin[0], origin[1], origin[2]);
    }
    arrays.precision = precision_of(arrays.vertices);
    return with_arrays(path, std::move(imported), std::move(arrays));
}

/// Returns the native reader for an extension in lower case, or null.
Reader reader_of(const std::string& extension) {
    constexpr std::array<std::pair<std::string_view, Reader>, 4> readers{
        {{".stl", import_stl}, {".obj", import_obj}, {".ply", import_ply}, {".off", import_off}}};
    const auto found = std::find_if(readers.begin(), readers.end(), [&](const auto& reader) {
        return reader.first == extension;
    });
    return found == readers.end() ? nullptr : found->second;
}

/// Reads a file of a format without a native reader, with assimp.
Result<ImportedMesh> import_others(const std::filesystem::path& path,
                                   const ImportOptions& options) {
    const std::string extension = lower_extension(path);
    CD_TRY(check_for_assimp(path, extension));
    if (!is_ac3d(path, extension)) {
        return import_with_assimp(path, options);
    }
    const auto triangles = CD_TRY(count_ac3d_triangles(path));
    auto imported = import_with_assimp(path, options);
    if (imported && imported.value().mesh->triangles().size() != triangles) {
        return bad_input(path,
                         "the file's faces make " + std::to_string(triangles) +
                             " triangles, but the importer took " +
                             std::to_string(imported.value().mesh->triangles().size()));
    }
    return imported;
}

/// Checks that the path names a file, not a folder, and that it is not empty. Errors: BadInput.
Status check_file(const std::filesystem::path& path) {
    if (path.empty()) {
        return bad_input("a mesh file without a name; name the file to be read");
    }
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        return bad_input(path, "no such file");
    }
    if (error) {
        return bad_input(path, "cannot be opened: " + error.message());
    }
    if (std::filesystem::is_directory(status)) {
        return bad_input(path, "is a folder, not a mesh file; name a file in it");
    }
    if (std::filesystem::file_size(path, error) == 0 && !error) {
        return bad_input(path, "is empty");
    }
    return Done{};
}

Result<FileMapping> map_file(const std::filesystem::path& path) {
    const auto file = DiskFile::open(path);
    return file ? file.value().map() : Result<FileMapping>(file.error());
}

Result<ImportedMesh> import_file(const std::filesystem::path& path, const ImportOptions& options) {
    const std::string extension = lower_extension(path);
    if (const auto foreign = foreign_format(extension, "")) {
        return bad_input(path, *foreign);
    }
    if (extension == ".npz") {
        return import_npz(path, options);
    }
    const auto mapping = map_file(path);
    if (!mapping) {
        return bad_input(mapping.error().detail);
    }
    const std::span<const std::byte> bytes = mapping.value().bytes();
    const MeshSource source{
        path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options};
    if (const auto foreign = foreign_format(extension, source.bytes.substr(0, 16))) {
        return bad_input(path, *foreign);
    }
    if (const Reader read = reader_of(extension)) {
        return read(source);
    }
    return is_gltf(source.bytes, extension) ? read_gltf(source) : import_others(path, options);
}

Result<ImportedMesh> import_checked(const std::filesystem::path& path,
                                    const ImportOptions& options) {
    CD_TRY(check_file(path));
    auto imported = CD_TRY(import_file(path, options));
    if (options.is_y_up) {
        imported = CD_TRY(turned_to_z_up(path, std::move(imported)));
    }
    if (options.origin != std::array<double, 3>{}) {
        imported = CD_TRY(moved_to_origin(path, std::move(imported), options.origin));
    }
    if (options.rounds_to_float) {
        imported = CD_TRY(rounded_to_floats(path, std::move(imported)));
    }
    warn_of_coarse_floats(path, imported);
    return imported;
}

} // namespace

Result<ImportedMesh> import_mesh(const std::filesystem::path& path, const ImportOptions& options) {
    try {
        return import_checked(path, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, path.string() + ": too little memory to read it"};
    }
}

} // namespace cd
