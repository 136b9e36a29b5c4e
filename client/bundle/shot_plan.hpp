// What a job asks with shot lines, and the bundles and poses that follow from it.
#pragma once

#include "client/bundle/bundle_poses.hpp"
#include "client/bundle/line_bundle.hpp"
#include "client/bundle/line_file.hpp"
#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// The table [shots] of a job: a grid of lines from some directions, or lines in a file.
struct ShotsSpec {
    LineGrid grid;
    /// Directions are all pairs of an elevation and an azimuth, in degrees. The azimuth varies
    /// faster.
    GridAxis azimuth_deg;
    GridAxis elevation_deg;
    std::filesystem::path file; ///< Lines instead of a grid; empty: a grid.
    LineForm form = LineForm::Ends;
    /// Of a scene: what lines of a grid cover, in the world; nothing: all bodies that lines may
    /// hit.
    std::optional<Aabb> box = {};
    std::string place = {}; ///< "FILE:LINE: [shots]: " for messages; empty without a job file.

    [[nodiscard]] bool is_grid() const { return file.empty(); }
    /// Returns the directions of a grid, in order.
    [[nodiscard]] std::vector<ShotView> views() const;
};

/// Returns whether the lines of two scenes have bundles of equal numbers at equal places.
[[nodiscard]] bool stand_alike(const ShotsSpec& one, const ShotsSpec& other);

/// Counts the directions of lines: "72 azimuths, 13 elevations"; names the file of others.
[[nodiscard]] std::string views_text(const ShotsSpec& spec);

/// Returns the mesh of lines that is a job's body B, for a body A in this box. Errors: BadInput
/// naming the place of [shots]; as `read_lines`.
[[nodiscard]] Result<Mesh> shot_mesh(const ShotsSpec& spec, const Aabb& box);

/// Returns where the bundle stands in each scenario. Lines of a file have one, in which the
/// bundle's coordinates are the world's. Errors: BadInput naming the place of [shots].
[[nodiscard]] Result<std::vector<BundlePose>> shot_poses(const ShotsSpec& spec, const Aabb& box);

/// Where a line is among those of its view: from the left and from below, as its start sees A.
struct LinePlace {
    std::uint64_t column = 0;
    std::uint64_t row = 0;
};

/// The directions of a job's lines, by bundle. Of two bodies a bundle is a scenario.
class ShotViews {
  public:
    /// One direction, in which the bundle's coordinates are the world's.
    ShotViews() = default;
    /// The directions of lines that cover this box, and whose poses are `shot_poses`.
    ShotViews(const ShotsSpec& spec, const Aabb& box);

    [[nodiscard]] std::size_t count() const { return views_.empty() ? 1 : views_.size(); }
    /// Returns the number of bundles of all directions.
    [[nodiscard]] std::uint64_t bundles() const { return bundles_; }
    /// Returns the number of a bundle's direction.
    [[nodiscard]] std::uint32_t view_of(std::uint64_t bundle) const;
    /// Returns the rotation from the bundle's coordinates to the world in a direction.
    [[nodiscard]] Mat3 rotation(std::uint32_t view) const;
    /// Returns a direction; there is none for lines of a file.
    [[nodiscard]] const ShotView& view(std::uint32_t view) const { return views_[view]; }
    /// Names a direction: "azimuth 30, elevation -15"; that of lines of a file "lines of a file".
    [[nodiscard]] std::string direction_text(std::uint32_t view) const;
    /// Names a bundle: "az=30 el=-15 tile=2,-1"; empty for lines of a file.
    [[nodiscard]] std::string id_of(std::uint64_t bundle) const;
    /// Returns the number of columns and of rows of lines in a direction; 0 for lines of a file.
    [[nodiscard]] LinePlace size(std::uint32_t view) const;
    /// Returns where a line of a bundle is, for lines of a grid.
    [[nodiscard]] LinePlace place_of(std::uint64_t bundle, std::uint32_t line) const;
    /// Returns the area of a line's cell in the plane across the lines; 0 for lines of a file.
    [[nodiscard]] double cell_area() const { return cell_area_; }

  private:
    std::vector<ShotView> views_;                 ///< Empty for lines of a file.
    std::vector<std::uint64_t> begins_;           ///< The first bundle of each direction.
    std::vector<std::array<TileCount, 2>> tiles_; ///< Columns and rows of bundles, likewise.
    std::uint64_t bundles_ = 1;
    std::uint64_t tile_ = 1; ///< Lines along a side of a bundle.
    double cell_area_ = 0;
};

/// Returns ids for the poses of a grid, as `ShotViews::id_of`; none for a file.
[[nodiscard]] PoseLabels shot_labels(const ShotsSpec& spec, const std::vector<BundlePose>& poses);

} // namespace cd
