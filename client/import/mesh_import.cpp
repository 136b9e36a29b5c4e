#include "client/import/mesh_import.hpp"

#include "client/base/words.hpp"
#include "client/import/float_rounding.hpp"
#include "client/import/foreign/ac3d_text.hpp"
#include "client/import/foreign/assimp_checks.hpp"
#include "client/import/foreign/assimp_import.hpp"
#include "client/import/foreign/foreign_format.hpp"
#include "client/import/gltf/gltf_import.hpp"
#include "client/import/npz_mesh.hpp"
#include "client/import/text/obj_mesh.hpp"
#include "client/import/text/off_mesh.hpp"
#include "client/import/text/ply_mesh.hpp"
#include "client/import/text/stl_mesh.hpp"
#include "client/import/up_axis.hpp"
#include "common/core/files/disk_file.hpp"
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

Error bad(const std::filesystem::path& path, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": " + detail};
}

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

/// The native reader for an extension, or null.
Reader reader_of(const std::string& extension) {
    constexpr std::array<std::pair<std::string_view, Reader>, 4> readers{
        {{".stl", import_stl}, {".obj", import_obj}, {".ply", import_ply}, {".off", import_off}}};
    const auto found = std::find_if(readers.begin(), readers.end(), [&](const auto& reader) {
        return reader.first == extension;
    });
    return found == readers.end() ? nullptr : found->second;
}

/// Reads a format without a native reader.
Result<ImportedMesh> import_others(const std::filesystem::path& path,
                                   const ImportOptions& options) {
    const std::string extension = lower_extension(path);
    if (const Status sound = check_for_assimp(path, extension); !sound) {
        return sound.error();
    }
    if (!is_ac3d(path, extension)) {
        return import_with_assimp(path, options);
    }
    const auto triangles = count_ac3d_triangles(path);
    if (!triangles) {
        return triangles.error();
    }
    auto imported = import_with_assimp(path, options);
    if (imported && imported.value().mesh->triangles().size() != triangles.value()) {
        return bad(path,
                   "the file's faces make " + std::to_string(triangles.value()) +
                       " triangles, but the importer took " +
                       std::to_string(imported.value().mesh->triangles().size()));
    }
    return imported;
}

/// Checks that the path names a file that is not empty.
Status check_file(const std::filesystem::path& path) {
    if (path.empty()) {
        return Error{ErrorCode::BadInput, "a mesh file without a name; name the file to be read"};
    }
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        return bad(path, "no such file");
    }
    if (error) {
        return bad(path, "cannot be opened: " + error.message());
    }
    if (std::filesystem::is_directory(status)) {
        return bad(path, "is a folder, not a mesh file; name a file in it");
    }
    if (std::filesystem::file_size(path, error) == 0 && !error) {
        return bad(path, "is empty");
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
        return bad(path, *foreign);
    }
    if (extension == ".npz") {
        return import_npz(path, options);
    }
    const auto mapping = map_file(path);
    if (!mapping) {
        return Error{ErrorCode::BadInput, mapping.error().detail};
    }
    const std::span<const std::byte> bytes = mapping.value().bytes();
    const MeshSource source{
        path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options};
    if (const auto foreign = foreign_format(extension, source.bytes.substr(0, 16))) {
        return bad(path, *foreign);
    }
    if (const Reader read = reader_of(extension)) {
        return read(source);
    }
    return is_gltf(source.bytes, extension) ? read_gltf(source) : import_others(path, options);
}

Result<ImportedMesh> import_checked(const std::filesystem::path& path,
                                    const ImportOptions& options) {
    if (const Status there = check_file(path); !there) {
        return there.error();
    }
    auto imported = import_file(path, options);
    if (!imported) {
        return imported;
    }
    if (options.rounds_to_float) {
        imported = rounded_to_floats(path, std::move(imported.value()));
        if (!imported) {
            return imported;
        }
    }
    warn_of_coarse_floats(path, imported.value());
    return options.is_y_up ? turned_to_z_up(std::move(imported.value())) : std::move(imported);
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
