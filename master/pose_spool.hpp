// The poses of a job as a client sends them, on disk.
#pragma once

#include "common/core/result.hpp"
#include "common/job/pose_source.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace cd {

/// A file of packed scenarios that goes when this does. Memory: one run of scenarios, and eight
/// bytes for each run that is on disk. Any thread may call any member; all block for the disk.
class PoseSpool final : public PoseSource {
  public:
    /// A new file in `directory`, which is made if missing. More than `scenarios` are refused.
    /// Errors: TooLarge over `limits::scenarios_max`; Io.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>>
    create(const std::filesystem::path& directory, std::uint64_t scenarios);
    ~PoseSpool() override;

    /// The next scenarios, `pack_scenarios`, as received. After an error nothing of them is kept.
    /// Errors: those of `unpack_scenarios`; BadInput when an index does not continue, the job has
    /// no such bodies, or more come than were announced; Io.
    [[nodiscard]] Status append(std::span<const std::byte> packed);

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
