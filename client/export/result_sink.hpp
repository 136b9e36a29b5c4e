// Where results go, one after another: files of each format, stdout, and sums over all of them.
#pragma once

#include "client/export/result_writer.hpp"
#include "client/report.hpp"
#include "common/core/result.hpp"
#include "common/job/contact_map.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// What a sink writes.
struct SinkOptions {
    std::filesystem::path dir; ///< For the files; empty: none.
    std::vector<std::string> formats;
    std::string output = "text"; ///< On stdout: json, csv, records-text; text leaves it alone.
};

class ResultSink {
  public:
    /// The meshes of the context's bodies have to be there. Errors: those of `ResultFiles::open`.
    [[nodiscard]] static Result<ResultSink> open(const SinkOptions& options,
                                                 const ExportContext& context);

    /// The next result, in the submitted order. `found` are all its pairs where the job is for
    /// maps; otherwise the map is the sum of the listed pairs. Errors: Io; Interrupted.
    [[nodiscard]] Status add(const ScenarioResult& result, std::span<const ContactPair> found = {});
    /// Completes the files, those of `map` included.
    [[nodiscard]] Status finish(const std::optional<ContactMap>& map);

    /// The sum over all results so far; empty below level pairs unless `found` was given.
    [[nodiscard]] ContactMap map();
    /// For `RunReport::most_touched`.
    [[nodiscard]] const PartTally& tally() const { return tally_; }
    [[nodiscard]] bool uses_stdout() const { return stdout_writer_ != nullptr; }

  private:
    ResultSink(PartTally tally, StopCheck stop)
        : tally_(std::move(tally)), stop_(std::move(stop)) {}

    std::optional<ResultFiles> files_;
    std::unique_ptr<ResultWriter> stdout_writer_;
    PartTally tally_;
    StopCheck stop_;
    ContactMapSum waiting_; ///< Not in `map_` yet.
    ContactMapTotal map_;
};

/// Prints the summary: on stdout, or on stderr where stdout carries results; there `quiet` leaves
/// only its warnings. Errors: those of `OutputFile`.
[[nodiscard]] Status
print_summary(const RunReport& report, bool stdout_is_used, bool quiet, bool statistics);

} // namespace cd
