// A job's uploaded poses on disk.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/submission/spool_file.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cd {

/// What a submission announces of its scenarios.
struct AnnouncedPoses {
    std::uint64_t scenarios = 0;
    std::uint64_t bodies = 2; ///< Number of the job's bodies.
    bool have_steps = false;  ///< The job is a scene: each scenario has a step.
    bool are_motions = false; ///< Each scenario has poses to move to.
};

/// Returns what a submission announces.
[[nodiscard]] AnnouncedPoses announced_by(const Submit& submit);

/// A spool file of packed scenarios in the order in which the job hands them out. They are stored
/// as the client packed them. Any thread may call any member; all block for the disk.
class PoseSpool final : public PoseRuns {
  public:
    /// Creates a file in `directory`, which is made if missing. Errors: TooLarge over
    /// `limits::scenarios_max`; Io.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>>
    create(const std::filesystem::path& directory, const AnnouncedPoses& job);
    /// Opens a sealed file. Errors: Io naming a file that is damaged or has another number of
    /// scenarios.
    [[nodiscard]] static Result<std::unique_ptr<PoseSpool>> open(const std::filesystem::path& path,
                                                                 const AnnouncedPoses& job);

    /// Appends the next run, packed by `pack_scenarios`: `limits::pose_run_scenarios` scenarios, or
    /// all that are left. Each has an index in the run's window that is not used yet. An error
    /// leaves the file unchanged. Errors: as `unpack_scenarios`; BadInput for another number of
    /// scenarios, an index that is used or outside the window, bodies that the job cannot have
    /// (`are_bodies_of_job`), or a step or a second pair of poses that the job's scenarios do not
    /// have, or lack; Io.
    [[nodiscard]] Status append(const Bytes& packed);

    /// Finishes the file after the last scenarios and renames it to `path`, which is in its folder.
    /// Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);
    /// Reads all runs and checks them as `append` does. Errors: Io, naming the file.
    [[nodiscard]] Status verify() const;

    /// Number of scenarios appended.
    [[nodiscard]] std::uint64_t count() const override;
    [[nodiscard]] bool is_complete() const;
    [[nodiscard]] Result<PackedScenarios> run(std::uint64_t number) const override;

  private:
    PoseSpool(SpoolFile file, const AnnouncedPoses& job) : file_(std::move(file)), job_(job) {}
    [[nodiscard]] std::uint64_t count_locked() const;
    /// Checks the run that begins at position `first`. `came` tells which indices of the run's
    /// window earlier runs had, and is set for the run's own.
    [[nodiscard]] Status
    check_run(const PackedScenarios& run, std::uint64_t first, std::vector<bool>& came) const;

    mutable std::mutex mutex_;
    SpoolFile file_;
    AnnouncedPoses job_;
    /// For each index of the current window: true if its scenario has been appended.
    std::vector<bool> came_;
};

} // namespace cd
