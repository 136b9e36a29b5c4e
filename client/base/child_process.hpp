// A program that this one starts, and that never outlives it.
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
    /// Starts the program with its output appended to `log`. It gets no signals from the terminal:
    /// whoever owns this object ends it. It is told to end should this process die.
    /// Errors: NotFound for a missing program; Io.
    [[nodiscard]] static Result<ChildProcess> start(const std::filesystem::path& program,
                                                    const std::vector<std::string>& arguments,
                                                    const std::filesystem::path& log);

    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    /// Stops it.
    ~ChildProcess();

    [[nodiscard]] bool is_running();

    /// Asks it to end, and kills it should it not within the grace period.
    void stop(std::chrono::milliseconds grace = std::chrono::seconds(10));

    [[nodiscard]] pid_t id() const { return id_; }

  private:
    explicit ChildProcess(pid_t id) : id_(id) {}

    pid_t id_ = 0; ///< 0 once it has ended.
};

} // namespace cd
