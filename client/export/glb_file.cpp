#include "client/export/glb_file.hpp"

#include "common/core/errors.hpp"
#include "common/core/version.hpp"
#include "common/geometry/aabb.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cd {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of glTF 2.0 (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html), sections 3.6 and
// 4.4.
constexpr int type_u4 = 5125;
constexpr int type_f4 = 5126;
constexpr int target_points = 34962;
constexpr int target_indices = 34963;
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t chunk_json = 0x4E4F534A;
constexpr std::uint32_t chunk_binary = 0x004E4942;
constexpr std::uint64_t headers_bytes = 28; ///< The file's header, and those of two chunks.

/// Converts a component of a colour from sRGB to the linear scale of glTF's factors.
double linear(std::uint8_t component) {
    const double value = component / 255.0;
    const double result = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    return std::round(result * 1e4) / 1e4;
}

Json material_json(const GlbMaterial& material) {
    const Colour& colour = material.colour;
    const Json factor{linear(colour.red), linear(colour.green), linear(colour.blue), 1.0};
    return {{"name", material.name},
            {"doubleSided", true},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", factor}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}};
}

Aabb box_of(const GlbScene& scene) {
    Aabb box;
    for (const GlbMesh& mesh : scene.meshes) {
        const Aabb own = bounding_box(mesh.points);
        if (!own.is_empty()) {
            box.add(own.min);
            box.add(own.max);
        }
    }
    return box;
}

/// Returns the point, in floats, to which the file's coordinates are relative.
Vec3 origin_of(const Aabb& box) {
    constexpr double far = 64;
    const double reach = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    const Vec3 center = box.center().cast<float>().cast<double>();
    return reach > far * box.diagonal() ? center : Vec3(Vec3::Zero());
}

/// The JSON document, and the arrays in the order in which the binary chunk has them.
class GlbLayout {
  public:
    explicit GlbLayout(const GlbScene& scene)
        : origin_(box_of(scene).is_empty() ? Vec3(Vec3::Zero()) : origin_of(box_of(scene))) {
        for (const GlbMesh& mesh : scene.meshes) {
            add_mesh(mesh, scene.metres);
        }
        for (const GlbMaterial& material : scene.materials) {
            materials_.push_back(material_json(material));
        }
    }

    /// Returns false if a coordinate is not finite as a float.
    [[nodiscard]] bool fits_floats() const { return fits_floats_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] const std::vector<NumberArray>& arrays() const { return arrays_; }

    [[nodiscard]] std::string json() const {
        Json nodes = Json::array();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            nodes.push_back(i);
        }
        Json json{{"asset", {{"version", "2.0"}, {"generator", "cdctl " + std::string(version)}}},
                  {"scene", 0},
                  {"scenes", {{{"nodes", std::move(nodes)}}}},
                  {"nodes", nodes_},
                  {"meshes", meshes_},
                  {"materials", materials_},
                  {"accessors", accessors_},
                  {"bufferViews", views_},
                  {"buffers", {{{"byteLength", bytes_}}}}};
        std::string text = json_text(json, -1);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return text;
    }

  private:
    /// Adds an array of the binary chunk. Returns the number of its accessor.
    std::size_t add_array(NumberArray array, int target, Json accessor) {
        views_.push_back({{"buffer", 0},
                          {"byteOffset", bytes_},
                          {"byteLength", array.bytes()},
                          {"target", target}});
        accessor["bufferView"] = views_.size() - 1;
        accessors_.push_back(std::move(accessor));
        bytes_ += array.bytes();
        arrays_.push_back(std::move(array));
        return accessors_.size() - 1;
    }

    std::size_t add_points(std::span<const Vec3> points) {
        const auto at = [points, origin = origin_](std::uint64_t i) {
            const auto axis = static_cast<Eigen::Index>(i % 3);
            return static_cast<float>(points[i / 3][axis] - origin[axis]);
        };
        constexpr float infinite = std::numeric_limits<float>::infinity();
        std::array<float, 3> least{infinite, infinite, infinite};
        std::array<float, 3> most{-infinite, -infinite, -infinite};
        for (std::uint64_t i = 0; i < 3 * points.size(); ++i) {
            const float number = at(i);
            fits_floats_ = fits_floats_ && std::isfinite(number);
            least[i % 3] = std::min(least[i % 3], number);
            most[i % 3] = std::max(most[i % 3], number);
        }
        return add_array(make_numbers<float>(3 * points.size(), at),
                         target_points,
                         {{"componentType", type_f4},
                          {"count", points.size()},
                          {"type", "VEC3"},
                          {"min", least},
                          {"max", most}});
    }

    void add_mesh(const GlbMesh& mesh, double metres) {
        Json primitives = Json::array();
        std::optional<std::size_t> points;
        for (const GlbPrimitive& primitive : mesh.primitives) {
            if (primitive.indices.count == 0) {
                continue;
            }
            points = points ? points : add_points(mesh.points);
            const std::size_t indices = add_array(primitive.indices,
                                                  target_indices,
                                                  {{"componentType", type_u4},
                                                   {"count", primitive.indices.count},
                                                   {"type", "SCALAR"}});
            primitives.push_back({{"attributes", {{"POSITION", *points}}},
                                  {"indices", indices},
                                  {"material", primitive.material},
                                  {"mode", static_cast<int>(primitive.mode)}});
        }
        if (!points) {
            return;
        }
        meshes_.push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
        Json node{{"name", mesh.name}, {"mesh", meshes_.size() - 1}};
        if (origin_ != Vec3::Zero()) {
            const Vec3 moved = metres * origin_;
            node["translation"] = {moved.x(), moved.y(), moved.z()};
        }
        if (metres != 1) {
            node["scale"] = {metres, metres, metres};
        }
        nodes_.push_back(std::move(node));
    }

    Vec3 origin_;
    bool fits_floats_ = true;
    std::uint64_t bytes_ = 0; ///< Size of the binary chunk; all arrays have whole words.
    std::vector<NumberArray> arrays_;
    Json nodes_ = Json::array();
    Json meshes_ = Json::array();
    Json materials_ = Json::array();
    Json accessors_ = Json::array();
    Json views_ = Json::array();
};

/// Returns the bytes of words, little-endian.
std::string words(std::initializer_list<std::uint64_t> values) {
    std::string bytes;
    for (const std::uint64_t value : values) {
        const auto word = static_cast<std::uint32_t>(value);
        bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    }
    return bytes;
}

} // namespace

Status write_glb(const GlbScene& scene, const std::filesystem::path& path, const StopCheck& stop) {
    const GlbLayout layout(scene);
    if (!layout.fits_floats()) {
        return bad_input(path,
                         "a glb file has floats, which do not reach the mesh's coordinates; "
                         "choose the format vtp");
    }
    const std::string json = layout.json();
    const std::uint64_t bytes = headers_bytes + json.size() + layout.bytes();
    if (bytes > std::numeric_limits<std::uint32_t>::max()) {
        return bad_input(path,
                         "a glb file has at most 4 GiB, and this one needs " +
                             std::to_string(bytes) + " bytes; choose the format vtp");
    }
    auto file = CD_TRY(OutputFile::create(path));
    CD_TRY(file.write(words({magic, 2, bytes, json.size(), chunk_json})));
    CD_TRY(file.write(json));
    CD_TRY(file.write(words({layout.bytes(), chunk_binary})));
    for (const NumberArray& array : layout.arrays()) {
        CD_TRY(write_numbers(array, file, stop));
    }
    return file.commit();
}

} // namespace cd
