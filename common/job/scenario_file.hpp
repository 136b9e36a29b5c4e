// Stores a run's poses on disk, so that the run can be reopened without the original files.
#pragma once

#include "common/core/result.hpp"
#include "common/job/block_file.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>

namespace cd {

/// Writes scenarios in submitted order to a block file (block_file.hpp). Each block is packed by
/// `pack_scenarios`.
class ScenarioWriter {
  public:
    /// Creates a file. Errors: those of `BlockFileWriter::create`.
    [[nodiscard]] static Result<ScenarioWriter> create(const std::filesystem::path& path);
    /// Opens a file to append to it. Errors: those of `BlockFileWriter::resume`.
    [[nodiscard]] static Result<ScenarioWriter> resume(const std::filesystem::path& path);

    /// Appends scenarios, whose indices continue those already written. Errors: Io.
    [[nodiscard]] Status add(std::span<const Scenario> scenarios);
    /// Writes the table and flushes the file. Errors: Io.
    [[nodiscard]] Status finish();

    /// Number of scenarios written so far.
    [[nodiscard]] std::uint64_t written() const { return file_.written().count(); }
    /// Size of the file so far, in bytes.
    [[nodiscard]] std::uint64_t bytes() const { return file_.written().end(); }

  private:
    explicit ScenarioWriter(BlockFileWriter file) : file_(std::move(file)) {}

    BlockFileWriter file_;
};

/// Opens the scenarios of a finished file. Any thread may read. Errors: those of `BlockFile::open`;
/// Io if scenarios are missing.
[[nodiscard]] Result<std::unique_ptr<PoseSource>>
open_scenario_file(const std::filesystem::path& path);

/// Opens the scenarios in the complete blocks of a file that is being written. Errors: those of
/// `BlockFile::open_unfinished`; Io if scenarios are missing.
[[nodiscard]] Result<std::unique_ptr<PoseSource>>
open_unfinished_scenario_file(const std::filesystem::path& path);

} // namespace cd
