#include "bench/accuracy/isolate.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace cd::bench {

std::string_view to_text(Ending ending) {
    switch (ending) {
    case Ending::Done:
        return "done";
    case Ending::Crashed:
        return "crashed";
    case Ending::TimedOut:
        return "timed out";
    }
    return "";
}

Ending run_isolated(std::chrono::seconds limit, const std::function<void()>& work) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    CD_CHECK(child >= 0);
    if (child == 0) {
        const rlimit no_core{0, 0};
        static_cast<void>(::setrlimit(RLIMIT_CORE, &no_core));
        // The default action of SIGALRM ends the process anywhere.
        static_cast<void>(std::signal(SIGALRM, SIG_DFL));
        static_cast<void>(::alarm(static_cast<unsigned>(limit.count())));
        work();
        std::fflush(nullptr);
        ::_exit(0);
    }
    int status = 0;
    CD_CHECK(::waitpid(child, &status, 0) == child);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) {
        return Ending::TimedOut;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::Done : Ending::Crashed;
}

} // namespace cd::bench
