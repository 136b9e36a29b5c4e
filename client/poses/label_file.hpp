// The file inputs/ids of a results folder: ids and times of scenarios.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"

#include <cstdint>
#include <filesystem>

namespace cd {

/// Returns an upper bound in bytes for the size of the labels' file; 0 without labels.
[[nodiscard]] std::uint64_t label_bytes(const PoseLabels& labels);

/// Writes a CSV file with the columns `id` and `t`, as far as the labels have them, and one row per
/// scenario. A number is the shortest decimal that reads back to its value. Errors: Io.
[[nodiscard]] Status write_labels(const std::filesystem::path& path, const PoseLabels& labels);

/// Reads what `write_labels` wrote, except that text ids become integers if all look like integers.
/// Errors: NotFound; Io naming the file, also for a damaged file.
[[nodiscard]] Result<PoseLabels> read_labels(const std::filesystem::path& path);

} // namespace cd
