#include "client/bundle/line_bundle.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/split_mix.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace cd {

namespace {

/// Where a line passes through its cell, as shares of the cell's side.
class PlaceInCell {
  public:
    explicit PlaceInCell(const LineGrid& grid) : offset_(grid.offset), state_(grid.jitter_seed) {}

    /// Returns the place in the next cell.
    [[nodiscard]] std::array<double, 2> next() {
        if (!state_) {
            return offset_;
        }
        const std::uint64_t bits = split_mix(*state_);
        return {static_cast<double>(bits >> 48) * 0x1p-16,
                static_cast<double>(bits >> 32 & 0xffff) * 0x1p-16};
    }

  private:
    std::array<double, 2> offset_;
    std::optional<std::uint64_t> state_; ///< Of the generator; empty without jitter.
};

} // namespace

Status check_grid(const LineGrid& grid) {
    if (!(std::isfinite(grid.width()) && grid.spacing > 0)) {
        return bad_input(fmt::format("the spacing {} is not a positive number", grid.spacing));
    }
    if (grid.tile == 0 || grid.tile > limits::bundle_side_max) {
        return bad_input(fmt::format(
            "a tile of {} lines; expected 1 to {}", grid.tile, limits::bundle_side_max));
    }
    for (const double offset : grid.offset) {
        if (!(offset >= 0 && offset <= 1)) {
            return bad_input(fmt::format("the offset {} is not between 0 and 1", offset));
        }
    }
    return Done{};
}

Result<Mesh> line_mesh(const std::vector<LineEnds>& lines) {
    MeshArrays arrays;
    arrays.vertices.reserve(2 * lines.size());
    arrays.triangles.reserve(lines.size());
    for (const LineEnds& line : lines) {
        const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
        arrays.vertices.push_back(line.p);
        arrays.vertices.push_back(line.q);
        arrays.triangles.push_back({first, first + 1, first + 1});
    }
    arrays.precision = precision_of(arrays.vertices);
    arrays.parts = {{std::string(lines_name), 0, static_cast<std::uint32_t>(lines.size())}};
    return Mesh::create(std::move(arrays));
}

Result<Mesh> make_bundle(const LineGrid& grid, double reach) {
    const double half = 0.5 * grid.tile;
    PlaceInCell places(grid);
    std::vector<LineEnds> lines;
    lines.reserve(std::size_t{grid.tile} * grid.tile);
    for (std::uint32_t j = 0; j < grid.tile; ++j) {
        for (std::uint32_t i = 0; i < grid.tile; ++i) {
            const std::array<double, 2> place = places.next();
            const double y = (i + place[0] - half) * grid.spacing;
            const double z = (j + place[1] - half) * grid.spacing;
            lines.push_back({Vec3(reach, y, z), Vec3(-reach, y, z)});
        }
    }
    return line_mesh(lines);
}

} // namespace cd
