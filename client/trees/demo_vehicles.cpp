#include "client/trees/demo_vehicles.hpp"

#include "client/formats/gunzip.hpp"

#include <cstdlib>
#include <string>

namespace cd {

namespace {

namespace fs = std::filesystem;

constexpr const char* packed_motorcycle =
    "usr/share/doc/openfoam-examples/examples/resources/geometry/motorBike.obj.gz";
constexpr const char* tram = "usr/share/sumo/data/3D/tram.obj";

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

Error not_installed(const fs::path& path) {
    return {ErrorCode::NotFound,
            "the demo's vehicles are not installed (" + path.string() +
                " is missing); as root: apt-get install --no-install-recommends openfoam-examples "
                "sumo-tools"};
}

/// The motorcycle in the cache, unpacked now if missing.
Result<fs::path> unpacked_motorcycle(const fs::path& cache, const fs::path& root) {
    const fs::path unpacked = cache / "motorBike.obj";
    if (is_file(unpacked)) {
        return unpacked;
    }
    // Minimal systems lack /usr/share/doc; deploy/quickstart then puts the file into the cache.
    for (const fs::path& packed : {root / packed_motorcycle, cache / "motorBike.obj.gz"}) {
        if (!is_file(packed)) {
            continue;
        }
        if (Status done = gunzip(packed, unpacked); !done) {
            return done.error();
        }
        return unpacked;
    }
    return not_installed(root / packed_motorcycle);
}

} // namespace

std::optional<fs::path> own_cache_dir() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache == '/') {
        return fs::path(cache) / "cdcluster";
    }
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') {
        return fs::path(home) / ".cache" / "cdcluster";
    }
    return std::nullopt;
}

fs::path cache_dir() {
    const auto own = own_cache_dir();
    return own ? *own : fs::temp_directory_path() / "cdcluster";
}

Result<std::array<fs::path, 2>> find_vehicles(const fs::path& cache, const fs::path& root) {
    if (!is_file(root / tram)) {
        return not_installed(root / tram);
    }
    std::error_code error;
    fs::create_directories(cache, error);
    if (error) {
        return Error{ErrorCode::Io, cache.string() + ": " + error.message()};
    }
    auto motorcycle = unpacked_motorcycle(cache, root);
    if (!motorcycle) {
        return motorcycle.error();
    }
    return std::array<fs::path, 2>{motorcycle.value(), root / tram};
}

} // namespace cd
