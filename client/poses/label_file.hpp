// The file inputs/ids of a results folder: ids and times of scenarios.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"

#include <cstdint>
#include <filesystem>

namespace cd {

/// An upper bound in bytes for the size of the file; 0 without labels.
[[nodiscard]] std::uint64_t label_bytes(const PoseLabels& labels);

/// Writes a CSV file with the columns `id` and `t`, as far as the labels have them, and one row per
/// scenario. Numbers are the shortest that read back to the same value. Errors: Io.
[[nodiscard]] Status write_labels(const std::filesystem::path& path, const PoseLabels& labels);

/// The inverse of `write_labels`, except that text ids become integers if all look like integers.
/// Errors: NotFound; Io naming the file, also if it is damaged.
[[nodiscard]] Result<PoseLabels> read_labels(const std::filesystem::path& path);

} // namespace cd
