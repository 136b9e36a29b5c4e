#include "client/demo/demo_vehicles.hpp"

#include "client/demo/obj_file.hpp"
#include "client/demo/vehicle.hpp"
#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"

#include <zlib.h>

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
            "Debian's vehicles are not installed (" + path.string() +
                " is missing); as root: apt-get install --no-install-recommends openfoam-examples "
                "sumo-tools; without --vehicles debian the demo needs no packages"};
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
    const fs::path packed = root / packed_motorcycle;
    if (!is_file(packed)) {
        return not_installed(packed);
    }
    CD_TRY(gunzip(packed, unpacked));
    return unpacked;
}

} // namespace

Result<std::array<fs::path, 2>> write_vehicles(const fs::path& folder) {
    CD_TRY(make_directories(folder));
    const fs::path truck = folder / "truck.obj";
    const fs::path car = folder / "car.obj";
    CD_TRY(write_file(truck, obj_text(*make_vehicle(VehicleKind::Truck, 100'000))));
    CD_TRY(write_file(car, obj_text(*make_vehicle(VehicleKind::Car, 30'000))));
    return std::array<fs::path, 2>{truck, car};
}

Result<std::array<fs::path, 2>> find_debian_vehicles(const fs::path& cache, const fs::path& root) {
    if (!is_file(root / tram)) {
        return not_installed(root / tram);
    }
    CD_TRY(make_directories(cache));
    const fs::path motorcycle = CD_TRY(unpacked_motorcycle(cache, root));
    return std::array<fs::path, 2>{motorcycle, root / tram};
}

} // namespace cd
