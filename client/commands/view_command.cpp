// The verb `view`: serves the page of a results folder or of a job on a master.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/slow_note.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/view/folder_source.hpp"
#include "client/view/page_gateway.hpp"
#include "client/view/viewed_run.hpp"
#include "common/core/errors.hpp"
#include "common/core/timing/web.hpp"

#include <cstdio>
#include <memory>
#include <utility>

namespace cd {

namespace {

Result<std::unique_ptr<ViewedRun>> open_viewed(const ViewCommand& command) {
    ThreadPool pool(command.threads);
    auto [run, job] = CD_TRY(
        open_run_at_hand(command.run, command.master, command.tree_cache, Trees::Always, pool));
    const SlowNote note("reading " + command.run + "...", false);
    return ViewedRun::open(std::move(run), std::move(job), pool);
}

} // namespace

Result<int> perform(const ViewCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    auto run = CD_TRY(open_viewed(command));
    auto gateway = CD_TRY(PageGateway::listen(command.port));
    FolderSource source(gateway->executor(), std::move(run), &InterruptGuard::has_come);
    InterruptGuard::begin_to_flag();
    std::printf("%s\n", gateway->url().c_str());
    std::fflush(stdout);
    std::fprintf(stderr, "  Ctrl-C ends it, and so do 30 minutes without a request\n");
    if (!command.no_browser) {
        open_browser(gateway->url());
    }
    gateway->serve(source, &InterruptGuard::has_come, timing::view_idle_max);
    return exit_done;
}

} // namespace cd
