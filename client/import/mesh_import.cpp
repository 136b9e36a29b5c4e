#include "client/import/mesh_import.hpp"

#include "client/import/assimp_mesh.hpp"
#include "client/import/foreign_format.hpp"
#include "client/import/gltf_import.hpp"
#include "client/import/mesh_number_check.hpp"
#include "client/import/mesh_text_check.hpp"
#include "client/import/npz_mesh.hpp"
#include "client/words.hpp"
#include "common/core/disk_file.hpp"
#include "common/geometry/aabb.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <system_error>

namespace cd {

namespace {

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

/// Floats far from the origin are coarse: a warning where their step there is visible at the
/// body's own size.
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
            path.string() + ": floats are coarse here: their step at the box's far corner is " +
            exact_text(step) + ", the diagonal " + exact_text(box.diagonal()) +
            "; move the model to its origin, or use .npz, which keeps doubles (float64)");
    }
}

Result<FileMapping> map_file(const std::filesystem::path& path) {
    const auto file = DiskFile::open(path);
    return file ? file.value().map() : Result<FileMapping>(file.error());
}

} // namespace

Result<ImportedMesh> import_mesh(const std::filesystem::path& path, const ImportOptions& options) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::none) {
        return bad(path, error.message()); // A loop of links, or a folder that may not be entered.
    }
    if (!std::filesystem::exists(status)) {
        return bad(path, "no such file");
    }
    if (std::filesystem::is_directory(status)) {
        return bad(path, "is a folder, not a mesh file");
    }
    if (std::filesystem::file_size(path, error) == 0 && !error) {
        return bad(path, "is empty");
    }
    const std::string extension = lower_extension(path);
    if (const auto foreign = foreign_format(extension, "")) {
        return bad(path, *foreign);
    }
    if (extension == ".npz") {
        return import_npz(path, options);
    }
    const auto bytes = map_file(path);
    if (!bytes) {
        return bytes.error();
    }
    const std::string_view text_bytes(reinterpret_cast<const char*>(bytes.value().bytes().data()),
                                      bytes.value().bytes().size());
    if (const auto foreign = foreign_format(extension, text_bytes.substr(0, 16))) {
        return bad(path, *foreign);
    }
    if (is_gltf(text_bytes, extension)) {
        auto imported = read_gltf({path, text_bytes, options});
        if (imported) {
            warn_of_coarse_floats(path, imported.value());
        }
        return imported;
    }
    if (const Status numbers = check_numbers(path, extension); !numbers) {
        return numbers.error();
    }
    const auto text = read_text_mesh(path, extension);
    if (!text) {
        return text.error();
    }
    auto imported = import_with_assimp(path, options);
    if (!imported) {
        return imported;
    }
    if (text.value()) {
        const Mesh& mesh = *imported.value().mesh;
        if (const Status same = check_against_text(path, *text.value(), options, mesh); !same) {
            return same.error();
        }
    }
    warn_of_coarse_floats(path, imported.value());
    return imported;
}

} // namespace cd
