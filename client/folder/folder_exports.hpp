// Adds exports to a finished run's folder without running anything, and reads its summary.
#pragma once

#include "client/export/result_sink.hpp"
#include "client/folder/opened_run.hpp"
#include "client/folder/run_folder.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cd {

struct ExportOptions {
    std::vector<std::string> formats; ///< Formats to write into the folder.
    std::string output = "text";      ///< Format for stdout, as in `SinkOptions`.
    bool again = false;               ///< Also rewrite the formats that the folder has.
};

/// Reads all records once, writes the missing formats into the folder, lists them in run.json, and
/// writes `output` to stdout. `folder` may be null if no format is to be added. Returns a report
/// made from the records, with `execution` from summary.json. Errors: Io; BadInput for an unknown
/// format; Interrupted.
[[nodiscard]] Result<RunReport> add_exports(const OpenedRun& run,
                                            RunFolder* folder,
                                            const ExportContext& context,
                                            ExportOptions options);

/// Reads a report from summary.json: the counts of classes, time, place, most touched parts and
/// digest. Missing keys count as 0 or none. Errors: NotFound, Io, BadInput naming the file.
[[nodiscard]] Result<RunReport> read_summary(const std::filesystem::path& path);

} // namespace cd
