// Draws bodies: one with its parts in colours, or several in contact.
#pragma once

#include "client/picture/image.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The size of a picture in pixels.
struct PictureSize {
    unsigned width = 1200;
    unsigned height = 750;
};

/// The colour of triangles in contact.
inline constexpr Colour contact_colour{224, 32, 32};

/// A body in a picture. The mesh must outlive the drawing.
struct PicturedBody {
    const Mesh* mesh = nullptr;
    Pose pose; ///< Pose in the world.
    Colour colour;
    std::vector<std::uint32_t> contacts; ///< Triangles in contact.
};

/// Draws a mesh from the front, the right and above; eight colours take turns for its parts.
[[nodiscard]] Image draw_parts(const Mesh& mesh, PictureSize size = {});

/// Draws bodies with their contacts, from the one of 26 directions (to the faces, edges and corners
/// of a cube) that shows most contacts; from the front right and above if none shows any.
[[nodiscard]] Image draw_contacts(std::span<const PicturedBody> bodies, PictureSize size = {});

} // namespace cd
