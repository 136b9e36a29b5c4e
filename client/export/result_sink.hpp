// Distributes results to the files of each format, to stdout and to sums over all results.
#pragma once

#include "client/export/result_writer.hpp"
#include "client/export/scene_log.hpp"
#include "client/export/shots/shot_sums.hpp"
#include "client/groups/group_sum.hpp"
#include "client/groups/groups_csv.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Where a `ResultSink` writes, and in which formats.
struct SinkOptions {
    std::filesystem::path dir; ///< Folder of the files; empty: no files.
    std::vector<std::string> formats;
    std::string output = "text"; ///< Format for stdout: json, csv or records-text; text: none.
    /// Of a scene, the step whose pairs in contact become rules to paste.
    std::optional<std::uint64_t> learn = std::nullopt;
};

class ResultSink {
  public:
    /// Opens the outputs, and creates the folder if missing. The context's bodies must have meshes.
    /// Errors: Io; BadInput for an unknown format, or one that the job has no map for.
    [[nodiscard]] static Result<ResultSink> open(SinkOptions options, const ExportContext& context);

    /// Adds the next result in submitted order. For a job with maps, `found` has all pairs of the
    /// scenario; if it is empty, the map counts the pairs that the result lists. Errors: Io;
    /// Interrupted; BadInput for a body that the job does not have.
    [[nodiscard]] Status add(const ScenarioResult& result, std::span<const ContactPair> found = {});
    /// Completes all files, and writes those of groups and, if `map` is set, of the map: its own,
    /// and the bodies as vtp and glb. At `level count` the groups are those of the map. If `finish`
    /// is not called, no file is left in the folder. Errors: Io; BadInput for parts of the map that
    /// the bodies do not have.
    [[nodiscard]] Status finish(const std::optional<ContactMap>& map);

    /// Returns the contact map of all results added; nothing if the run has none (`MapUse`).
    [[nodiscard]] std::optional<ContactMap> map();
    /// Returns the groups of all results added; at `level count` after `finish`.
    [[nodiscard]] const GroupSum& groups() const { return groups_; }
    /// Returns what all results added tell; parts at `level count` after `finish`.
    [[nodiscard]] RunFindings findings() const;
    [[nodiscard]] bool uses_stdout() const { return options_.output != "text"; }

  private:
    /// The sum of a contact map.
    struct MapSum {
        ContactMapSum waiting; ///< Sum over the latest results, not yet in `total`.
        ContactMapTotal total;

        void add_waiting_if_large();
        [[nodiscard]] ContactMap map();
    };

    [[nodiscard]] std::vector<TouchedPart> most_touched() const;
    ResultSink(SinkOptions options, const ExportContext& context);

    [[nodiscard]] Status add_writers();
    [[nodiscard]] Status add_shot_writers();
    void add_to_maps(const ScenarioResult& result, std::span<const ContactPair> found);
    [[nodiscard]] bool has_format(std::string_view format) const;
    [[nodiscard]] Status write_map(const ContactMap& map);
    [[nodiscard]] GroupsOrigin groups_origin() const;

    SinkOptions options_;
    ExportContext context_;
    std::vector<std::unique_ptr<ResultWriter>> writers_;
    GroupSum groups_;
    std::uint64_t tested_ = 0; ///< Results added that are not failures.
    MapSum map_;
    MapSum contacts_; ///< Of pairs in contact alone, if `ExportContext::tells_contacts`.
    std::optional<LeastDistance> least_;
    std::optional<FirstEvent> first_event_;
    std::optional<SceneLog> scene_; ///< Nothing for a job of two bodies.
    std::optional<ShotSums> shots_; ///< For results that list hits of lines.
};

/// Prints the summary to stdout, or to stderr if stdout carries results; in the latter case,
/// `quiet` prints only the warnings. Errors: as `OutputFile`.
[[nodiscard]] Status
print_summary(const RunReport& report, bool stdout_is_used, bool quiet, bool statistics);

} // namespace cd
