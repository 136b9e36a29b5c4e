// Writes a generated vehicle as a mesh file.
//
//   make_vehicle truck 300000 FILE.stl        binary STL
//
// Without a file it prints only the number of triangles and the mesh's hash.
#include "bench/scenarios/vehicle.hpp"
#include "common/core/bytes.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <bit>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace cd::bench {

namespace {

void put_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<char>(value >> shift & 255u));
    }
}

/// Normals are left zero, as the format allows.
void write_stl(const Mesh& mesh, const std::string& path) {
    std::string bytes(80, ' ');
    put_u32(bytes, static_cast<std::uint32_t>(mesh.triangles().size()));
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        bytes.append(12, '\0');
        for (const Vec3& corner : mesh.corners(i)) {
            for (const double x : {corner.x(), corner.y(), corner.z()}) {
                put_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
            }
        }
        bytes.append(2, '\0');
    }
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        throw std::runtime_error("cannot write " + path);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    std::string kind;
    std::uint64_t triangles = 0;
    std::string path;
    CLI::App app("Writes a generated vehicle");
    app.add_option("KIND", kind, "car or truck")
        ->required()
        ->check(CLI::IsMember({"car", "truck"}));
    app.add_option("TRIANGLES", triangles, "About so many")
        ->required()
        ->check(CLI::Range(500, 20000000));
    app.add_option("FILE", path, "A binary STL file to write");
    CLI11_PARSE(app, argc, argv);
    using cd::bench::VehicleKind;
    const auto mesh =
        cd::bench::make_vehicle(kind == "car" ? VehicleKind::Car : VehicleKind::Truck, triangles);
    std::printf("%s: %zu triangles, hash %s\n",
                kind.c_str(),
                mesh->triangles().size(),
                cd::to_hex(mesh->hash()).c_str());
    try {
        if (!path.empty()) {
            cd::bench::write_stl(*mesh, path);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
