#include "client/remote/mesh_cache.hpp"

#include "client/remote/connection.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/errors.hpp"

#include <array>
#include <string_view>
#include <system_error>
#include <utility>

namespace cd {

namespace {

constexpr std::string_view mesh_suffix = ".mesh";

} // namespace

std::filesystem::path mesh_file_path(const std::filesystem::path& folder, const Sha256& mesh) {
    return folder / (to_hex(mesh) + std::string(mesh_suffix));
}

Status write_mesh_file(const std::filesystem::path& path, const Mesh& mesh, Durability durability) {
    auto file = CD_TRY(DiskFile::create_for(path));
    CD_TRY(file.write_at(0, mesh.canonical_bytes()));
    return file.commit(durability);
}

Result<std::shared_ptr<const Mesh>> read_mesh_file(const std::filesystem::path& path,
                                                   const Sha256& expected) {
    const auto file = CD_TRY(DiskFile::open(path));
    const auto size = file.size();
    const auto bytes = CD_TRY(size ? file.read_at(0, size.value()) : Result<Bytes>(size.error()));
    auto mesh = Mesh::from_canonical_bytes(bytes);
    if (!mesh || mesh.value().hash() != expected) {
        return Error{ErrorCode::Io, path.string() + " is damaged: it has another SHA-256"};
    }
    return std::make_shared<const Mesh>(std::move(mesh.value()));
}

std::shared_ptr<const Mesh> MeshCache::find(const Sha256& mesh) const {
    if (folder_.empty()) {
        return nullptr;
    }
    const std::filesystem::path path = mesh_file_path(folder_, mesh);
    const auto found = read_mesh_file(path, mesh);
    if (!found) {
        return nullptr;
    }
    // Marks the file as just used, for `keep_within`; this fails harmlessly in a read-only folder.
    std::error_code ignored;
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now(), ignored);
    return found.value();
}

void MeshCache::keep(const Mesh& mesh) const {
    if (folder_.empty() || !make_directories(folder_)) {
        return;
    }
    const std::filesystem::path path = mesh_file_path(folder_, mesh.hash());
    // Syncing costs more than fetching a mesh again that was lost in a power failure.
    if (write_mesh_file(path, mesh, Durability::Unsynced)) {
        keep_within(folder_, std::array{mesh_suffix}, bytes_max_, path);
    }
}

Result<std::shared_ptr<const Mesh>>
get_mesh(Connection& connection, const Sha256& mesh, const MeshCache& cache) {
    if (auto kept = cache.find(mesh)) {
        return kept;
    }
    auto fetched = CD_TRY(connection.fetch_mesh(mesh));
    cache.keep(fetched);
    return std::make_shared<const Mesh>(std::move(fetched));
}

} // namespace cd
