// Canonical meshes as files, and a folder that keeps those that a master gave between runs.
#pragma once

#include "common/core/disk_file.hpp"
#include "common/core/limits.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

/// "SHA-256.mesh" in a folder.
[[nodiscard]] std::filesystem::path mesh_file_path(const std::filesystem::path& folder,
                                                   const Sha256& mesh);

/// Writes a mesh's canonical bytes. Errors: Io.
[[nodiscard]] Status write_mesh_file(const std::filesystem::path& path,
                                     const Mesh& mesh,
                                     Durability durability = Durability::Synced);

/// Errors: NotFound; Io naming the file, also where it does not have this hash.
[[nodiscard]] Result<std::shared_ptr<const Mesh>> read_mesh_file(const std::filesystem::path& path,
                                                                 const Sha256& expected);

/// The folder `meshes` within that of the trees. Several processes may share it. Nothing that is
/// wrong with it is an error: what cannot be used counts as missing, what cannot be kept is not.
class MeshCache {
  public:
    /// An empty path: nothing is kept or found.
    explicit MeshCache(const std::filesystem::path& tree_cache,
                       std::uint64_t bytes_max = limits::tree_cache_bytes_max)
        : folder_(tree_cache.empty() ? tree_cache : tree_cache / "meshes"), bytes_max_(bytes_max) {}

    /// The mesh, checked against its hash; or null.
    [[nodiscard]] std::shared_ptr<const Mesh> find(const Sha256& mesh) const;
    /// Keeps it. What went unused for longest goes, until the meshes are within the bound.
    void keep(const Mesh& mesh) const;

  private:
    std::filesystem::path folder_;
    std::uint64_t bytes_max_;
};

} // namespace cd
