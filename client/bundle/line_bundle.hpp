// A bundle of parallel lines as a mesh, whose triangles are segments.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

/// A square grid of lines.
struct LineGrid {
    double spacing = 1;      ///< Side of a cell, in the job's unit. Each cell has one line.
    std::uint32_t tile = 64; ///< Lines along a side of one bundle.
    /// Where lines pass through their cells, as a share of a cell's side; 0.5 is the middle.
    std::array<double, 2> offset{0.5, 0.5};
    /// If set, moves each line to a random place of its cell, in steps of 2^-16 of the cell's side.
    /// The offset does not count then.
    std::optional<std::uint64_t> jitter_seed = std::nullopt;

    /// Returns the side of a bundle.
    [[nodiscard]] double width() const { return tile * spacing; }
};

/// Checks the numbers. Errors: BadInput naming the number that is out of range.
[[nodiscard]] Status check_grid(const LineGrid& grid);

/// A line through a body: from p to q, in the bundle's coordinates.
struct LineEnds {
    Vec3 p;
    Vec3 q;
};

/// The name of the body of lines in a job, and of its only part.
inline constexpr std::string_view lines_name = "lines";

/// Makes a mesh of segments: the triangle (p, q, q) of each line, in order. Errors: BadInput for
/// ends that are not finite, and without lines.
[[nodiscard]] Result<Mesh> line_mesh(const std::vector<LineEnds>& lines);

/// Makes one bundle of a checked grid. Its lines run against the x axis, from x = `reach` to
/// -`reach`. Line number i + tile * j goes through cell i along y and cell j along z of a square
/// whose centre is the origin. Dyadic numbers keep the coordinates short. Errors: as `line_mesh`.
[[nodiscard]] Result<Mesh> make_bundle(const LineGrid& grid, double reach);

} // namespace cd
