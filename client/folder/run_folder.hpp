// A results folder that a run writes.
#pragma once

#include "client/folder/run_manifest.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

struct FolderOptions {
    bool overwrite = false; ///< Replace another run in the folder.
    bool fresh = false;     ///< Ignore earlier results of this job.
    bool resume = true;     ///< Resume an unfinished run of this job.
};

/// A folder that one run at a time may write. Files are written below `.part` and moved into place
/// when the run is complete, so an earlier run stays intact until then.
class RunFolder {
  public:
    /// How many results of the job are in the folder.
    enum class State : std::uint8_t { Nothing, Some, All };

    /// Locks a folder to add files to its finished run, whose manifest is `expected`. Errors:
    /// BadInput if the folder has another run by now; Io, also if another process writes it.
    [[nodiscard]] static Result<RunFolder> open_finished(const std::filesystem::path& dir,
                                                         const RunManifest& expected);

    /// Locks a folder, which is created if missing, for the job of the manifest. Errors: BadInput
    /// if it holds another run and `overwrite` is not set, or an unfinished run to resume that
    /// takes results from another run; Io, also if another process writes it.
    [[nodiscard]] static Result<RunFolder>
    open(const std::filesystem::path& dir, const RunManifest& manifest, FolderOptions options);

    [[nodiscard]] State state() const { return state_; }
    /// Returns the folder `.part`, which holds the run's unfinished files.
    [[nodiscard]] const std::filesystem::path& part() const { return part_; }
    /// Returns the folder whose files `commit` moves into place.
    [[nodiscard]] std::filesystem::path out() const { return part_ / "out"; }
    [[nodiscard]] const std::filesystem::path& dir() const { return dir_; }

    /// Moves `records` and all files below `out` into the folder, removes files that only the
    /// previous run lists, and writes a run.json that lists all files. Errors: Io.
    [[nodiscard]] Status commit(RunManifest manifest);
    /// Moves all files below `out` into the folder of a finished run, and lists them and the
    /// formats in its run.json. Errors: Io.
    [[nodiscard]] Status add_files(std::span<const std::string> formats);
    /// Removes `.part`, so that nothing can be resumed.
    void clean();
    /// Returns the manifest of the unfinished run to resume; nothing unless `state` is Some.
    [[nodiscard]] const std::optional<RunManifest>& unfinished() const { return unfinished_; }
    /// Returns the manifest of the finished run that the folder had when opened; nothing if none.
    [[nodiscard]] const std::optional<RunManifest>& finished() const { return before_; }

  private:
    RunFolder(std::filesystem::path dir, DiskFile lock);

    /// Locks a folder, which is created if missing, before anything in it is read.
    [[nodiscard]] static Result<RunFolder> take(const std::filesystem::path& dir);
    /// Undoes `take`: removes the lock and an empty `.part`. Returns `error`.
    [[nodiscard]] Error give_up(Error error);
    [[nodiscard]] Status begin(const RunManifest& manifest);
    void recover_files();
    [[nodiscard]] Result<std::vector<ManifestFile>> move_files();

    std::filesystem::path dir_;
    std::filesystem::path part_;
    DiskFile lock_;
    State state_ = State::Nothing;
    std::optional<RunManifest> before_; ///< The finished run in the folder.
    std::optional<RunManifest> unfinished_;
};

/// Reads a run.json. Errors: NotFound; BadInput and Io naming the file.
[[nodiscard]] Result<RunManifest> read_run_json(const std::filesystem::path& path);

/// True if a listed file's name is a relative path that does not leave the folder.
[[nodiscard]] bool is_inside(std::string_view name);

} // namespace cd
