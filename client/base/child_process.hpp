// A child program, which never outlives this process.
#pragma once

#include "common/core/result.hpp"

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace cd {

class ChildProcess {
  public:
    /// Starts the program and appends its output to `log`. The program gets no signals from the
    /// terminal. It gets SIGTERM if this process dies; otherwise the owner of this object ends it.
    /// Errors: NotFound for a missing program; Io.
    [[nodiscard]] static Result<ChildProcess> start(const std::filesystem::path& program,
                                                    const std::vector<std::string>& arguments,
                                                    const std::filesystem::path& log);

    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    /// Calls `stop`.
    ~ChildProcess();

    [[nodiscard]] bool is_running();

    /// Ends the child: sends SIGTERM, and after the grace period SIGKILL if it still runs.
    void stop(std::chrono::milliseconds grace = std::chrono::seconds(10));

    [[nodiscard]] pid_t id() const { return id_; }

  private:
    explicit ChildProcess(pid_t id) : id_(id) {}

    pid_t id_ = 0; ///< 0 once the child has ended.
};

} // namespace cd
