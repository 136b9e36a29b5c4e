// Draws bodies: one with its parts in colours, or several in contact.
#pragma once

#include "client/picture/image.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/result/result.hpp"
#include "common/search/contact_pair.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

struct Viewpoint;

/// The size of a picture in pixels.
struct PictureSize {
    unsigned width = 1200;
    unsigned height = 750;
};

/// The colours of bodies A and B in pictures and scenes.
inline constexpr std::array<Colour, 2> body_colours{{{150, 170, 200}, {225, 190, 120}}};

/// The colours of triangles in contact, and of triangles that are only near.
inline constexpr Colour contact_colour{224, 32, 32};
inline constexpr Colour near_colour{240, 140, 40};
/// The colour of lines between the nearest points of near triangles.
inline constexpr Colour gap_colour{110, 45, 0};

/// A body in a picture. The mesh must outlive the drawing.
struct PicturedBody {
    const Mesh* mesh = nullptr;
    Pose pose; ///< Pose in the world.
    Colour colour;
    std::vector<std::uint32_t> contacts; ///< Triangles in contact.
    std::vector<std::uint32_t> near{};   ///< Triangles that are only near.
};

/// A line from the nearest point of A to that of B, in the world.
using GapLine = std::array<Vec3, 2>;

/// Returns two bodies in their poses, with the triangles of the pairs marked.
[[nodiscard]] std::vector<PicturedBody>
pictured(const Mesh& a, const Mesh& b, const PosePair& poses, std::span<const ContactPair> pairs);

/// Draws a mesh from the front, the right and above; eight colours take turns for its parts.
[[nodiscard]] Image draw_parts(const Mesh& mesh, PictureSize size = {});

/// Returns the lines of a result's near pairs; none below `level contacts`.
[[nodiscard]] std::vector<GapLine> gap_lines(const ScenarioResult& result);

/// Returns from where `draw_contacts` looks: from the one of 26 directions (to the faces, edges and
/// corners of a cube) that shows most of the contacts and near triangles; from the front right and
/// above if none shows any.
///
/// Bodies that are only near are seen at an angle of at least 45 degrees to their shortest line, so
/// that the picture shows the gap. A direction's marks count the more, the larger the angle is.
[[nodiscard]] Viewpoint viewpoint_of(std::span<const PicturedBody> bodies,
                                     std::span<const GapLine> lines);

/// Draws bodies with their contacts and near triangles as seen from `viewpoint_of`, and the lines.
[[nodiscard]] Image draw_contacts(std::span<const PicturedBody> bodies,
                                  PictureSize size = {},
                                  std::span<const GapLine> lines = {});

} // namespace cd
