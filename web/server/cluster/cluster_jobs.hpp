// Answers the page's questions about one job of a cluster. All functions block.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/record_file.hpp"
#include "common/scene/step_index.hpp"
#include "web/server/cluster/cluster_reader.hpp"
#include "web/server/page_values.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// A job, found by its id among the jobs of a cluster.
struct PagedJob {
    JobStatus status;
    std::string id;
    std::uint64_t workers = 0; ///< Workers of the cluster.

    [[nodiscard]] std::uint64_t scenarios() const { return status.summary.total; }
};

/// `sums` has the sums by part, of which the groups are made.
[[nodiscard]] Result<JobView>
view_of(ClusterReader& reader, const PagedJob& job, const ContactMapAnswer& sums);
/// Errors of these: BadInput for scenarios that the job does not have; those of reading.
[[nodiscard]] Result<std::vector<std::uint8_t>>
classes_of(const RecordReader& records, const PagedJob& job, const ScenarioChoice& choice);
[[nodiscard]] Result<std::vector<std::uint32_t>>
counts_of(const RecordReader& records, const PagedJob& job, const ScenarioChoice& choice);
[[nodiscard]] Result<std::vector<double>>
distances_of(const RecordReader& records, const PagedJob& job, const ScenarioChoice& choice);
[[nodiscard]] Result<PoseRows>
poses_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice);
/// Errors: as `scene_motions`.
[[nodiscard]] Result<std::vector<MotionKeys>>
motions_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice);
/// Errors: NotFound if the job is no scene.
[[nodiscard]] Result<std::vector<ScenePlace>>
places_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice);
/// Errors: NotFound if the job is no scene.
[[nodiscard]] Result<std::vector<StepRow>>
steps_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice);
/// Errors: NotFound if the job has no map.
[[nodiscard]] Result<std::vector<TriangleContacts>> map_of(ClusterReader& reader,
                                                           const PagedJob& job,
                                                           const ContactMapAnswer& answer,
                                                           std::uint64_t body);
/// Errors: NotFound for a body that the job does not have.
[[nodiscard]] Result<std::shared_ptr<const NamedParts>>
parts_of(ClusterReader& reader, const PagedJob& job, std::uint64_t body);
/// Returns which of these parts are closed. Errors: as `parts_of`.
[[nodiscard]] Result<std::vector<bool>>
closed_parts_of(ClusterReader& reader, const PagedJob& job, std::uint64_t body);
/// Looks at most `limits::page_scenarios_max` scenarios far.
[[nodiscard]] Result<NextFound> next_of(ClusterReader& reader,
                                        const RecordReader& records,
                                        const PagedJob& job,
                                        const NextContact& wanted);

/// A scenario with all that running it again needs.
struct ScenarioInputs {
    Query query;
    BodyTrees trees;
    Scenario scenario;
    PoseLabels labels;                      ///< Of this scenario.
    std::shared_ptr<const StepIndex> steps; ///< Of a scene; else null.
    std::optional<KeptRecord> record;
};
/// Errors: NotFound if the job has no such scenario; those of reading.
[[nodiscard]] Result<ScenarioInputs> inputs_of(ClusterReader& reader,
                                               const RecordReader& records,
                                               const PagedJob& job,
                                               std::uint64_t scenario);

/// Runs the scenario again (`repeat_scenario`), and adds its labels and time.
[[nodiscard]] std::shared_ptr<const ScenarioView> run_again(const ScenarioInputs& inputs,
                                                            const StopCheck& stop);

/// Describes a body of a job.
[[nodiscard]] BodyView body_view(const JobBody& body, const ObbTree& tree);

/// Sets a view's id and time to label `place` of the labels, if they have it.
void add_label(const PoseLabels& labels, std::uint64_t place, ScenarioView& view);

} // namespace cd
