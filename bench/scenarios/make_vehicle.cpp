// Writes a generated vehicle as a mesh file.
//
//   make_vehicle truck 300000 FILE.stl        binary STL; .obj, which has the parts, too; .glb
//
// Without a file it prints only the number of triangles and the mesh's hash.
#include "client/demo/obj_file.hpp"
#include "client/demo/vehicle.hpp"
#include "common/core/files/bytes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cd::bench {

namespace {

void put_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<char>(value >> shift & 255u));
    }
}

void put_floats(std::string& bytes, const Vec3& point) {
    for (const double x : {point.x(), point.y(), point.z()}) {
        put_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    }
}

/// Returns binary STL. Normals are zero, as the format allows.
std::string stl_bytes(const Mesh& mesh) {
    std::string bytes(80, ' ');
    put_u32(bytes, static_cast<std::uint32_t>(mesh.triangles().size()));
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        bytes.append(12, '\0');
        for (const Vec3& corner : mesh.corners(i)) {
            put_floats(bytes, corner);
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

/// Returns a GLB chunk, padded to a multiple of four bytes (glTF 2.0, section 4.4).
std::string glb_chunk(std::string_view type, std::string data, char filler) {
    data.append((4 - data.size() % 4) % 4, filler);
    std::string chunk;
    put_u32(chunk, static_cast<std::uint32_t>(data.size()));
    return chunk + std::string(type) + data;
}

/// Returns binary glTF with one node, whose mesh is one primitive.
std::string glb_bytes(const Mesh& mesh) {
    std::string data;
    for (const Vec3& vertex : mesh.vertices()) {
        put_floats(data, vertex);
    }
    const std::size_t indices_begin = data.size();
    for (const Triangle& triangle : mesh.triangles()) {
        for (const std::uint32_t index : triangle) {
            put_u32(data, index);
        }
    }
    const std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],)"
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
        R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},)"
        R"({{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],)"
        R"("bufferViews":[{{"buffer":0,"byteLength":{}}},)"
        R"({{"buffer":0,"byteOffset":{},"byteLength":{}}}],"buffers":[{{"byteLength":{}}}]}})",
        mesh.vertices().size(),
        3 * mesh.triangles().size(),
        indices_begin,
        indices_begin,
        data.size() - indices_begin,
        data.size());
    const std::string chunks =
        glb_chunk("JSON", json, ' ') + glb_chunk(std::string_view("BIN\0", 4), data, '\0');
    std::string file = "glTF";
    put_u32(file, 2);
    put_u32(file, static_cast<std::uint32_t>(12 + chunks.size()));
    return file + chunks;
}

std::string file_bytes(const Mesh& mesh, const std::filesystem::path& path) {
    if (path.extension() == ".obj") {
        return obj_text(mesh);
    }
    return path.extension() == ".glb" ? glb_bytes(mesh) : stl_bytes(mesh);
}

void write_mesh(const Mesh& mesh, const std::filesystem::path& path) {
    if (path.has_parent_path()) {
        std::filesystem::create_directories(path.parent_path());
    }
    const std::string bytes = file_bytes(mesh, path);
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        throw std::runtime_error("cannot write " + path.string());
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
    app.add_option("FILE", path, "A file to write: .stl (binary), .obj or .glb");
    CLI11_PARSE(app, argc, argv);
    using cd::VehicleKind;
    const auto mesh =
        cd::make_vehicle(kind == "car" ? VehicleKind::Car : VehicleKind::Truck, triangles);
    std::printf("%s: %zu triangles, hash %s\n",
                kind.c_str(),
                mesh->triangles().size(),
                cd::to_hex(mesh->hash()).c_str());
    try {
        if (!path.empty()) {
            cd::bench::write_mesh(*mesh, path);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
