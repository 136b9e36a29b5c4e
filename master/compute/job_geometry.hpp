// Prepares a job before its scenarios are analysed: trees, cuts and poses.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "master/compute/analyser.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/geometry/cut_geometry.hpp"
#include "master/geometry/geometry_store.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

struct JobGeometry {
    std::shared_ptr<const ObbTree> tree_a;
    std::shared_ptr<const ObbTree> tree_b;
    std::shared_ptr<const CutGeometry> cut_a;
    std::shared_ptr<const CutGeometry> cut_b;
};

/// Loads the bodies' trees and cuts them at the depths that the job asks for, or at good ones. May
/// take seconds. Errors: those of the store.
[[nodiscard]] StoreResult<JobGeometry> make_job_geometry(GeometryStore& store,
                                                         const Submit& submit);

/// Returns the dispatcher's description of a cut.
[[nodiscard]] DispatchTree dispatch_tree(TreeId id, const CutGeometry& cut);

[[nodiscard]] AnalysisInput make_analysis_input(const JobGeometry& geometry,
                                                const Query& query,
                                                std::shared_ptr<PoseSource> poses);

/// Whether `open_poses` verifies the whole pose file at once. With AsRead it verifies nothing: each
/// later read verifies the poses that it reads.
enum class PoseCheck : std::uint8_t { Whole, AsRead };

/// Opens the poses of a job in the journal; `path` is their file, unused if the job has a grid.
/// Errors: Io naming a file that is missing or damaged; those of a damaged grid.
[[nodiscard]] Result<std::shared_ptr<PoseSource>> open_poses(const Submit& submit,
                                                             const std::filesystem::path& path,
                                                             PoseCheck check = PoseCheck::Whole);

} // namespace cd
