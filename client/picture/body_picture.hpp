// Pictures of bodies: one alone with its parts in colours, or several in contact.
#pragma once

#include "client/picture/image.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Pixels of a picture.
struct PictureSize {
    unsigned width = 1200;
    unsigned height = 750;
};

/// A body in a picture. The mesh outlives the call.
struct PicturedBody {
    const Mesh* mesh = nullptr;
    Pose pose; ///< In the world.
    Colour colour;
    std::vector<std::uint32_t> contacts; ///< Its triangles in contact, which are marked in red.
};

/// Draws a mesh from the front right and above, each part in the next of eight colours.
[[nodiscard]] Image draw_parts(const Mesh& mesh, PictureSize size = {});

/// Draws the bodies with their contacts, from that of 26 directions (faces, edges and corners of a
/// cube) in which most of the contacts is in sight; where none is, from the front right and above.
[[nodiscard]] Image draw_contacts(std::span<const PicturedBody> bodies, PictureSize size = {});

} // namespace cd
