// Runs real processes in tests of the programs and kills them at the end.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd::tests {

/// Returns the path of one of the three programs under test.
[[nodiscard]] std::filesystem::path program(const std::string& name);

/// A child whose standard output and error go to files. The destructor kills it if it still runs.
class Process {
  public:
    /// Writes the child's stdout to `output` and its stderr to `output` + ".err".
    Process(const std::vector<std::string>& command, std::filesystem::path output);
    Process(Process&& other) noexcept;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process();

    void signal(int number) const;
    [[nodiscard]] pid_t id() const { return pid_; }
    /// Waits and returns the exit code, or 128 + the signal that ended it. Kills it and returns
    /// nothing after `limit`.
    [[nodiscard]] std::optional<int> wait(std::chrono::seconds limit = std::chrono::seconds(120));
    [[nodiscard]] bool is_running();

    [[nodiscard]] std::string output() const;
    [[nodiscard]] std::string errors() const;

  private:
    std::filesystem::path output_;
    pid_t pid_ = -1;
    std::optional<int> exit_code_;
};

/// A temporary folder; the destructor removes it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// The exit code of a finished command, and its output on stdout and stderr.
struct Ran {
    int exit_code = -1;
    std::string output;
    std::string errors;
};
[[nodiscard]] Ran run(const std::vector<std::string>& command);

} // namespace cd::tests
