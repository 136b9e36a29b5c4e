// A job's uploaded poses on disk.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "master/submission/spool_file.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// A spool file of packed scenarios. Keeps one run of scenarios in memory, besides the file's
/// index. Any thread may call any member; all block for the disk.
class PoseSpool final : public PoseSource {
  public:
    /// Creates a file in `directory`, which is made if missing, for `scenarios` scenarios.
    /// Errors: TooLarge over `limits::scenarios_max`; Io.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>>
    create(const std::filesystem::path& directory, std::uint64_t scenarios);
    /// Opens a sealed file. Errors: Io naming a file that is damaged or has another number of
    /// scenarios.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>> open(const std::filesystem::path& path,
                                                                 std::uint64_t scenarios);

    /// Appends the next scenarios, packed by `pack_scenarios`. An error leaves the file unchanged.
    /// Errors: those of `unpack_scenarios`; BadInput for a gap in the indices, unknown bodies, or
    /// more scenarios than `create` was called with; TooLarge for more than
    /// `limits::poses_part_scenarios_max` at once; Io.
    [[nodiscard]] Status append(std::span<const std::byte> packed);

    /// Finishes the file after the last scenarios and renames it to `path`, in the same folder.
    /// Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);
    /// Reads all runs and checks their checksums. Errors: Io, naming the file.
    [[nodiscard]] Status verify() const;

    /// Number of scenarios appended.
    [[nodiscard]] std::uint64_t count() const override;
    [[nodiscard]] bool is_complete() const;
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

  private:
    PoseSpool(SpoolFile file, bool is_sealed) : file_(std::move(file)), is_sealed_(is_sealed) {}
    [[nodiscard]] std::uint64_t count_locked() const;
    [[nodiscard]] Error too_many() const;
    [[nodiscard]] Result<std::vector<Scenario>> read_run(std::uint64_t run) const;

    mutable std::mutex mutex_;
    SpoolFile file_;
    std::vector<Scenario> last_; ///< Fewer than a run; not on disk yet.
    bool is_sealed_ = false;     ///< Only a sealed file may end with a short run.
};

} // namespace cd
