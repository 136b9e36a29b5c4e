#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/job/clearance_warning.hpp"
#include "client/scene/coverage_text.hpp"
#include "client/scene/scene_check.hpp"
#include "common/core/errors.hpp"

#include <cstdio>
#include <string>

namespace cd {

Result<int> perform(const CheckCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    const auto spec = CD_TRY(read_job_file(command.file));
    if (!spec.scene) {
        return bad_input(command.file + " is a job of two bodies; `cdctl run " + command.file +
                         " --dry-run` checks it");
    }
    const auto prepared = CD_TRY(prepare_scene(spec, command.quiet, &InterruptGuard::has_come));
    for (const std::string& warning : prepared.warnings) {
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
    }
    if (const auto warning = clearance_warning(spec, prepared.scene)) {
        std::fprintf(stderr, "%s\n", warning->c_str());
    }
    const std::string text = command.output == "csv"
                                 ? coverage_csv(*prepared.steps)
                                 : check_text(spec, prepared) + "nothing was run\n";
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

} // namespace cd
