// The file inputs/ids of a results folder: how the pose file named its scenarios.
#pragma once

#include "common/core/result.hpp"
#include "common/job/pose_labels.hpp"

#include <cstdint>
#include <filesystem>

namespace cd {

/// At least what the file takes.
[[nodiscard]] std::uint64_t label_bytes(const PoseLabels& labels);

/// Writes a CSV file with the columns `id` and `t`, as far as they are there, a row for each
/// scenario; numbers are the shortest that read back the same. Errors: Io.
[[nodiscard]] Status write_labels(const std::filesystem::path& path, const PoseLabels& labels);

/// The inverse, but for ids that are texts and are all written as integers: they become integers.
/// Errors: NotFound; Io naming the file, also for one that is damaged.
[[nodiscard]] Result<PoseLabels> read_labels(const std::filesystem::path& path);

} // namespace cd
