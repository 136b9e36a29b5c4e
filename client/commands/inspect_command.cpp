#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/units.hpp"
#include "client/commands/commands.hpp"
#include "client/picture/body_picture.hpp"
#include "client/report/inspect.hpp"
#include "client/report/report.hpp"
#include "common/core/errors.hpp"

#include <cstdio>
#include <string>
#include <vector>

namespace cd {

namespace {

/// Returns the factor of the file's coordinates. Without --unit, coordinates are shown as in the
/// file, or in metres if the file declares a unit.
Result<double> factor_of(const InspectCommand& command) {
    if (command.unit.empty() && !command.job_unit.empty()) {
        return bad_input("--job-unit needs --unit, the unit of the file");
    }
    if (command.unit.empty()) {
        return 1.0;
    }
    return unit_factor(command.unit, command.job_unit.empty() ? "m" : command.job_unit).value_or(1);
}

} // namespace

Result<int> perform(const InspectCommand& command) {
    if (!command.png.empty() && command.meshes.size() != 1) {
        return bad_input("--png draws one mesh; inspect the others by themselves");
    }
    const auto factor = CD_TRY(factor_of(command));
    std::vector<BodyLine> bodies;
    for (const std::string& file : command.meshes) {
        ImportOptions options{factor};
        options.declared_unit_to = command.unit.empty() ? "m" : "";
        options.is_stopped = &InterruptGuard::has_come;
        const auto imported = CD_TRY(import_mesh(file, options));
        MeshReport report = inspect_mesh(file, imported);
        report.notes = import_notes(imported, command.unit, false);
        const std::string text = command.output == "json" ? to_json(report) : to_text(report);
        std::fputs(text.c_str(), stdout);
        const BodyLine body = describe_body(file, "", *imported.mesh);
        for (const BodyLine& earlier : bodies) {
            if (const auto warning = unit_warning(earlier, body)) {
                std::fputs((*warning + "\n").c_str(), stderr);
            }
        }
        bodies.push_back(body);
        if (!command.png.empty()) {
            CD_TRY(write_png(draw_parts(*imported.mesh), command.png));
        }
    }
    return exit_done;
}

} // namespace cd
