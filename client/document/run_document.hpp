// The report of a run: one HTML file for screen and paper, without script unless it has a viewer.
#pragma once

#include "client/compare/group_statuses.hpp"
#include "client/document/distance_sections.hpp"
#include "client/document/embedded_viewer.hpp"
#include "client/document/group_sections.hpp"
#include "client/document/html.hpp"
#include "client/document/motion/motion_sections.hpp"
#include "client/document/report_pictures.hpp"
#include "client/document/run_names.hpp"
#include "client/document/run_overview.hpp"
#include "client/document/scene_sections.hpp"
#include "client/document/shots_sections.hpp"
#include "client/folder/run_manifest.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cd {

/// Writes the report of a run from what was read of it. All references must outlive the object.
class RunDocument {
  public:
    RunDocument(const RunManifest& manifest,
                const PreparedJob& job,
                RunOverview& overview,
                const GroupStatuses& statuses,
                const ReportPictures& pictures)
        : manifest_(manifest),
          job_(job),
          overview_(overview),
          statuses_(statuses),
          pictures_(pictures),
          names_(manifest, job) {}

    void set_baseline(BaselineNote note) { baseline_ = std::move(note); }
    /// Says why the run's groups are unknown.
    void set_no_groups(std::string reason) { no_groups_ = std::move(reason); }
    /// Puts a viewer into the report. It outlives the object.
    void set_viewer(const EmbeddedViewer& viewer) { viewer_ = &viewer; }
    /// Adds what a run tells of shot lines. It outlives the object.
    void set_shots(const ShotsSections& shots) { shots_ = &shots; }
    /// Adds what a run tells of the steps of a scene. It outlives the object.
    void set_scene(const SceneSections& scene) { scene_ = &scene; }
    /// Adds what a run tells of motions. It outlives the object.
    void set_motions(const MotionSections& motions) { motions_ = &motions; }
    /// Returns the report as an HTML document, below 5 MB without the viewer. Reads all poses.
    /// Errors: from reading poses; Interrupted.
    [[nodiscard]] Result<std::string> html(const StopCheck& stop);

  private:
    [[nodiscard]] Html verdict() const;
    /// Tells the digest, or why there is none.
    [[nodiscard]] Html digest() const;
    [[nodiscard]] Html distances() const;
    [[nodiscard]] Html bodies() const;
    [[nodiscard]] Html worst();
    /// Returns the table of the bundles of lines with most hits.
    [[nodiscard]] Html most_hits() const;
    [[nodiscard]] Result<Html> charts(const StopCheck& stop) const;
    [[nodiscard]] Html how_it_ran() const;

    [[nodiscard]] bool has_lines() const { return manifest_.query.question == Question::Shots; }
    [[nodiscard]] bool has_distance() const {
        return manifest_.query.question == Question::Distance;
    }
    [[nodiscard]] std::string part_pairs_of(const ScenarioResult& result);
    [[nodiscard]] Result<Html> coincidence(const StopCheck& stop) const;

    const RunManifest& manifest_;
    const PreparedJob& job_;
    RunOverview& overview_;
    const GroupStatuses& statuses_;
    const ReportPictures& pictures_;
    RunNames names_;
    BaselineNote baseline_;
    std::string no_groups_;
    const EmbeddedViewer* viewer_ = nullptr;
    const ShotsSections* shots_ = nullptr;
    const SceneSections* scene_ = nullptr;
    const MotionSections* motions_ = nullptr;
};

} // namespace cd
