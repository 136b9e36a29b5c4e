#include "client/trees/tree_cache.hpp"

#include "client/base/cache_folder.hpp"
#include "common/tree/support_file.hpp"
#include "common/tree/tree_file.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

namespace cd {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view binary_suffix = ".binary-tree";
constexpr std::string_view wide_suffix = ".wide-tree";
constexpr std::string_view points_suffix = ".points";

constexpr std::string_view suffix_of(TreeForm form) {
    return form == TreeForm::Binary ? binary_suffix : wide_suffix;
}

/// True if a file's name has one of the suffixes, also while the file is being written.
bool ends_with(const fs::path& path, std::span<const std::string_view> suffixes) {
    std::string name = path.filename().string();
    name = name.substr(0, name.find(temporary_marker));
    return std::ranges::any_of(suffixes,
                               [&](std::string_view suffix) { return name.ends_with(suffix); });
}

struct KeptFile {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t bytes = 0;
};

/// Lists the files with one of the suffixes, least recently used first. Skips files that vanish.
std::vector<KeptFile> kept_files(const fs::path& folder,
                                 std::span<const std::string_view> suffixes) {
    std::vector<KeptFile> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code gone;
        const std::uint64_t bytes = entry->file_size(gone);
        const fs::file_time_type used = gone ? fs::file_time_type() : entry->last_write_time(gone);
        if (!gone && ends_with(entry->path(), suffixes)) {
            files.push_back({used, entry->path(), bytes});
        }
    }
    std::ranges::sort(files, [](const KeptFile& a, const KeptFile& b) {
        return std::pair(a.used, a.path) < std::pair(b.used, b.path);
    });
    return files;
}

} // namespace

fs::path tree_cache_folder(const std::string& option) {
    return option == no_tree_cache ? fs::path() : fs::path(option);
}

void keep_within(const fs::path& folder,
                 std::span<const std::string_view> suffixes,
                 std::uint64_t bytes_max,
                 const fs::path& newest) {
    std::vector<KeptFile> files = kept_files(folder, suffixes);
    std::uint64_t bytes = 0;
    for (const KeptFile& file : files) {
        bytes += file.bytes;
    }
    // Moves `newest` to the end, so that a wrong clock does not make it look old.
    std::ranges::stable_partition(files, [&](const KeptFile& file) { return file.path != newest; });
    for (const KeptFile& file : files) {
        if (bytes <= bytes_max) {
            break;
        }
        std::error_code ignored;
        fs::remove(file.path, ignored);
        bytes -= file.bytes;
    }
}

std::uint64_t kept_tree_bytes(const fs::path& folder) {
    std::uint64_t bytes = 0;
    for (const KeptFile& file :
         kept_files(folder, std::array{binary_suffix, wide_suffix, points_suffix})) {
        bytes += file.bytes;
    }
    return bytes;
}

std::string default_tree_cache() {
    const std::optional<fs::path> cache = own_cache_dir();
    return cache ? (*cache / "trees").string() : no_tree_cache;
}

fs::path TreeCache::path_of(const Sha256& key, std::string_view suffix) const {
    return folder_ / (to_hex(key) + std::string(suffix));
}

/// Returns what was read from a file, or null, with a warning of what happens `otherwise` if the
/// file exists.
std::shared_ptr<const ObbTree> TreeCache::used(const Result<std::shared_ptr<const ObbTree>>& tree,
                                               const fs::path& path,
                                               const char* otherwise) {
    if (tree) {
        // Marks the file as just used, which fails harmlessly in a read-only folder.
        std::error_code ignored;
        fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
        return tree.value();
    }
    if (tree.error().code != ErrorCode::NotFound) {
        warnings_.push_back("warning: " + std::string(otherwise) + ": " + tree.error().detail);
    }
    return nullptr;
}

std::shared_ptr<const ObbTree> TreeCache::find(TreeForm form,
                                               const std::shared_ptr<const Mesh>& mesh) {
    if (folder_.empty()) {
        return nullptr;
    }
    const Sha256 key = tree_key(mesh->hash(), BuildOptions{});
    const fs::path path = path_of(key, suffix_of(form));
    return used(form == TreeForm::Binary ? read_tree_file(path, mesh, key)
                                         : read_wide_tree_file(path, mesh, key),
                path,
                "a tree is built anew");
}

std::shared_ptr<const ObbTree> TreeCache::find_points(const ObbTree& tree) {
    if (folder_.empty()) {
        return nullptr;
    }
    const Sha256 key = tree_key(tree.mesh().hash(), BuildOptions{});
    const fs::path path = path_of(key, points_suffix);
    return used(read_support_file(path, tree, key), path, "kept support points are not used");
}

void TreeCache::keep(const ObbTree& tree, std::string_view suffix, const Write& write) {
    if (folder_.empty()) {
        return;
    }
    const Sha256 key = tree_key(tree.mesh().hash(), BuildOptions{});
    const fs::path path = path_of(key, suffix);
    Status kept = make_directories(folder_);
    if (kept) {
        // Files are not synced: that costs more than rebuilding a tree lost in a power failure.
        kept = write(path, key);
    }
    if (kept) {
        keep_within(
            folder_, std::array{binary_suffix, wide_suffix, points_suffix}, bytes_max_, path);
    } else {
        warnings_.push_back("warning: a tree is not kept for later runs: " + kept.error().detail);
    }
}

void TreeCache::keep(TreeForm form, const ObbTree& tree) {
    keep(tree, suffix_of(form), [&](const fs::path& path, const Sha256& key) {
        return form == TreeForm::Binary
                   ? write_tree_file(path, tree, key, Durability::Unsynced)
                   : write_wide_tree_file(path, tree, key, Durability::Unsynced);
    });
}

void TreeCache::keep_points(const ObbTree& tree) {
    keep(tree, points_suffix, [&](const fs::path& path, const Sha256& key) {
        return write_support_file(path, tree, key, Durability::Unsynced);
    });
}

std::vector<std::string> TreeCache::take_warnings() {
    return std::exchange(warnings_, {});
}

} // namespace cd
