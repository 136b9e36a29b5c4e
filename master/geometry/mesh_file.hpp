// Writes and reads the two files of a mesh: its canonical bytes, and a description.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cd {

inline constexpr std::string_view mesh_suffix = ".mesh";

/// Returns the path of a mesh in the state directory.
[[nodiscard]] std::filesystem::path mesh_path(const std::filesystem::path& state,
                                              const Sha256& hash);

/// A mesh's description, readable without opening the mesh.
struct MeshInfo {
    std::string name;
    std::uint64_t triangles = 0;
};

[[nodiscard]] Status write_info(const std::filesystem::path& path, const MeshInfo& info);
/// Reads a description. If that fails, logs the error and returns an empty one, since only people
/// use it.
[[nodiscard]] MeshInfo read_info(const std::filesystem::path& path);

/// Reads the mesh with this hash. Errors: NotFound; Io naming a file that is damaged or unreadable.
[[nodiscard]] Result<std::shared_ptr<const Mesh>> read_mesh(const std::filesystem::path& path,
                                                            const Sha256& hash);

} // namespace cd
