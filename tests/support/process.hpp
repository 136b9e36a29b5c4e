// Real processes for the tests of the programs: started, spoken to, and never left behind.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd::tests {

/// The folder of the three programs under test.
[[nodiscard]] std::filesystem::path program(const std::string& name);

/// A child with its standard output and error in files. Killed at destruction if it still runs.
class Process {
  public:
    /// `output` gets what it prints on stdout, `output` + ".err" what it prints on stderr.
    Process(const std::vector<std::string>& command, std::filesystem::path output);
    Process(Process&& other) noexcept;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process();

    void signal(int number) const;
    [[nodiscard]] pid_t id() const { return pid_; }
    /// Its exit code, or 128 + the signal that ended it. Waits; killed (and nothing returned) when
    /// `limit` passes.
    [[nodiscard]] std::optional<int> wait(std::chrono::seconds limit = std::chrono::seconds(120));
    [[nodiscard]] bool is_running();

    [[nodiscard]] std::string output() const;
    [[nodiscard]] std::string errors() const;

  private:
    std::filesystem::path output_;
    pid_t pid_ = -1;
    std::optional<int> exit_code_;
};

/// A folder of its own that disappears with the object.
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

/// Runs a command to its end. The exit code, and what it printed on both.
struct Ran {
    int exit_code = -1;
    std::string output;
    std::string errors;
};
[[nodiscard]] Ran run(const std::vector<std::string>& command);

} // namespace cd::tests
