// A job's uploaded poses on disk.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace cd {

/// A file of packed scenarios in runs; an index at its end holds each run's checksum. The
/// destructor deletes an unsealed file. Memory: one run of scenarios, and 16 bytes per run on disk.
/// Any thread may call any member; all block for the disk.
class PoseSpool final : public PoseSource {
  public:
    /// Creates a file in `directory`, which is made if missing, for at most `scenarios` scenarios.
    /// Errors: TooLarge over `limits::scenarios_max`; Io.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>>
    create(const std::filesystem::path& directory, std::uint64_t scenarios);
    /// Opens a sealed file. Errors: Io naming a file that is damaged or has another number of
    /// scenarios.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>> open(const std::filesystem::path& path,
                                                                 std::uint64_t scenarios);
    ~PoseSpool() override;

    /// Appends the next scenarios, as received and packed by `pack_scenarios`. An error leaves the
    /// file unchanged. Errors: those of `unpack_scenarios`; BadInput for a gap in the indices,
    /// unknown bodies, or more scenarios than announced; TooLarge over
    /// `limits::poses_part_scenarios_max` at once; Io.
    [[nodiscard]] Status append(std::span<const std::byte> packed);

    /// Finishes the file after the last scenarios and renames it to `path`, in the same folder.
    /// Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);
    /// Reads all runs against their checksums. Errors: Io, naming the file.
    [[nodiscard]] Status verify() const;

    /// Number of scenarios appended.
    [[nodiscard]] std::uint64_t count() const override;
    [[nodiscard]] bool is_complete() const;
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

  private:
    struct State;
    explicit PoseSpool(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
