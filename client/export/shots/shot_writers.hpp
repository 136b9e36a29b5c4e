// Writes the hits of lines, one writer per format.
#pragma once

#include "client/export/result_writer.hpp"
#include "client/export/shots/shot_job.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <memory>
#include <string_view>

namespace cd {

/// Writes shots.npz or shots.h5: every hit of every line; docs/shots.md describes the arrays.
/// `format` is one of `array_formats`.
[[nodiscard]] std::unique_ptr<ResultWriter> make_shots_array_writer(
    std::string_view format, const ExportContext& context, const std::filesystem::path& dir);

/// Writes shotlines.csv: a row for each passage of a line through a part; docs/shots.md describes
/// its columns. Errors: Io naming the file; BadInput for a scene whose poses are not at hand.
[[nodiscard]] Result<std::unique_ptr<ResultWriter>>
make_shotlines_writer(std::shared_ptr<const ShotJob> job, const std::filesystem::path& dir);

} // namespace cd
