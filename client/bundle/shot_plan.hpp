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

#include <cstdint>
#include <filesystem>
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
    std::string place = {}; ///< "FILE:LINE: [shots]: " for messages; empty without a job file.

    [[nodiscard]] bool is_grid() const { return file.empty(); }
    /// Returns the directions of a grid, in order.
    [[nodiscard]] std::vector<ShotView> views() const;
};

/// Returns the mesh of lines that is a job's body B, for a body A in this box. Errors: BadInput
/// naming the place of [shots]; as `read_lines`.
[[nodiscard]] Result<Mesh> shot_mesh(const ShotsSpec& spec, const Aabb& box);

/// Returns where the bundle stands in each scenario. Lines of a file have one, in which the
/// bundle's coordinates are the world's. Errors: BadInput naming the place of [shots].
[[nodiscard]] Result<std::vector<BundlePose>> shot_poses(const ShotsSpec& spec, const Aabb& box);

/// Returns ids for the poses of a grid, such as "az=30 el=-15 tile=2,-1"; none for a file.
[[nodiscard]] PoseLabels shot_labels(const ShotsSpec& spec, const std::vector<BundlePose>& poses);

} // namespace cd
