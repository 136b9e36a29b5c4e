// A mesh on disk: its canonical bytes, and beside them what is shown of it.
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

/// Where a state directory keeps the mesh of this hash.
[[nodiscard]] std::filesystem::path mesh_path(const std::filesystem::path& state,
                                              const Sha256& hash);

/// The description of a mesh, which is shown without opening the mesh.
struct MeshInfo {
    std::string name;
    std::uint64_t triangles = 0;
};

[[nodiscard]] Status write_info(const std::filesystem::path& path, const MeshInfo& info);
/// A description that cannot be read is logged and left empty: only people use it.
[[nodiscard]] MeshInfo read_info(const std::filesystem::path& path);

/// The mesh of this hash. Errors: NotFound; Io naming the file when it is damaged or cannot be
/// read.
[[nodiscard]] Result<std::shared_ptr<const Mesh>> read_mesh(const std::filesystem::path& path,
                                                            const Sha256& hash);

} // namespace cd
