// The geometry of a glTF 2.0 file as plain values:
// https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
#pragma once

#include "common/core/result.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

struct GltfBuffer {
    std::optional<std::string> uri; ///< Nothing: the buffer is the GLB's binary chunk.
    std::uint64_t bytes = 0;
};

struct GltfView {
    std::size_t buffer = 0;
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t stride = 0; ///< Bytes from one element to the next; 0: elements are packed.
};

enum class GltfNumber : std::uint16_t {
    I8 = 5120,
    U8 = 5121,
    I16 = 5122,
    U16 = 5123,
    U32 = 5125,
    F32 = 5126,
};

[[nodiscard]] std::size_t size_of(GltfNumber type);

/// A sequence of numbers within a buffer view.
struct GltfRun {
    std::size_t view = 0;
    std::uint64_t offset = 0;
    GltfNumber type = GltfNumber::F32;
};

/// A sparse accessor's elements, which replace elements of the dense accessor.
struct GltfSparse {
    std::uint64_t count = 0;
    GltfRun indices;
    GltfRun values;
};

struct GltfAccessor {
    std::optional<std::size_t> view; ///< Nothing: all elements that are not sparse are zero.
    std::uint64_t offset = 0;
    GltfNumber type = GltfNumber::F32;
    bool is_normalized = false; ///< Integers mean fractions in [0, 1] or [-1, 1] (section 3.11).
    std::uint64_t count = 0;
    std::size_t width = 1; ///< Numbers in an element.
    std::optional<GltfSparse> sparse;
};

/// The topology of a primitive (glTF 2.0, section 3.7.2.1), with its values in files.
enum class GltfMode : std::uint8_t {
    Points = 0,
    Lines = 1,
    LineLoop = 2,
    LineStrip = 3,
    Triangles = 4,
    TriangleStrip = 5,
    TriangleFan = 6,
};

struct GltfPrimitive {
    std::size_t positions = 0; ///< Index of the accessor of positions.
    std::optional<std::size_t> indices;
    GltfMode mode = GltfMode::Triangles;
};

struct GltfMesh {
    std::string name;
    std::vector<GltfPrimitive> primitives;
    bool is_morphed = false; ///< At least one morph target has a weight other than zero.
};

/// Translation, rotation (x, y, z, w) and scale, applied in the order scale, rotation, translation.
struct GltfTransform {
    std::array<double, 3> translation{0, 0, 0};
    std::array<double, 4> rotation{0, 0, 0, 1};
    std::array<double, 3> scale{1, 1, 1};
};

/// The accessors of EXT_mesh_gpu_instancing, each with one element per instance.
struct GltfInstances {
    std::optional<std::size_t> translation;
    std::optional<std::size_t> rotation;
    std::optional<std::size_t> scale;
};

struct GltfNode {
    std::string name;
    std::optional<std::size_t> mesh;
    std::optional<std::size_t> skin;
    std::optional<bool> is_morphed; ///< Set if the node's weights override the mesh's.
    std::vector<std::size_t> children;
    std::optional<std::array<double, 16>> matrix; ///< Column-major; replaces `transform`.
    GltfTransform transform;
    std::optional<GltfInstances> instances;
};

/// A document whose indices are all in range and whose nodes form trees.
struct GltfDocument {
    std::vector<GltfBuffer> buffers;
    std::vector<GltfView> views;
    std::vector<GltfAccessor> accessors;
    std::vector<GltfMesh> meshes;
    std::vector<GltfNode> nodes;
    std::vector<std::size_t> roots; ///< Root nodes of the scene that is read.
    std::size_t scenes = 0;         ///< Number of scenes in the file.
};

/// Reads the file's default scene, or its first if it names none.
///
/// Errors: BadInput naming the JSON object at fault, for damaged JSON, a version other than 2, an
/// unknown required extension (glTF 2.0, section 3.12) or one that compresses geometry, an index
/// out of range, a missing member or one of the wrong type or value, no scene, and a node that has
/// two parents or is nested deeper than `limits::mesh_file_depth_max`.
[[nodiscard]] Result<GltfDocument> parse_gltf(std::string_view json);

} // namespace cd
