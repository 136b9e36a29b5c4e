#include "tests/support/process.hpp"

#include "common/core/check.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

namespace cd::tests {

namespace {

int exit_code_of(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

std::filesystem::path program(const std::string& name) {
    return std::filesystem::path(CD_BINARY_DIR) / "bin" / name;
}

Process::Process(const std::vector<std::string>& command, std::filesystem::path output)
    : output_(std::move(output)) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& word : command) {
        arguments.push_back(const_cast<char*>(word.c_str())); // NOLINT: posix_spawn does not write.
    }
    arguments.push_back(nullptr);

    ::setenv("CDCTL_TREE_CACHE", "off", 0); // Tests leave nothing in the user's cache.
    ::setenv("CDCTL_CONFIG", "none", 0);    // Nor do they heed the user's settings.
    const std::string errors = output_.string() + ".err";
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output_.c_str(), flags, 0644);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, errors.c_str(), flags, 0644);
    const int error = posix_spawnp(&pid_, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    CD_CHECK(error == 0);
}

Process::Process(Process&& other) noexcept
    : output_(std::move(other.output_)),
      pid_(std::exchange(other.pid_, -1)),
      exit_code_(other.exit_code_) {}

Process::~Process() {
    if (is_running()) {
        signal(SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
}

void Process::signal(int number) const {
    if (pid_ > 0 && !exit_code_) {
        kill(pid_, number);
    }
}

bool Process::is_running() {
    if (pid_ <= 0 || exit_code_) {
        return false;
    }
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
        exit_code_ = exit_code_of(status);
    }
    return !exit_code_;
}

std::optional<int> Process::wait(std::chrono::seconds limit) {
    if (!is_running()) {
        return exit_code_;
    }
    // The process's pidfd becomes readable when the process ends.
    const int handle = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
    CD_CHECK(handle >= 0);
    pollfd waiting{handle, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::chrono::milliseconds(limit).count()));
    close(handle);
    if (ready != 1) {
        signal(SIGKILL);
        waitpid(pid_, nullptr, 0);
        pid_ = -1;
        return std::nullopt;
    }
    int status = 0;
    waitpid(pid_, &status, 0);
    exit_code_ = exit_code_of(status);
    return exit_code_;
}

std::string Process::output() const {
    return read_text(output_);
}

std::string Process::errors() const {
    return read_text(output_.string() + ".err");
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cdcluster-XXXXXX").string();
    CD_CHECK(mkdtemp(name.data()) != nullptr);
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    CD_CHECK(out.good());
}

Ran run(const std::vector<std::string>& command) {
    static std::atomic<int> next{0};
    const TemporaryFolder folder;
    Process process(command, folder / ("output" + std::to_string(next++)));
    const std::optional<int> exit_code = process.wait(std::chrono::seconds(300));
    return {exit_code.value_or(-1), process.output(), process.errors()};
}

} // namespace cd::tests
