// The verbs with which a shell completes command lines of cdctl.
#include "client/base/exit_code.hpp"
#include "client/cli/completion.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "common/core/timing/client.hpp"
#include "web/status/job_id.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string>

namespace cd {

namespace {

/// Ends the program with success at the time limit, whatever it waits for.
void end_after(std::chrono::milliseconds limit) {
    std::signal(SIGALRM, [](int) { ::_exit(exit_done); });
    itimerval timer{};
    timer.it_value.tv_usec = std::chrono::microseconds(limit).count();
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

} // namespace

Result<int> perform(const CompletionCommand& command) {
    const std::string_view script = completion_script(command.shell);
    std::fwrite(script.data(), 1, script.size(), stdout);
    return exit_done;
}

Result<int> perform(const CompleteCommand& command) {
    for (const std::string& word : command.words) {
        std::printf("%s\n", word.c_str());
    }
    if (command.has_files) {
        std::puts(":files");
    }
    std::fflush(stdout);
    if (!command.job_begin) {
        return exit_done;
    }
    end_after(timing::completion_max);
    const Result<ConnectedCluster> cluster = open_cluster(command.master);
    if (cluster) {
        const std::vector<JobId> ids = ids_of(cluster.value().status.jobs);
        for (const JobId id : ids) {
            if (const std::string text = job_id_text(id, ids);
                text.starts_with(*command.job_begin)) {
                std::printf("%s\n", text.c_str());
            }
        }
    }
    std::fflush(stdout);
    ::_exit(exit_done); // An unreachable master is no news to someone who types.
}

} // namespace cd
