// A run that `cdctl view` shows, with all that the page asks of it.
#pragma once

#include "client/folder/opened_run.hpp"
#include "client/job/prepared_job.hpp"
#include "client/view/record_index.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "web/server/page_source.hpp"
#include "web/server/part_filter.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// Any thread may call any member. Calls block. Errors: BadInput for scenarios that the run does
/// not have; Io and those of the poses.
class ViewedRun {
  public:
    /// Reads all records. `job` is the run's, prepared with trees; both outlive the object. `map`
    /// is the contact map that the run keeps. Errors: as `RecordIndex::read` and `groups_of`.
    [[nodiscard]] static Result<std::unique_ptr<ViewedRun>> open(OpenedRun& run,
                                                                 const PreparedJob& job,
                                                                 std::optional<ContactMap> map,
                                                                 ThreadPool& pool,
                                                                 const StopCheck& stop = {});

    [[nodiscard]] const RunManifest& manifest() const { return run_.manifest(); }
    [[nodiscard]] std::filesystem::path folder() const;
    [[nodiscard]] std::uint64_t count() const { return job_.poses->count(); }
    /// Describes the run under the id `id`.
    [[nodiscard]] JobView view(const std::string& id) const;
    /// Describes the run in a list.
    [[nodiscard]] JobRow row(const std::string& id) const;
    [[nodiscard]] Result<std::vector<std::uint8_t>> classes(const ScenarioChoice& choice) const;
    [[nodiscard]] Result<std::vector<std::uint32_t>> counts(const ScenarioChoice& choice) const;
    /// Each scenario's distance; NaN without one.
    [[nodiscard]] Result<std::vector<double>> distances(const ScenarioChoice& choice) const;
    [[nodiscard]] Result<PoseRows> poses(const ScenarioChoice& choice);
    /// Returns each motion's poses at its begin and end. Errors: as `scene_motions`.
    [[nodiscard]] Result<std::vector<MotionKeys>> keys(const ScenarioChoice& choice);
    /// Returns the step and the bodies of each scenario. Errors: NotFound unless it is a scene.
    [[nodiscard]] Result<std::vector<ScenePlace>> places(const ScenarioChoice& choice);
    /// Returns the number of steps of a scene; 0 of another run.
    [[nodiscard]] std::uint64_t step_count() const {
        return job_.scene ? job_.scene->steps->steps() : 0;
    }
    /// Returns the chosen steps. Errors: NotFound unless the run is of a scene; as `step_rows`.
    [[nodiscard]] Result<std::vector<StepRow>> steps(const ScenarioChoice& choice) const;
    /// Returns a body's contact map. Errors: NotFound without a map or a body.
    [[nodiscard]] Result<std::vector<TriangleContacts>> map(std::uint64_t body) const;
    /// Returns the parts of a body as the groups name them. Errors: NotFound for another body.
    [[nodiscard]] Result<std::shared_ptr<const NamedParts>> parts(std::uint64_t body) const;
    /// Returns which of these parts are closed. Errors: as `parts`.
    [[nodiscard]] Result<std::vector<bool>> closed_parts(std::uint64_t body) const;
    /// Returns the worst scenarios in contact or near, or the nearest ones, as
    /// `RecordIndex::worst`.
    [[nodiscard]] std::vector<std::uint64_t> worst(std::size_t count) const {
        return index_.worst(count);
    }
    /// Runs a scenario again. `stop` ends it.
    [[nodiscard]] Result<std::shared_ptr<const ScenarioView>> scenario(std::uint64_t number,
                                                                       const StopCheck& stop);
    /// Finds the next scenario in contact or near, as asked for. Errors: BadInput if a body or
    /// parts are asked for that the run does not have, or parts if the run lists no pairs.
    [[nodiscard]] Result<NextFound> next(const NextContact& wanted);
    /// Returns the mesh of a body; null if no body has it.
    [[nodiscard]] std::shared_ptr<const Mesh> mesh(const Sha256& mesh) const;
    /// Returns the path of the file that holds the canonical bytes of a mesh if the folder keeps
    /// them.
    [[nodiscard]] std::filesystem::path mesh_path(const Sha256& mesh) const;

  private:
    ViewedRun(OpenedRun& run,
              const PreparedJob& job,
              RecordIndex index,
              std::optional<ContactMap> map)
        : run_(run), job_(job), index_(std::move(index)), map_(std::move(map)) {}

    [[nodiscard]] Status sum_groups(const StopCheck& stop);
    [[nodiscard]] Result<PartFilter> filter_of(const NextContact& wanted) const;
    [[nodiscard]] Result<std::vector<Scenario>> read_poses(std::uint64_t first,
                                                           std::uint64_t count);
    /// Calls `take` with the chosen scenarios in order, some at a time.
    [[nodiscard]] Status
    for_each_chosen(const ScenarioChoice& choice,
                    const std::function<Status(const std::vector<Scenario>&)>& take);
    [[nodiscard]] bool has_both_poses() const {
        return manifest().poses.of_both_bodies || job_.scene.has_value();
    }
    [[nodiscard]] Result<std::optional<KeptRecord>> find_record(std::uint64_t scenario);
    [[nodiscard]] double seconds() const;

    OpenedRun& run_;
    const PreparedJob& job_;
    RecordIndex index_;
    std::optional<ContactMap> map_;
    std::optional<GroupsView> groups_;                     ///< Nothing if they are unknown.
    std::vector<std::shared_ptr<const NamedParts>> parts_; ///< By body.
    std::mutex mutex_; ///< Held while poses or records are read.
};

/// Describes the folder of a run as the page's origin. Its job has the id `folder`.
[[nodiscard]] PageOrigin folder_origin(const ViewedRun& run);

} // namespace cd
