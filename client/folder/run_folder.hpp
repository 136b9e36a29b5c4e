// A results folder while a run writes it.
#pragma once

#include "client/folder/run_manifest.hpp"
#include "common/core/disk_file.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace cd {

struct FolderOptions {
    bool overwrite = false; ///< Another run in the folder is replaced.
    bool fresh = false;     ///< What is there of the same job is not gone on from.
    bool resume = true;     ///< The unfinished part of the same job is gone on from.
};

/// A folder that one run writes and no other. All is written below `.part` and gets its place when
/// it is whole, so that an earlier run stays as it is until then.
class RunFolder {
  public:
    /// What of the job the folder holds already.
    enum class State : std::uint8_t { Nothing, Some, All };

    /// Takes a folder that holds a run, to add files to it. Errors: those of `read_run_json`; Io.
    [[nodiscard]] static Result<RunFolder> open_finished(const std::filesystem::path& dir);

    /// Takes the folder, which is made if missing, for the job of the manifest. Errors: Refused as
    /// BadInput where it holds another run (without `overwrite`); Io, also when another process
    /// writes it.
    [[nodiscard]] static Result<RunFolder>
    open(const std::filesystem::path& dir, const RunManifest& manifest, FolderOptions options);

    [[nodiscard]] State state() const { return state_; }
    /// Where the run's unfinished files are.
    [[nodiscard]] const std::filesystem::path& part() const { return part_; }
    /// Below it stands what `commit` moves into the folder.
    [[nodiscard]] std::filesystem::path out() const { return part_ / "out"; }
    [[nodiscard]] const std::filesystem::path& dir() const { return dir_; }

    /// Moves all files below `out`, then `records`, into the folder, removes those that the run
    /// before lists and this one does not have, and writes run.json, with the list of files added.
    /// Errors: Io.
    [[nodiscard]] Status commit(RunManifest manifest);
    /// Moves all files below `out` into the folder and adds them to its run.json, where the folder
    /// holds all of the job. Errors: Io.
    [[nodiscard]] Status add_files(std::span<const std::string> formats);
    /// Removes `.part`: nothing is to be gone on from.
    void clean();
    /// What run.json says of the unfinished part, where that is gone on from.
    [[nodiscard]] const std::optional<RunManifest>& unfinished() const { return unfinished_; }
    /// What the folder holds, where that is all of the job.
    [[nodiscard]] const std::optional<RunManifest>& finished() const { return before_; }

  private:
    RunFolder(std::filesystem::path dir, DiskFile lock);

    [[nodiscard]] static Result<RunFolder> take(const std::filesystem::path& dir);
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

/// The run.json of a folder. Errors: NotFound; BadInput and Io naming the file.
[[nodiscard]] Result<RunManifest> read_run_json(const std::filesystem::path& path);

/// Whether the name of a listed file stays within its folder.
[[nodiscard]] bool is_inside(std::string_view name);

} // namespace cd
