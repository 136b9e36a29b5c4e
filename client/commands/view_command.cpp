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
    serve_page(*gateway, source, {.no_browser = command.no_browser});
    return exit_done;
}

} // namespace

Result<int> perform(const ViewCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    if (is_folder(command.run)) {
        return view_folder(command);
    }
    ClusterViewing what{command.master, "", command.tree_cache, command.threads};
    what.serving.no_browser = command.no_browser;
    // Errors of the master are told before anything is served.
    if (command.run.empty()) {
        what.is_tls = CD_TRY(open_master(command.master))->is_tls();
    } else {
        const auto opened = CD_TRY(open_job_of_argument(command.master, command.run));
        what.job = opened.id;
        what.is_tls = opened.connection->is_tls();
    }
    auto gateway = CD_TRY(PageGateway::listen(command.port));
    InterruptGuard::begin_to_flag();
    view_cluster(*gateway, what);
    return exit_done;
}

} // namespace cd
