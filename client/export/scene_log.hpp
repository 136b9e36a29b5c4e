// What the results of a scene tell about its steps: episodes, coverage, and rules to paste.
#pragma once

#include "client/export/result_writer.hpp"
#include "client/formats/csv_rows.hpp"
#include "client/report/report.hpp"
#include "client/scene/body_episodes.hpp"
#include "client/scene/learned_rules.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// Sums the results of a scene. With a folder it writes, as docs/exports.md describes them,
/// episodes.csv in the order of the episodes' last steps, and coverage.csv with a row for each
/// step.
class SceneLog {
  public:
    /// The context has steps. Without `dir`, nothing is written. With `learn`, the pairs in contact
    /// at that step become rules to paste. Errors: Io naming the file.
    [[nodiscard]] static Result<SceneLog> open(const ExportContext& context,
                                               const std::optional<std::filesystem::path>& dir,
                                               std::optional<std::uint64_t> learn);

    /// Adds the next result in submitted order. Errors: Io naming the file.
    [[nodiscard]] Status add(const ScenarioResult& result);
    /// Ends all episodes, and completes the files. Errors: Io naming the file.
    [[nodiscard]] Status finish();
    /// Returns what all results added tell; after `finish` also the last episodes.
    [[nodiscard]] SceneFindings findings() const;

  private:
    explicit SceneLog(const ExportContext& context);

    [[nodiscard]] Status add_episodes(const std::vector<BodyEpisode>& episodes);
    [[nodiscard]] Status add_steps_before(std::uint64_t step);

    std::vector<std::string> names_; ///< Of each body.
    std::shared_ptr<const StepIndex> steps_;
    EpisodeSum sum_;
    std::optional<RowFile> episodes_file_;
    std::optional<RowFile> coverage_file_;
    std::optional<LearnedRules> learned_;
    std::uint64_t episodes_ = 0;
    std::optional<BodyEpisode> worst_;
    std::uint64_t step_ = 0;   ///< The first step that is not in coverage.csv yet.
    std::uint64_t failed_ = 0; ///< Failed scenarios of that step.
};

} // namespace cd
