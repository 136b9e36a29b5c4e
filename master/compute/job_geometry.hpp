// Prepares a job before its scenarios are analysed: trees, cuts and poses.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/compute/analyser.hpp"
#include "master/compute/result_check.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/geometry/cut.hpp"
#include "master/geometry/geometry_store.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// The cut of each body of a job, and the inputs of its analysis and of its result checks.
struct JobGeometry {
    std::vector<std::shared_ptr<const Cut>> cuts;
    AnalysisInput analysis; ///< Without the poses.
    std::shared_ptr<const JobMaterial> material;
};

/// Loads the geometry of jobs, and protects stored meshes from removal.
class Geometry {
  public:
    Geometry() = default;
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;
    virtual ~Geometry() = default;

    /// Loads the bodies and cuts them at the depths that the job asks for, or at depths that suit
    /// the bodies. May take seconds, and blocks. Any thread. Errors: those of `GeometryStore`.
    [[nodiscard]] virtual StoreResult<JobGeometry> prepare(const Submit& submit) = 0;
    /// Returns an object that prevents the removal of these meshes while it exists.
    [[nodiscard]] virtual std::shared_ptr<const MeshHold> hold(std::vector<Sha256> meshes) = 0;
    /// Returns all stored meshes in the order of their hashes.
    [[nodiscard]] virtual std::vector<MeshStatus> meshes() const = 0;
};

/// Geometry from a `GeometryStore`, which outlives this object.
class StoredGeometry final : public Geometry {
  public:
    explicit StoredGeometry(GeometryStore& store) : store_(store) {}

    [[nodiscard]] StoreResult<JobGeometry> prepare(const Submit& submit) override;
    [[nodiscard]] std::shared_ptr<const MeshHold> hold(std::vector<Sha256> meshes) override {
        return store_.hold(std::move(meshes));
    }
    [[nodiscard]] std::vector<MeshStatus> meshes() const override { return store_.meshes(); }

  private:
    GeometryStore& store_;
};

/// Returns the dispatcher's description of the cuts of a job's bodies, which have these ids.
[[nodiscard]] DispatchTrees dispatch_trees(std::span<const TreeId> ids,
                                           std::span<const std::shared_ptr<const Cut>> cuts);

/// Whether `open_poses` verifies the whole pose file at once. With AsRead it verifies nothing: each
/// later read verifies the poses that it reads.
enum class PoseCheck : std::uint8_t { Whole, AsRead };

/// Opens the poses of a job in the journal; `path` is their file, unused if the job has a grid.
/// Errors: Io naming a file that is missing or damaged; those of a damaged grid.
[[nodiscard]] Result<std::shared_ptr<OrderedPoses>> open_poses(const Submit& submit,
                                                               const std::filesystem::path& path,
                                                               PoseCheck check = PoseCheck::Whole);

} // namespace cd
