#include "client/folder/run_folder.hpp"

#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/result/record_file.hpp"

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

namespace cd {

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "run.json";
/// Names of files that a run may write, besides run.json and inputs/meshes.
constexpr std::array<const char*, 17> result_names{"summary.json",
                                                   "scenarios.csv",
                                                   "groups.csv",
                                                   "pairs.csv",
                                                   "points.csv",
                                                   "results.npz",
                                                   "shots.npz",
                                                   "shotlines.csv",
                                                   "results.jsonl",
                                                   "results.txt",
                                                   "contacts.vtp",
                                                   "map.csv",
                                                   "map.npz",
                                                   "records",
                                                   "maps",
                                                   "inputs/scenarios",
                                                   "inputs/ids"};

Error refused(const fs::path& dir, const std::string& what) {
    return bad_input(dir.string() + " holds " + what +
                     "; give another folder with --out, or --overwrite");
}

/// Reads a run.json; nothing for a missing file, or with `overwrite` for an unreadable one.
Result<std::optional<RunManifest>> read_if_there(const fs::path& path, bool overwrite) {
    auto manifest = read_run_json(path);
    if (manifest) {
        return std::optional(std::move(manifest.value()));
    }
    const Error& error = manifest.error();
    if (overwrite || error.code == ErrorCode::NotFound) {
        return std::optional<RunManifest>();
    }
    return Error{error.code, error.detail + "; give another folder with --out, or --overwrite"};
}

bool holds_results(const fs::path& dir) {
    return std::ranges::any_of(result_names, [&](const char* name) {
        std::error_code error;
        return fs::is_regular_file(dir / name, error);
    });
}

std::string named(const RunManifest& manifest) {
    return "another run (" + manifest.name + ", of " + manifest.origin.started + ")";
}

/// Refuses a folder with results of a job other than the manifest's.
Status check_no_other(const fs::path& dir,
                      const RunManifest& manifest,
                      const std::optional<RunManifest>& finished,
                      const std::optional<RunManifest>& unfinished) {
    if (finished && !is_same_job(*finished, manifest)) {
        return refused(dir, named(*finished));
    }
    // An unfinished fetch does not block, since the master's job can be fetched again.
    const bool is_fetched = unfinished && !unfinished->where.master.empty();
    if (unfinished && !is_fetched && !is_same_job(*unfinished, manifest)) {
        return refused(dir, "the unfinished part of " + named(*unfinished));
    }
    if (!finished && !unfinished && holds_results(dir)) {
        return refused(dir, "results without a run.json");
    }
    return Done{};
}

/// Returns the error for resuming a run with another value of --reuse, whose results would be
/// mixed with those of the first.
Error reuses_other(const fs::path& dir, const RunManifest& unfinished) {
    const auto& reused = unfinished.outcome.reused;
    return bad_input(dir.string() + " holds the unfinished part of a run " +
                     (reused ? "with --reuse " + reused->run : "without --reuse") +
                     "; resume it with: " + unfinished.origin.command +
                     "; or start anew with --fresh");
}

Error failure(const fs::path& path, const std::error_code& error) {
    return {ErrorCode::Io, path.string() + ": " + error.message()};
}

/// Removes a file, and the folders of its path that become empty.
void remove_listed(const fs::path& dir, const std::string& name) {
    std::error_code error;
    fs::remove(dir / name, error);
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty();
         parent = parent.parent_path()) {
        fs::remove(dir / parent, error); // Fails unless the folder is empty.
    }
}

std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
        if (entry.is_regular_file(error)) {
            names.push_back(entry.path().lexically_relative(folder).generic_string());
        }
    }
    std::ranges::sort(names);
    return names;
}

} // namespace

Result<RunManifest> read_run_json(const fs::path& path) {
    const std::string text = CD_TRY(read_file(path));
    return within(path.string() + ": ", parse_manifest(text));
}

bool is_inside(std::string_view name) {
    const fs::path path(name);
    return !name.empty() && path.is_relative() &&
           std::ranges::none_of(path, [](const fs::path& step) { return step == ".."; });
}

RunFolder::RunFolder(fs::path dir, DiskFile lock)
    : dir_(std::move(dir)), part_(dir_ / ".part"), lock_(std::move(lock)) {}

Result<RunFolder>
RunFolder::open(const fs::path& dir, const RunManifest& manifest, FolderOptions options) {
    auto taken = CD_TRY(take(dir));
    RunFolder& folder = taken;
    auto finished = read_if_there(dir / manifest_name, options.overwrite);
    auto unfinished = read_if_there(folder.part_ / manifest_name, options.overwrite);
    if (!finished || !unfinished) {
        return folder.give_up(finished ? unfinished.error() : finished.error());
    }
    if (!options.overwrite) {
        const Status free = check_no_other(dir, manifest, finished.value(), unfinished.value());
        if (!free) {
            return folder.give_up(free.error());
        }
    }
    folder.before_ = std::move(finished.value());
    const auto is_this = [&](const std::optional<RunManifest>& other) {
        return other && !options.fresh && is_same_job(*other, manifest);
    };
    if (is_this(folder.before_) && folder.before_->is_complete()) {
        folder.state_ = State::All;
        return taken;
    }
    if (options.resume && is_this(unfinished.value())) {
        if (!reuses_same_run(*unfinished.value(), manifest)) {
            return folder.give_up(reuses_other(dir, *unfinished.value()));
        }
        folder.state_ = State::Some;
        folder.unfinished_ = std::move(unfinished.value());
        folder.recover_files();
        return taken;
    }
    CD_TRY(folder.begin(manifest));
    return taken;
}

Result<RunFolder> RunFolder::open_finished(const fs::path& dir, const RunManifest& expected) {
    auto taken = CD_TRY(take(dir));
    const auto manifest = read_run_json(dir / manifest_name);
    if (!manifest || manifest_json(manifest.value()) != manifest_json(expected)) {
        return taken.give_up(
            {ErrorCode::BadInput,
             dir.string() + " was changed by another process; repeat the command"});
    }
    taken.before_ = expected;
    taken.state_ = State::All;
    return taken;
}

Result<RunFolder> RunFolder::take(const fs::path& dir) {
    constexpr int attempts_max = 8;
    for (int attempt = 0; attempt < attempts_max; ++attempt) {
        CD_TRY(make_directories(dir / ".part"));
        auto lock = CD_TRY(DiskFile::lock(dir / ".part" / "lock"));
        // The process that held the lock before may have removed the locked file; then a new file
        // is locked.
        if (lock.has_its_name()) {
            return RunFolder(dir, std::move(lock));
        }
    }
    return Error{ErrorCode::Io, (dir / ".part").string() + " is in use by other processes"};
}

Error RunFolder::give_up(Error error) {
    std::error_code ignored;
    fs::remove(lock_.path(), ignored);
    fs::remove(part_, ignored); // Fails unless the folder is empty.
    return error;
}

/// Empties `.part` except for the lock.
Status RunFolder::begin(const RunManifest& manifest) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(part_, error)) {
        if (entry.path().filename() != "lock") {
            fs::remove_all(entry.path(), error);
        }
    }
    return write_file(part_ / manifest_name, manifest_json(manifest));
}

/// Moves back into `.part` the files that a run had moved when it was killed in `commit`.
void RunFolder::recover_files() {
    constexpr std::array<std::array<const char*, 2>, 3> moved{
        {{"records", "records"}, {"maps", "maps"}, {"scenarios", "inputs/scenarios"}}};
    std::error_code error;
    for (const auto& [name, last] : moved) {
        for (const fs::path& folder : {out(), dir_}) {
            const bool is_ours = folder != dir_ || !before_;
            if (is_ours && !fs::exists(part_ / name, error)) {
                fs::rename(folder / last, part_ / name, error);
            }
        }
    }
}

Result<std::vector<ManifestFile>> RunFolder::move_files() {
    std::vector<ManifestFile> files;
    for (const std::string& name : files_below(out())) {
        std::error_code error;
        fs::create_directories((dir_ / name).parent_path(), error);
        files.push_back({name, fs::file_size(out() / name, error)});
        fs::rename(out() / name, dir_ / name, error);
        if (error) {
            return failure(dir_ / name, error);
        }
    }
    return files;
}

Status RunFolder::commit(RunManifest manifest) {
    const std::vector<std::string> news = files_below(out());
    const auto is_new = [&](const std::string& name) {
        return std::ranges::binary_search(news, name) || name == "records";
    };
    std::error_code error;
    fs::remove(dir_ / manifest_name, error);
    if (before_) {
        for (const ManifestFile& file : before_->files) {
            if (is_inside(file.name) && !is_new(file.name)) {
                remove_listed(dir_, file.name);
            }
        }
    } else {
        for (const char* name : result_names) {
            if (fs::is_regular_file(dir_ / name, error)) {
                remove_listed(dir_, name);
            }
        }
    }
    auto files = CD_TRY(move_files());
    manifest.files = std::move(files);
    manifest.files.push_back({"records", fs::file_size(part_ / "records", error)});
    fs::rename(part_ / "records", dir_ / "records", error);
    if (error) {
        return failure(dir_ / "records", error);
    }
    CD_TRY(write_file(dir_ / manifest_name, manifest_json(manifest)));
    clean();
    return Done{};
}

Status RunFolder::add_files(std::span<const std::string> formats) {
    RunManifest manifest = *before_;
    auto files = CD_TRY(move_files());
    for (const ManifestFile& file : files) {
        std::erase_if(manifest.files,
                      [&](const ManifestFile& old) { return old.name == file.name; });
        manifest.files.push_back(file);
    }
    for (const std::string& format : formats) {
        if (std::ranges::find(manifest.formats, format) == manifest.formats.end()) {
            manifest.formats.push_back(format);
        }
    }
    CD_TRY(write_file(dir_ / manifest_name, manifest_json(manifest)));
    clean();
    return Done{};
}

void RunFolder::clean() {
    std::error_code error;
    fs::remove_all(part_, error);
}

} // namespace cd
