#include "client/base/child_process.hpp"

#include "common/core/timing/client.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

namespace cd {

namespace {

/// Turns a forked child into the program. Before exec, only async-signal-safe calls are allowed.
[[noreturn]] void become(const char* program, char* const* arguments, int log, pid_t parent) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) {
        _exit(127); // The parent died before prctl took effect.
    }
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execv(program, arguments);
    _exit(127);
}

} // namespace

Result<ChildProcess> ChildProcess::start(const std::filesystem::path& program,
                                         const std::vector<std::string>& arguments,
                                         const std::filesystem::path& log) {
    if (access(program.c_str(), X_OK) != 0) {
        return Error{ErrorCode::NotFound, program.string() + ": no such program"};
    }
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file < 0) {
        return Error{ErrorCode::Io, log.string() + ": " + std::strerror(errno)};
    }
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    const pid_t parent = getpid();
    const pid_t id = fork();
    if (id == 0) {
        become(program.c_str(), pointers.data(), file, parent);
    }
    const int problem = errno;
    close(file);
    if (id < 0) {
        return Error{ErrorCode::Io, program.string() + ": " + std::strerror(problem)};
    }
    return ChildProcess(id);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

ChildProcess::~ChildProcess() {
    stop();
}

bool ChildProcess::is_running() {
    if (id_ != 0 && waitpid(id_, nullptr, WNOHANG) == id_) {
        id_ = 0;
    }
    return id_ != 0;
}

void ChildProcess::stop(std::chrono::milliseconds grace) {
    if (!is_running()) {
        return;
    }
    kill(id_, SIGTERM);
    const auto deadline = std::chrono::steady_clock::now() + grace;
    while (is_running() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(timing::process_poll_period);
    }
    if (is_running()) {
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
        id_ = 0;
    }
}

} // namespace cd
