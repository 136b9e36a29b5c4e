// Distributes results to the files of each format, to stdout and to sums over all results.
#pragma once

#include "client/export/result_writer.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// The outputs of a `ResultSink`.
struct SinkOptions {
    std::filesystem::path dir; ///< Folder of the files; empty: no files.
    std::vector<std::string> formats;
    std::string output = "text"; ///< Format for stdout: json, csv or records-text; text: none.
};

class ResultSink {
  public:
    /// Creates the folder. The context's bodies must have meshes. Errors: Io; BadInput for an
    /// unknown format.
    [[nodiscard]] static Result<ResultSink> open(SinkOptions options, const ExportContext& context);

    /// Adds the next result in submitted order. `found` has all pairs of the scenario for a job
    /// with maps. If `found` is empty, the map counts the pairs that the result lists. Errors: Io;
    /// Interrupted; BadInput for a body that the job does not have.
    [[nodiscard]] Status add(const ScenarioResult& result, std::span<const ContactPair> found = {});
    /// Completes all files, and writes the files of `map` if it is set. Without
    /// this call no file is left in the folder.
    [[nodiscard]] Status finish(const std::optional<ContactMap>& map);

    /// The contact map of all results so far; empty below `level pairs` unless `found` was given.
    [[nodiscard]] ContactMap map();
    /// The counts for `RunReport::most_touched`.
    [[nodiscard]] const PartTally& tally() const { return tally_; }
    [[nodiscard]] bool uses_stdout() const { return options_.output != "text"; }

  private:
    ResultSink(SinkOptions options, const ExportContext& context);

    SinkOptions options_;
    ExportContext context_;
    std::vector<std::unique_ptr<ResultWriter>> writers_;
    PartTally tally_;
    ContactMapSum waiting_; ///< Partial sum, not yet added to `map_`.
    ContactMapTotal map_;
};

/// Prints the summary to stdout, or to stderr if stdout carries results; with `quiet` only its
/// warnings go to stderr. Errors: those of `OutputFile`.
[[nodiscard]] Status
print_summary(const RunReport& report, bool stdout_is_used, bool quiet, bool statistics);

} // namespace cd
