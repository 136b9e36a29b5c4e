// A folder that keeps trees between runs, within a bound.
#pragma once

#include "common/core/limits/client.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// The word for no cache at all, where a folder may stand.
inline constexpr const char* no_tree_cache = "off";

/// The folder that an option names: none for `no_tree_cache`.
[[nodiscard]] std::filesystem::path tree_cache_folder(const std::string& option);

/// The option's value where it is not given: below this user's cached files (`cache_dir`), or
/// `no_tree_cache` where the environment does not say where these are.
[[nodiscard]] std::string default_tree_cache();

/// Removes the least recently used files in a folder whose names have one of the suffixes, partly
/// written ones included, until the rest has at most `bytes_max` bytes. `newest` is removed last.
void keep_within(const std::filesystem::path& folder,
                 std::span<const std::string_view> suffixes,
                 std::uint64_t bytes_max,
                 const std::filesystem::path& newest);

/// A tree as the paper has it, or as searches without a tolerance walk it.
enum class TreeForm : std::uint8_t { Binary, Wide };

/// One file for each form of each mesh's tree, named by all that decides its bytes. Several
/// processes may share a folder. Nothing that is wrong with it is an error: a file that cannot be
/// used counts as missing, a tree that cannot be kept is not, and there is a warning.
class TreeCache {
  public:
    /// An empty path: nothing is kept or found. The folder is made when there is something to keep.
    explicit TreeCache(std::filesystem::path folder,
                       std::uint64_t bytes_max = limits::tree_cache_bytes_max)
        : folder_(std::move(folder)), bytes_max_(bytes_max) {}

    /// The mesh's tree with this form alone, mapped; or null.
    [[nodiscard]] std::shared_ptr<const ObbTree> find(TreeForm form,
                                                      const std::shared_ptr<const Mesh>& mesh);
    /// Keeps this form of a tree built with the default options. What went unused for longest goes,
    /// until the folder's trees are within the bound.
    void keep(TreeForm form, const ObbTree& tree);

    /// One line each, since the last call.
    [[nodiscard]] std::vector<std::string> take_warnings();

  private:
    [[nodiscard]] std::filesystem::path path_of(TreeForm form, const Sha256& key) const;

    std::filesystem::path folder_;
    std::uint64_t bytes_max_;
    std::vector<std::string> warnings_;
};

} // namespace cd
