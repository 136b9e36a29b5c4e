// Writes poses to a file while a run reads them.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/poses/poses_hash.hpp"
#include "common/job/scenario_file.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

struct PoseRecorderOptions {
    bool hashes = false;         ///< Compute the hash of all poses.
    std::uint64_t bytes_max = 0; ///< Size limit of the file; a larger file is removed.
};

/// Passes on the scenarios of another source, and appends each one to a file when it is first read.
/// A read that leaves a gap after the last appended scenario appends nothing.
class PoseRecorder final : public PoseSource {
  public:
    /// Appends to `file`, or creates it. Errors: Io.
    [[nodiscard]] static Result<std::unique_ptr<PoseRecorder>>
    open(std::unique_ptr<PoseSource> source,
         const std::filesystem::path& file,
         PoseRecorderOptions options);

    [[nodiscard]] std::uint64_t count() const override { return source_->count(); }
    [[nodiscard]] const Grid* grid() const override { return source_->grid(); }
    /// Reads scenarios from the source. Errors: the source's; Io of the file.
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Reads the scenarios that have not been read yet, and completes the file. Returns the hash of
    /// all poses if `hashes` is set. Errors: as `read`; Interrupted.
    [[nodiscard]] Result<std::optional<Sha256>> finish(const StopCheck& stop = {});
    /// True while the file exists, which is removed when it becomes larger than `bytes_max`.
    [[nodiscard]] bool keeps() const { return writer_.has_value(); }

  private:
    PoseRecorder(std::unique_ptr<PoseSource> source,
                 std::filesystem::path file,
                 PoseRecorderOptions options)
        : source_(std::move(source)), file_(std::move(file)), bytes_max_(options.bytes_max) {
        if (options.hashes) {
            hash_.emplace();
        }
    }

    [[nodiscard]] Status open_file();
    [[nodiscard]] Status add(std::span<const Scenario> news);
    void drop_file();

    std::unique_ptr<PoseSource> source_;
    std::filesystem::path file_;
    std::uint64_t bytes_max_;
    std::mutex mutex_;
    std::optional<ScenarioWriter> writer_;
    std::optional<PosesHash> hash_;
    std::uint64_t next_ = 0; ///< The next scenario to write and hash.
};

} // namespace cd
