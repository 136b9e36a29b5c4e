// The run that an argument names: a results folder, or a job of a master.
#pragma once

#include "client/cli.hpp"
#include "client/folder/opened_run.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <string>
#include <utility>

namespace cd {

/// An opened folder. That of a job is a temporary one, which goes with this object.
class RunAtHand {
  public:
    /// Opens a folder, or fetches all that there is of a job. Errors: those of `OpenedRun::open`
    /// and `FetchedJob`.
    [[nodiscard]] static Result<RunAtHand> open(const std::string& argument,
                                                const MasterOptions& master);
    RunAtHand(RunAtHand&& other) noexcept
        : run_(std::move(other.run_)), temporary_(std::exchange(other.temporary_, {})) {}
    RunAtHand& operator=(RunAtHand&&) = delete;
    ~RunAtHand();

    [[nodiscard]] OpenedRun& run() { return run_; }

  private:
    RunAtHand(OpenedRun run, std::filesystem::path temporary)
        : run_(std::move(run)), temporary_(std::move(temporary)) {}

    OpenedRun run_;
    std::filesystem::path temporary_; ///< Empty: the folder stays.
};

} // namespace cd
