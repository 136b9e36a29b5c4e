// Trees on disk, one file for each form, mapped and used in place.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

/// Raised whenever the builder makes other trees of the same mesh and options.
inline constexpr std::uint32_t tree_build_version = 2;

/// Names all that decides the bytes of a mesh's tree. They are the same on every host.
[[nodiscard]] Sha256 tree_key(const Sha256& mesh, const BuildOptions& options);

/// Nodes, order of triangles and topology; the mesh stands elsewhere.
[[nodiscard]] Status write_tree_file(const std::filesystem::path& path,
                                     const ObbTree& tree,
                                     const Sha256& key,
                                     Durability durability);
/// A wide tree, which may be one without nodes, and the topology.
[[nodiscard]] Status write_wide_tree_file(const std::filesystem::path& path,
                                          const ObbTree& tree,
                                          const Sha256& key,
                                          Durability durability);

/// The tree of `mesh`, in the one form that the file has. All bytes are held against checksums, and
/// what a traversal follows is checked besides: no file makes it read what is not there, go on
/// forever, or miss or repeat a triangle. That boxes contain their triangles, and these are the
/// mesh's, only the checksums and the key vouch for. Errors: NotFound; Io naming the file when it
/// is damaged or was made for another key.
[[nodiscard]] Result<std::shared_ptr<const ObbTree>> read_tree_file(
    const std::filesystem::path& path, std::shared_ptr<const Mesh> mesh, const Sha256& key);
[[nodiscard]] Result<std::shared_ptr<const ObbTree>> read_wide_tree_file(
    const std::filesystem::path& path, std::shared_ptr<const Mesh> mesh, const Sha256& key);

/// Tells one tree of a mesh from another, for what is derived from it.
[[nodiscard]] std::uint64_t tree_checksum(const ObbTree& tree);

} // namespace cd
