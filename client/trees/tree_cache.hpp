// A bounded folder of trees kept between runs.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/result.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// The value of --tree-cache that disables the cache.
inline constexpr const char* no_tree_cache = "off";

/// Returns the folder that --tree-cache names; empty for `no_tree_cache`.
[[nodiscard]] std::filesystem::path tree_cache_folder(const std::string& option);

/// Returns the default of --tree-cache: a folder below `own_cache_dir`, or `no_tree_cache` if the
/// environment names no cache folder.
[[nodiscard]] std::string default_tree_cache();

/// Removes files whose names have one of the suffixes, also partly written ones, from a folder: the
/// least recently used first, until the rest has at most `bytes_max` bytes. `newest` goes last.
void keep_within(const std::filesystem::path& folder,
                 std::span<const std::string_view> suffixes,
                 std::uint64_t bytes_max,
                 const std::filesystem::path& newest);

/// Returns the size of the trees that are kept in a folder.
[[nodiscard]] std::uint64_t kept_tree_bytes(const std::filesystem::path& folder);

/// The form of a tree: binary as in the paper, or wide (16 children a node), which searches
/// use.
enum class TreeForm : std::uint8_t { Binary, Wide };

/// A cache with one file for each form of a mesh's tree and one for its support points, named by a
/// hash of everything that decides its bytes. Processes may share a folder. Problems give warnings,
/// never errors: an unusable file counts as missing, and a tree that cannot be written is not kept.
class TreeCache {
  public:
    /// An empty path disables the cache. The folder is created by the first `keep`.
    explicit TreeCache(std::filesystem::path folder,
                       std::uint64_t bytes_max = limits::tree_cache_bytes_max)
        : folder_(std::move(folder)), bytes_max_(bytes_max) {}

    /// Returns the mesh's tree with only this form, memory-mapped; null if it is not cached.
    [[nodiscard]] std::shared_ptr<const ObbTree> find(TreeForm form,
                                                      const std::shared_ptr<const Mesh>& mesh);
    /// Writes this form of a tree, which was built with default options, to the folder. Removes the
    /// least recently used files until the folder is within its bound.
    void keep(TreeForm form, const ObbTree& tree);

    /// Returns `tree`, whose wide form has nodes, with its support points; null if the points are
    /// not cached.
    [[nodiscard]] std::shared_ptr<const ObbTree> find_points(const ObbTree& tree);
    /// Writes the support points of a tree as `keep` writes a form.
    void keep_points(const ObbTree& tree);

    /// Returns the warnings since the last call of `take_warnings`, one line each.
    [[nodiscard]] std::vector<std::string> take_warnings();

  private:
    [[nodiscard]] std::filesystem::path path_of(const Sha256& key, std::string_view suffix) const;
    [[nodiscard]] std::shared_ptr<const ObbTree>
    used(const Result<std::shared_ptr<const ObbTree>>& tree,
         const std::filesystem::path& path,
         const char* otherwise);
    using Write = std::function<Status(const std::filesystem::path& path, const Sha256& key)>;
    void keep(const ObbTree& tree, std::string_view suffix, const Write& write);

    std::filesystem::path folder_;
    std::uint64_t bytes_max_;
    std::vector<std::string> warnings_;
};

} // namespace cd
