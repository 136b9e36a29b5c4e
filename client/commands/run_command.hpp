// How a finished run is told, whoever ran it.
#pragma once

#include "client/cli.hpp"
#include "client/export/result_writer.hpp"
#include "client/prepared_job.hpp"
#include "client/report.hpp"

#include <memory>
#include <optional>
#include <string>

namespace cd {

/// Where a run's results go: a folder, stdout, both or neither.
class ResultSink {
  public:
    /// `output` is text, json or csv; text leaves stdout to the summary. Errors: those of
    /// `ResultFiles::open`.
    [[nodiscard]] static Result<ResultSink>
    open(const OutputSpec& spec, const std::string& output, const ExportContext& context);

    [[nodiscard]] Status add(const ScenarioResult& result);
    /// Completes the files and prints the summary: on stdout, or on stderr where stdout carries
    /// results. `quiet` leaves it out there.
    [[nodiscard]] Status finish(const RunReport& report, bool quiet);

    /// For `RunReport::most_touched`.
    [[nodiscard]] const PartTally& tally() const { return tally_; }

  private:
    explicit ResultSink(PartTally tally) : tally_(std::move(tally)) {}

    std::optional<ResultFiles> files_;
    std::unique_ptr<ResultWriter> stdout_writer_;
    PartTally tally_;
};

/// The verb `run` without its handling of signals; whoever calls it has an `InterruptGuard`.
[[nodiscard]] int run_job(const RunCommand& command);

/// Header and warnings on stderr; warnings also when quiet.
void print_header(const PreparedJob& job, bool quiet);

/// For `RunReport::hint`. Reads the poses again where all scenarios are separate.
[[nodiscard]] std::string hint_of(const PreparedJob& job, const Summary& summary);

} // namespace cd
