// The verb `view`: serves the page of a results folder, of a job on a master, or of a cluster.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/slow_note.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/commands/viewing.hpp"
#include "client/view/folder_source.hpp"
#include "client/view/viewed_run.hpp"
#include "common/core/errors.hpp"

#include <memory>
#include <utility>

namespace cd {

namespace {

Result<std::unique_ptr<ViewedRun>>
open_viewed(const ViewCommand& command, RunAtHand& at_hand, ThreadPool& pool) {
    const SlowNote note("reading " + command.run + "...", false);
    return ViewedRun::open(at_hand.run, at_hand.job, std::move(at_hand.map), pool);
}

Result<int> view_folder(const ViewCommand& command) {
    ThreadPool pool(command.threads);
    auto at_hand = CD_TRY(open_run_at_hand(command.run,
                                           command.master,
                                           command.tree_cache,
                                           {.trees = Trees::Always, .map = true},
                                           pool));
    auto run = CD_TRY(open_viewed(command, at_hand, pool));
    auto gateway = CD_TRY(PageGateway::listen(command.port));
    FolderSource source(gateway->executor(), std::move(run), &InterruptGuard::has_come);
    InterruptGuard::begin_to_flag();
    serve_page(*gateway, source, command.no_browser);
    return exit_done;
}

} // namespace

Result<int> perform(const ViewCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    if (is_folder(command.run)) {
        return view_folder(command);
    }
    std::string job;
    if (command.run.empty()) {
        CD_TRY(open_master(command.master)); // Its errors are told before anything is served.
    } else {
        job = CD_TRY(open_job_of_argument(command.master, command.run)).id;
    }
    auto gateway = CD_TRY(PageGateway::listen(command.port));
    InterruptGuard::begin_to_flag();
    view_cluster(*gateway,
                 {command.master, job, command.tree_cache, command.threads, command.no_browser});
    return exit_done;
}

} // namespace cd
