// Writes binary glTF 2.0 (.glb): meshes whose triangles are sorted by materials.
#pragma once

#include "client/formats/number_array.hpp"
#include "client/picture/image.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/types.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cd {

struct GlbMaterial {
    std::string name;
    Colour colour;
};

/// Shapes of one kind and one material. The numbers are those of glTF's modes.
struct GlbPrimitive {
    enum class Mode : std::uint8_t { Dots = 0, Lines = 1, Triangles = 4 };
    Mode mode = Mode::Triangles;
    std::size_t material = 0;
    NumberArray indices; ///< Points of the mesh, as u4: one, two or three a shape.
};

/// Points and the shapes between them. A mesh without shapes is left out of the file.
struct GlbMesh {
    std::string name; ///< Bytes that are no UTF-8 become U+FFFD.
    std::span<const Vec3> points;
    std::vector<GlbPrimitive> primitives;
};

struct GlbScene {
    double metres = 1; ///< The length of a unit of the points; glTF is in metres.
    std::vector<GlbMaterial> materials;
    std::vector<GlbMesh> meshes;
};

/// Writes a scene, whole or not at all. The file holds floats: of the points as they are, or, if
/// the scene is so far from the origin that floats would lose more than six further bits, of the
/// points relative to its centre, to which a node then moves them. The axes are those of the
/// points, while viewers take y for up. Errors: BadInput for points beyond floats or a file beyond
/// 4 GiB; Io naming the file; Interrupted.
[[nodiscard]] Status
write_glb(const GlbScene& scene, const std::filesystem::path& path, const StopCheck& stop);

} // namespace cd
