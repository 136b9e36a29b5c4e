// The poses of a job as a client sends them, on disk.
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

/// A file of packed scenarios, each run behind a checksum in the index at its end. Until it is
/// sealed it goes when this does. Memory: one run of scenarios, and 16 bytes for each run that is
/// on disk. Any thread may call any member; all block for the disk.
class PoseSpool final : public PoseSource {
  public:
    /// A new file in `directory`, which is made if missing. More than `scenarios` are refused.
    /// Errors: TooLarge over `limits::scenarios_max`; Io.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>>
    create(const std::filesystem::path& directory, std::uint64_t scenarios);
    /// One that was sealed. Errors: Io, naming the file, when it is damaged or has another number
    /// of scenarios.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>> open(const std::filesystem::path& path,
                                                                 std::uint64_t scenarios);
    ~PoseSpool() override;

    /// The next scenarios, `pack_scenarios`, as received. After an error nothing of them is kept.
    /// Errors: those of `unpack_scenarios`; BadInput when an index does not continue, the job has
    /// no such bodies, or more come than were announced; TooLarge over
    /// `limits::poses_part_scenarios_max` at once; Io.
    [[nodiscard]] Status append(std::span<const std::byte> packed);

    /// All have come: the file gets this name, in its folder, and stays. Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);
    /// Reads all runs against their checksums. Errors: Io, naming the file.
    [[nodiscard]] Status verify() const;

    /// Appended so far.
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
