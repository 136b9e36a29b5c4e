// Writes results to the disk during a run.
#pragma once

#include "client/local/done_block.hpp"
#include "client/local/done_scenario.hpp"
#include "common/core/result.hpp"
#include "common/core/timing/client.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/block_file.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/record_file.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace cd {

/// Writes the files `records` and, for a job with maps, `maps`. Each gets a block when the buffer
/// is full, and at least once a period. A block of `maps` holds the contact map of the scenarios
/// whose records are in the matching block of `records`.
class RunRecorder {
  public:
    /// Appends to the files in the folder, or creates them. `parts` are the parts of the bodies of
    /// a job with maps; null for other jobs. Errors: Io.
    [[nodiscard]] static Result<RunRecorder>
    open(const std::filesystem::path& folder,
         const std::shared_ptr<const BodyPartRuns>& parts,
         std::chrono::milliseconds period = timing::record_flush_period);

    /// Adds the next result. Errors: Io.
    [[nodiscard]] Status add(const DoneScenario& done);
    /// Adds the next results. Errors: Io.
    [[nodiscard]] Status add(const DoneBlock& done);
    /// Writes buffered results if the period has passed. Errors: Io.
    [[nodiscard]] Status flush_if_due();
    /// Writes buffered results. Errors: Io.
    [[nodiscard]] Status flush();
    /// Completes the files. Errors: Io.
    [[nodiscard]] Status finish();

    /// Returns the number of scenarios whose results are on the disk.
    [[nodiscard]] std::uint64_t kept() const { return records_.written(); }

  private:
    RunRecorder(RecordWriter records,
                std::optional<BlockFileWriter> maps,
                const std::shared_ptr<const BodyPartRuns>& parts,
                std::chrono::milliseconds period)
        : records_(std::move(records)), maps_(std::move(maps)), period_(period), map_(parts) {}

    RecordWriter records_;
    std::optional<BlockFileWriter> maps_;
    std::chrono::milliseconds period_;
    ContactMapSum map_; ///< The sum over buffered results.
    std::uint64_t first_waiting_ = 0;
    std::uint64_t waiting_ = 0;
    std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// Writes a complete contact map to a file of maps. Errors: Io.
[[nodiscard]] Status
write_maps(const std::filesystem::path& path, const ContactMap& map, std::uint64_t scenarios);

/// Sums all blocks of a finished or unfinished file of maps. Errors: Io naming the file.
[[nodiscard]] Result<ContactMap> read_maps(const std::filesystem::path& path);

} // namespace cd
