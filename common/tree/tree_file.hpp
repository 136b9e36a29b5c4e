// Tree files: one file for each form, mapped and used without a copy.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

/// Version of the tree builder. Must increase whenever the builder makes another tree of an
/// unchanged mesh with unchanged options.
inline constexpr std::uint32_t tree_build_version = 2;

/// Returns a hash of everything that decides the bytes of a mesh's tree; equal on all hosts.
[[nodiscard]] Sha256 tree_key(const Sha256& mesh, const BuildOptions& options);

/// Writes the binary form (nodes and order of triangles) and the topology; the mesh has a file of
/// its own.
[[nodiscard]] Status write_tree_file(const std::filesystem::path& path,
                                     const ObbTree& tree,
                                     const Sha256& key,
                                     Durability durability);
/// Writes the wide form, which may have no nodes, and the topology.
[[nodiscard]] Status write_wide_tree_file(const std::filesystem::path& path,
                                          const ObbTree& tree,
                                          const Sha256& key,
                                          Durability durability);

/// Reads the tree of `mesh` from a file of the binary form. Checks all bytes against checksums, and
/// all indices that a traversal follows: no file makes a traversal read out of bounds, loop
/// forever, or miss or repeat a triangle. Only the checksums and the key guarantee that boxes
/// contain their triangles and that the triangles are those of the mesh. Errors: NotFound; Io
/// naming the file when it is damaged or was made for another key.
[[nodiscard]] Result<std::shared_ptr<const ObbTree>> read_tree_file(
    const std::filesystem::path& path, std::shared_ptr<const Mesh> mesh, const Sha256& key);
/// Reads the tree of `mesh` from a file of the wide form, checked like `read_tree_file`'s.
[[nodiscard]] Result<std::shared_ptr<const ObbTree>> read_wide_tree_file(
    const std::filesystem::path& path, std::shared_ptr<const Mesh> mesh, const Sha256& key);

/// Returns a checksum of the binary form, as a key for data derived from this tree of a mesh.
[[nodiscard]] std::uint64_t tree_checksum(const ObbTree& tree);

} // namespace cd
