// The poses of a bundle of lines: its directions, and the tiles that cover a body in each of them.
#pragma once

#include "client/bundle/line_bundle.hpp"
#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A direction from which lines come: (cos el cos az, cos el sin az, sin el) in the world, whose x
/// axis points forward, y to the left and z up. Azimuth 0 looks at the front, 90 at the left side;
/// elevation 90 looks from above.
struct ShotView {
    double azimuth_deg = 0;
    double elevation_deg = 0;

    friend bool operator==(const ShotView&, const ShotView&) = default;
};

/// Returns the rotation from a bundle's coordinates to the world: its x axis points to where lines
/// come from. Views along axes are exact.
[[nodiscard]] Quaternion view_rotation(const ShotView& view);

/// Returns half of the length of lines that span a box from every direction, if they pass through
/// it: a power of two, which keeps coordinates short.
[[nodiscard]] double bundle_reach(const Aabb& box);

/// A bundle's place in a view.
struct BundlePose {
    std::uint32_t view = 0;  ///< Index of the view.
    std::int32_t column = 0; ///< Tiles to the left of the one in the box's middle, seen along y.
    std::int32_t row = 0;    ///< Tiles above it, seen along z.
    Pose pose;               ///< From the bundle's coordinates to the world.
};

/// The bundles of a view along one axis.
struct TileCount {
    std::int32_t first = 0; ///< Number of the first one, as in `BundlePose`.
    std::uint64_t count = 0;
};

/// Returns the columns and the rows of poses that `bundle_poses` gives a view of a checked grid, if
/// it gives any.
[[nodiscard]] std::array<TileCount, 2>
tiles_in_view(const LineGrid& grid, const ShotView& view, const Aabb& box);

/// Returns the poses of `make_bundle` that together cover a box, by view, row and column. The
/// views' planes pass through the box's middle. Errors: BadInput for angles that are not finite,
/// and for more poses than `limits::bundle_poses_max`.
[[nodiscard]] Result<std::vector<BundlePose>>
bundle_poses(const LineGrid& grid, std::span<const ShotView> views, const Aabb& box);

} // namespace cd
