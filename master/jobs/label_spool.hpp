// The ids and times of a job's scenarios on disk, beside the poses.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

/// A file of labels in runs of `limits::spool_run_scenarios` scenarios. An index at its end holds
/// each run's end and checksum. The destructor deletes an unsealed file. One thread at a time; all
/// members block for the disk.
class LabelSpool {
  public:
    /// Makes a new file in `directory`, which exists, for `scenarios` scenarios. Errors: Io.
    [[nodiscard]] static Result<std::unique_ptr<LabelSpool>>
    create(const std::filesystem::path& directory, LabelColumns columns, std::uint64_t scenarios);
    /// Opens a sealed file. Errors: Io, naming the file, when it is damaged, or has other columns
    /// or another number of scenarios.
    [[nodiscard]] static Result<std::unique_ptr<LabelSpool>>
    open(const std::filesystem::path& path, LabelColumns columns, std::uint64_t scenarios);
    LabelSpool(const LabelSpool&) = delete;
    LabelSpool& operator=(const LabelSpool&) = delete;
    ~LabelSpool();

    /// Adds the labels of the next `scenarios` scenarios. Errors: BadInput for other columns than
    /// were announced, more scenarios, or an id that is too long; Io.
    [[nodiscard]] Status append(const PoseLabels& labels, std::size_t scenarios);
    /// Finishes the file after the last labels and renames it to `path`, in the same folder.
    /// Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);

    /// Reads all labels of a sealed file. Errors: Io, naming the file, when it is damaged.
    [[nodiscard]] Status verify() const;
    /// Returns the labels of scenarios [first, first + count), which must exist. Errors: Io naming
    /// a damaged file.
    [[nodiscard]] Result<PoseLabels> read(std::uint64_t first, std::uint64_t count) const;

  private:
    struct State;
    explicit LabelSpool(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
