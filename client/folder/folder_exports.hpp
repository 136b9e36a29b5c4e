// Exports of a run that is whole in its folder, made later and without running anything.
#pragma once

#include "client/export/result_sink.hpp"
#include "client/folder/opened_run.hpp"
#include "client/folder/run_folder.hpp"
#include "client/report.hpp"
#include "common/core/result.hpp"

#include <string>
#include <vector>

namespace cd {

struct ExportOptions {
    std::vector<std::string> formats; ///< For the folder.
    std::string output = "text";      ///< For stdout, as `SinkOptions` has it.
    bool again = false;               ///< Also the formats that the folder has already.
};

/// Reads all records once, if anything wants them: adds the formats that the folder lacks, with
/// their names in run.json, and writes to stdout. `folder` may be null where no format is to be
/// added. What the records sum up to; time and place are those of summary.json. Errors: Io;
/// BadInput for an unknown format; Interrupted.
[[nodiscard]] Result<RunReport> add_exports(const OpenedRun& run,
                                            RunFolder* folder,
                                            const ExportContext& context,
                                            ExportOptions options);

} // namespace cd
