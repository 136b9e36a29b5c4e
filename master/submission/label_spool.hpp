// The labels of a job's scenarios on disk: the ids and times of the pose file.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "master/submission/spool_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>

namespace cd {

/// A spool file of labels. One thread at a time; all members block for the disk.
class LabelSpool {
  public:
    /// Makes a new file in `directory`, which must exist, for `scenarios` scenarios. Errors: Io.
    [[nodiscard]] static Result<std::unique_ptr<LabelSpool>>
    create(const std::filesystem::path& directory, LabelColumns columns, std::uint64_t scenarios);
    /// Opens a sealed file. Errors: Io, naming the file, when it is damaged, or has other columns
    /// or another number of scenarios.
    [[nodiscard]] static Result<std::unique_ptr<LabelSpool>>
    open(const std::filesystem::path& path, LabelColumns columns, std::uint64_t scenarios);

    /// Adds the labels of the next `scenarios` scenarios. Errors: BadInput for other columns or
    /// more scenarios than `create` was called with, or for an id that is too long; Io.
    [[nodiscard]] Status append(const PoseLabels& labels, std::size_t scenarios);
    /// Finishes the file after the last labels and renames it to `path`, which is in its folder.
    /// Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);

    /// Reads all labels of a sealed file. Errors: Io, naming the file, when it is damaged.
    [[nodiscard]] Status verify() const;
    /// Returns the labels of scenarios [first, first + count), which must exist. Errors: Io naming
    /// a damaged file.
    [[nodiscard]] Result<PoseLabels> read(std::uint64_t first, std::uint64_t count) const;

  private:
    LabelSpool(SpoolFile file, LabelColumns columns) : file_(std::move(file)), columns_(columns) {}
    [[nodiscard]] Status write_last();
    [[nodiscard]] Result<PoseLabels> read_run(std::uint64_t run) const;

    SpoolFile file_;
    LabelColumns columns_;
    std::uint64_t count_ = 0; ///< Scenarios with labels received.
    PoseLabels last_;         ///< Labels of the unfinished run, not on disk yet.
    std::size_t last_count_ = 0;
};

} // namespace cd
