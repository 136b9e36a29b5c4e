#include "client/bundle/bundle_poses.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/job/poses/pose_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cd {

namespace {

/// The box's shadow along the lines of a view, in the bundle's y and z relative to the middle.
struct Shadow {
    std::array<double, 2> low{};
    std::array<double, 2> high{};

    Shadow(const Mat3& rotation, const Vec3& half_size) {
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3 axis = rotation.col(static_cast<Eigen::Index>(k) + 1);
            high[k] = axis.cwiseAbs().dot(half_size);
            low[k] = -high[k];
        }
    }
};

/// Numbers of tiles; both ends count.
struct TileRange {
    double first = 0;
    double last = 0;

    /// Covers [low, high] and a cell on either side, which has room for roundings.
    TileRange(double low, double high, const LineGrid& grid)
        : first(std::floor((low - grid.spacing) / grid.width() + 0.5)),
          last(std::max(first, std::ceil((high + grid.spacing) / grid.width() - 0.5))) {}

    [[nodiscard]] double count() const { return last - first + 1; }
};

/// Returns the tiles that cover a box, along the bundle's y and z.
std::array<TileRange, 2>
tiles_of(const LineGrid& grid, const Quaternion& rotation, const Aabb& box) {
    const Shadow shadow(Pose::from_quaternion(rotation, Vec3::Zero()).rotation(), 0.5 * box.size());
    return {TileRange(shadow.low[0], shadow.high[0], grid),
            TileRange(shadow.low[1], shadow.high[1], grid)};
}

void add_view(const LineGrid& grid,
              std::uint32_t view,
              const Quaternion& rotation,
              const Vec3& middle,
              const std::array<TileRange, 2>& tiles,
              std::vector<BundlePose>& poses) {
    const Mat3 axes = Pose::from_quaternion(rotation, middle).rotation();
    for (double row = tiles[1].first; row <= tiles[1].last; ++row) {
        for (double column = tiles[0].first; column <= tiles[0].last; ++column) {
            const Vec3 at = middle + grid.width() * (column * axes.col(1) + row * axes.col(2));
            poses.push_back({view,
                             static_cast<std::int32_t>(column),
                             static_cast<std::int32_t>(row),
                             Pose::from_quaternion(rotation, at)});
        }
    }
}

} // namespace

Quaternion view_rotation(const ShotView& view) {
    return quaternion_from_euler(0, -view.elevation_deg, view.azimuth_deg);
}

double bundle_reach(const Aabb& box) {
    int exponent = 0;
    // The factor has room for roundings of the poses.
    std::frexp(0.5001 * box.diagonal(), &exponent);
    return std::ldexp(1.0, exponent);
}

std::array<TileCount, 2>
tiles_in_view(const LineGrid& grid, const ShotView& view, const Aabb& box) {
    std::array<TileCount, 2> counts;
    const std::array<TileRange, 2> tiles = tiles_of(grid, view_rotation(view), box);
    for (std::size_t k = 0; k < 2; ++k) {
        counts[k] = {static_cast<std::int32_t>(tiles[k].first),
                     static_cast<std::uint64_t>(tiles[k].count())};
    }
    return counts;
}

Result<std::vector<BundlePose>>
bundle_poses(const LineGrid& grid, std::span<const ShotView> views, const Aabb& box) {
    CD_TRY(check_grid(grid));
    std::vector<BundlePose> poses;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const ShotView& view = views[i];
        if (!std::isfinite(view.azimuth_deg) || !std::isfinite(view.elevation_deg)) {
            return bad_input("a direction of lines that is not finite");
        }
        const Quaternion rotation = view_rotation(view);
        const std::array<TileRange, 2> tiles = tiles_of(grid, rotation, box);
        const double count =
            static_cast<double>(poses.size()) + tiles[0].count() * tiles[1].count();
        if (!(count <= static_cast<double>(limits::bundle_poses_max))) {
            return bad_input(
                fmt::format("{:.3g} bundles of lines or more; at most {}. Take a larger "
                            "spacing, larger tiles or fewer directions",
                            count,
                            limits::bundle_poses_max));
        }
        add_view(grid, static_cast<std::uint32_t>(i), rotation, box.center(), tiles, poses);
    }
    return poses;
}

} // namespace cd
