#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "common/core/build_info.hpp"
#include "common/core/errors.hpp"
#include "common/geometry/simd_target.hpp"

#include <csignal>
#include <cstdio>

namespace cd {

int exit_code_of(const Summary& summary, FailOn fail_on, bool has_news) {
    if (!summary.is_complete() || summary.failed != 0) {
        return exit_incomplete;
    }
    const std::uint64_t worst = summary.cross + summary.inside;
    const std::uint64_t any = worst + summary.touch + summary.contact;
    const bool is_near = summary.near != 0 || any != 0;
    if ((fail_on.near && is_near) || (fail_on.touch && any != 0) || (fail_on.cross && worst != 0) ||
        (fail_on.undecided && summary.undecided != 0) || (fail_on.news && has_news)) {
        return exit_contacts;
    }
    // With --fail-on the user asks whether there are contacts; undecided scenarios leave this open.
    return fail_on.any() && summary.undecided != 0 ? exit_incomplete : exit_done;
}

Status check_fail_on(FailOn fail_on, const Query& query) {
    if (fail_on.near && !query.clearance) {
        return bad_input("--fail-on near needs a clearance: give --clearance, or the key clearance "
                         "in the job file's table [query]");
    }
    if (fail_on.cross && !fail_on.touch && !fail_on.near && query.level == Level::Any) {
        return bad_input(
            "--fail-on cross needs level count or more: any does not tell touch from cross");
    }
    if (fail_on.cross && !fail_on.touch && query.question == Question::Shots) {
        return bad_input("--fail-on cross is about bodies: lines that hit are in contact, so give "
                         "--fail-on touch");
    }
    if (fail_on.news && query.level < Level::Pairs && !query.maps) {
        return bad_input("--fail-on new is about groups, which need level pairs or contacts, or "
                         "level count with maps = true");
    }
    return Done{};
}

int fail(const Error& error) {
    std::fprintf(stderr, "cdctl: %s\n", error.detail.c_str());
    const int signal = InterruptGuard::signal();
    return exit_code_of(error, signal == 0 ? SIGINT : signal);
}

Result<int> perform(const VersionCommand& command) {
    const bool as_json = command.output == "json";
    std::fputs(version_text("cdctl", to_text(simd_target()), as_json).c_str(), stdout);
    return exit_done;
}

} // namespace cd
