// An OBB tree on disk: what was expensive to find out about a mesh.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

/// Nodes, order of triangles and topology; the mesh stands in its own file.
[[nodiscard]] Status write_tree_file(const std::filesystem::path& path, const ObbTree& tree);

/// The tree of `mesh`. Everything that a traversal relies on is checked. Errors: NotFound; Io
/// naming the file when it is damaged or belongs to another mesh.
[[nodiscard]] Result<std::shared_ptr<const ObbTree>>
read_tree_file(const std::filesystem::path& path, std::shared_ptr<const Mesh> mesh);

/// Tells one tree of a mesh from another, for what is derived from it.
[[nodiscard]] std::uint64_t tree_checksum(const ObbTree& tree);

} // namespace cd
