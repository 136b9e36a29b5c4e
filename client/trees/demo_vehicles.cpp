#include "client/trees/demo_vehicles.hpp"

#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"

#include <zlib.h>

#include <cstdlib>

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

struct Close {
    void operator()(gzFile file) const { gzclose(file); }
};

/// Unpacks the .gz file `from` to `to`, which appears only when it is complete. Errors: Io naming
/// the file; BadInput if `from` is damaged.
Status gunzip(const fs::path& from, const fs::path& to) {
    const std::unique_ptr<gzFile_s, Close> in(gzopen(from.c_str(), "rb"));
    if (!in) {
        return Error{ErrorCode::Io, from.string() + ": cannot be opened"};
    }
    auto out = CD_TRY(OutputFile::create(to));
    std::vector<char> buffer(1u << 20);
    int size = 0;
    while ((size = gzread(in.get(), buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
        const std::string_view text(buffer.data(), static_cast<std::size_t>(size));
        CD_TRY(out.write(text));
    }
    // A truncated file ends without an error; only the stream's state reveals it.
    int state = Z_OK;
    const char* message = gzerror(in.get(), &state);
    if (size < 0 || state != Z_OK) {
        return bad_input(from.string() + ": damaged (" + message + ")");
    }
    return out.commit();
}

/// Returns the path of the motorcycle in the cache, and unpacks it if it is missing there.
Result<fs::path> unpacked_motorcycle(const fs::path& cache, const fs::path& root) {
    const fs::path unpacked = cache / "motorBike.obj";
    if (is_file(unpacked)) {
        return unpacked;
    }
    // deploy/quickstart puts the file into the cache on systems without /usr/share/doc.
    for (const fs::path& packed : {root / packed_motorcycle, cache / "motorBike.obj.gz"}) {
        if (!is_file(packed)) {
            continue;
        }
        CD_TRY(gunzip(packed, unpacked));
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
    CD_TRY(make_directories(cache));
    const fs::path motorcycle = CD_TRY(unpacked_motorcycle(cache, root));
    return std::array<fs::path, 2>{motorcycle, root / tram};
}

} // namespace cd
