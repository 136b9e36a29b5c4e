#include "master/page/state_sizes.hpp"

#include <cstdint>
#include <string_view>
#include <system_error>

namespace cd {

namespace {

/// Returns the sum of the sizes of the files in `folder` whose names end in `ending`.
std::uint64_t bytes_in(const std::filesystem::path& folder, std::string_view ending = {}) {
    std::uint64_t bytes = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error)) {
        std::error_code gone;
        const bool counts = file->path().filename().native().ends_with(ending);
        const std::uintmax_t size =
            counts && file->is_regular_file(gone) ? file->file_size(gone) : 0;
        bytes += gone ? 0 : size;
    }
    return bytes;
}

} // namespace

StateSizes measure_state(const std::filesystem::path& state) {
    StateSizes sizes;
    sizes.results = bytes_in(state / "jobs", ".results");
    sizes.poses = bytes_in(state / "jobs", ".poses") + bytes_in(state / "jobs", ".labels");
    sizes.meshes = bytes_in(state / "meshes");
    sizes.trees = bytes_in(state / "trees") + bytes_in(state / "blocks");
    for (const char* name : {"journal.db", "journal.db-wal", "journal.db-shm", "journal.mark"}) {
        std::error_code missing;
        const std::uintmax_t size = std::filesystem::file_size(state / name, missing);
        sizes.journal += missing ? 0 : size;
    }
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(state, unknown);
    sizes.free = unknown ? 0 : space.available;
    return sizes;
}

std::uint64_t disk_bytes(const std::filesystem::path& state) {
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(state, unknown);
    return unknown ? 0 : space.capacity;
}

} // namespace cd
