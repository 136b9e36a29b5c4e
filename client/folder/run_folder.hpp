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
    bool fresh = false;     ///< Ignore earlier results of the same job.
    bool resume = true;     ///< Resume an unfinished run of the same job.
};

/// A folder that one run at a time may write. Files are written below `.part` and moved into place
/// when the run is complete, so an earlier run stays intact until then.
class RunFolder {
  public:
    /// How many of the job's results the folder already has.
    enum class State : std::uint8_t { Nothing, Some, All };

    /// Locks a folder whose finished run has the manifest `expected`, to add files to it. Errors:
    /// BadInput if the folder has another run by now; Io, also if another process writes it.
    [[nodiscard]] static Result<RunFolder> open_finished(const std::filesystem::path& dir,
                                                         const RunManifest& expected);

    /// Locks the folder for the job of the manifest, and creates it if missing. Errors: BadInput if
    /// it holds another run and `overwrite` is not set; Io, also if another process writes it.
    [[nodiscard]] static Result<RunFolder>
    open(const std::filesystem::path& dir, const RunManifest& manifest, FolderOptions options);

    [[nodiscard]] State state() const { return state_; }
    /// The folder of the run's unfinished files.
    [[nodiscard]] const std::filesystem::path& part() const { return part_; }
    /// The folder whose files `commit` moves into place.
    [[nodiscard]] std::filesystem::path out() const { return part_ / "out"; }
    [[nodiscard]] const std::filesystem::path& dir() const { return dir_; }

    /// Moves `records` and all files below `out` into the folder, removes files that only the
    /// previous run lists, and writes run.json with the list of files. Errors: Io.
    [[nodiscard]] Status commit(RunManifest manifest);
    /// Moves all files below `out` into a folder with a finished run and lists them in its
    /// run.json. Errors: Io.
    [[nodiscard]] Status add_files(std::span<const std::string> formats);
    /// Removes `.part`, so that nothing can be resumed.
    void clean();
    /// The manifest of the unfinished run that is resumed; nothing unless `state` is Some.
    [[nodiscard]] const std::optional<RunManifest>& unfinished() const { return unfinished_; }
    /// The manifest of the finished run that was in the folder when it was opened; nothing if none.
    [[nodiscard]] const std::optional<RunManifest>& finished() const { return before_; }

  private:
    RunFolder(std::filesystem::path dir, DiskFile lock);

    /// Locks the folder, and creates it if missing. Nothing in the folder is read before.
    [[nodiscard]] static Result<RunFolder> take(const std::filesystem::path& dir);
    /// Undoes `take`, and returns `error`.
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

/// True if the relative name of a listed file does not leave the folder.
[[nodiscard]] bool is_inside(std::string_view name);

} // namespace cd
