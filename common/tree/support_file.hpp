// Files of support points, mapped and used without a copy.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/tree/obb_tree.hpp"

#include <filesystem>
#include <memory>

namespace cd {

/// Writes the support points of a tree's wide form, which has them. `key` is the tree's
/// (`tree_key`). Errors: Io.
[[nodiscard]] Status write_support_file(const std::filesystem::path& path,
                                        const ObbTree& tree,
                                        const Sha256& key,
                                        Durability durability);

/// Returns `tree`, whose wide form has nodes, with the support points of a file. Checks all bytes
/// against checksums, and that all indices are in bounds. Only the checksums and the key guarantee
/// that the points span the nodes. Errors: NotFound; Io naming a file that is damaged or was made
/// for another key or tree.
[[nodiscard]] Result<std::shared_ptr<const ObbTree>>
read_support_file(const std::filesystem::path& path, const ObbTree& tree, const Sha256& key);

} // namespace cd
