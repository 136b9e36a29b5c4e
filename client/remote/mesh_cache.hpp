// Mesh files in canonical form, and a cache of meshes fetched from a master.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

/// Returns the path of a mesh's file in a folder: its hash in hex, with the suffix ".mesh".
[[nodiscard]] std::filesystem::path mesh_file_path(const std::filesystem::path& folder,
                                                   const Sha256& mesh);

/// Writes a mesh's canonical bytes to a file. Errors: Io.
[[nodiscard]] Status write_mesh_file(const std::filesystem::path& path,
                                     const Mesh& mesh,
                                     Durability durability = Durability::Synced);

/// Reads a mesh file. Errors: NotFound; Io naming the file, also if its hash is not `expected`.
[[nodiscard]] Result<std::shared_ptr<const Mesh>> read_mesh_file(const std::filesystem::path& path,
                                                                 const Sha256& expected);

/// The mesh files in the folder `meshes` of the tree cache, which several processes may use. The
/// cache reports no errors: an unusable file counts as missing; a mesh that cannot be written is
/// not kept.
class MeshCache {
  public:
    /// An empty path disables the cache.
    explicit MeshCache(const std::filesystem::path& tree_cache,
                       std::uint64_t bytes_max = limits::tree_cache_bytes_max)
        : folder_(tree_cache.empty() ? tree_cache : tree_cache / "meshes"), bytes_max_(bytes_max) {}

    /// Returns the mesh, checked against its hash; null if it is not cached.
    [[nodiscard]] std::shared_ptr<const Mesh> find(const Sha256& mesh) const;
    /// Writes a mesh, and removes the least recently used ones until the cache is within its bound.
    void keep(const Mesh& mesh) const;

  private:
    std::filesystem::path folder_;
    std::uint64_t bytes_max_;
};

class Connection;

/// Takes a mesh from the cache, or else from the master, and keeps it. Errors: the connection's.
[[nodiscard]] Result<std::shared_ptr<const Mesh>>
get_mesh(Connection& connection, const Sha256& mesh, const MeshCache& cache);

} // namespace cd
