#include "master/check_state.hpp"

#include "common/core/files/disk_file.hpp"
#include "master/geometry/blocks_file.hpp"
#include "master/geometry/mesh_file.hpp"
#include "master/identity/identity.hpp"
#include "master/journal/journal_database.hpp"
#include "master/journal/journal_groups.hpp"
#include "master/submission/label_spool.hpp"
#include "master/submission/pose_spool.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace cd {

namespace {

class Check {
  public:
    explicit Check(const std::filesystem::path& directory) : directory_(directory) {}

    StateReport run() {
        std::error_code ignored;
        if (!std::filesystem::is_directory(directory_, ignored)) {
            problem(directory_.string() + " is no directory");
            return std::move(report_);
        }
        // The lock is held until the end, so that no master starts meanwhile. A folder without a
        // lock file was never used.
        const Result<DiskFile> lock = DiskFile::lock_existing(directory_ / "lock");
        if (!lock && lock.error().code != ErrorCode::NotFound) {
            problem(lock.error().detail);
            return std::move(report_);
        }
        if (is_unused()) {
            report_.lines.push_back("there is no state yet");
        } else {
            check_journal();
            check_meshes();
            check_blocks();
        }
        note(MasterIdentity::check(directory_));
        report_.lines.push_back(report_.is_sound ? "the state is sound"
                                                 : "the state is damaged; nothing was changed");
        return std::move(report_);
    }

  private:
    void problem(const std::string& text) {
        report_.is_sound = false;
        report_.lines.push_back("PROBLEM: " + text);
    }
    void note(const Status& status) {
        if (!status) {
            problem(status.error().detail);
        }
    }

    /// Returns true if no master has kept anything here yet, besides an identity.
    [[nodiscard]] bool is_unused() const {
        constexpr std::array<std::string_view, 4> before_use{
            "identity", "identity.new", "refused", "lock"};
        std::error_code ignored;
        const std::filesystem::directory_iterator files(directory_, ignored);
        return std::all_of(begin(files), end(files), [&](const auto& file) {
            return std::ranges::find(before_use, file.path().filename()) != before_use.end();
        });
    }

    void check_journal() {
        const std::filesystem::path folder = directory_ / "jobs";
        const auto journal = JournalDatabase::open(
            directory_, {.synced = true, .create = false, .owned = file_of_a_job(folder)});
        if (!journal) {
            return problem(journal.error().detail);
        }
        const ExaminedJobs examined = examine_jobs(*journal.value(), folder);
        for (const Error& damage : examined.damage) {
            problem(damage.detail);
        }
        std::uint64_t running = 0;
        std::uint64_t results = 0;
        for (const RecoveredJob& job : examined.jobs) {
            results += job.results == nullptr ? 0 : job.results->count();
            running += job.end ? 0 : 1;
            // An ended job may lack its poses: then only queries for the poses fail.
            const auto poses = folder / (std::to_string(job.record.id.value) + ".poses");
            if (!job.end || std::filesystem::exists(poses)) {
                check_poses(job.record, poses);
            }
            const auto labels = folder / (std::to_string(job.record.id.value) + ".labels");
            if (!job.end || std::filesystem::exists(labels)) {
                check_labels(job.record.submit, labels);
            }
            if (!job.end) {
                check_bodies(job.record);
            }
        }
        report_.lines.push_back("journal: " + std::to_string(examined.jobs.size()) + " jobs, " +
                                std::to_string(running) + " of them unfinished, " +
                                std::to_string(results) + " results");
        const Result<AlarmRecord> alarms = recover_alarms(*journal.value());
        if (!alarms) {
            return problem(alarms.error().detail);
        }
        report_.lines.push_back(
            "alarms: " + std::to_string(alarms.value().count) +
            ", quarantined workers: " + std::to_string(alarms.value().quarantined.size()));
    }

    void check_poses(const JobRecord& job, const std::filesystem::path& path) {
        if (job.submit.grid) {
            return;
        }
        const auto spool = PoseSpool::open(path, announced_by(job.submit));
        note(spool ? spool.value()->verify() : Status(spool.error()));
    }

    void check_labels(const Submit& submit, const std::filesystem::path& path) {
        if (submit.poses.labels.is_empty()) {
            return;
        }
        const auto spool = LabelSpool::open(path, submit.poses.labels, submit.scenarios);
        note(spool ? spool.value()->verify() : Status(spool.error()));
    }

    /// Checks that an unfinished job's meshes are stored; without them the job waits.
    void check_bodies(const JobRecord& job) {
        std::set<Sha256> meshes;
        for (const JobBody& body : job.submit.bodies) {
            meshes.insert(body.mesh);
        }
        for (const Sha256& mesh : meshes) {
            const std::filesystem::path path = mesh_path(directory_, mesh);
            if (!std::filesystem::exists(path)) {
                problem(path.string() + " is missing: job " + std::to_string(job.id.value) +
                        " waits for it; restore it, or submit a job with the mesh again");
            }
        }
    }

    /// Returns the files of a folder whose names end in `suffix`, sorted by name.
    [[nodiscard]] std::vector<std::filesystem::path> files_of(const char* folder,
                                                              std::string_view suffix) const {
        std::vector<std::filesystem::path> paths;
        std::error_code ignored;
        for (const auto& file : std::filesystem::directory_iterator(directory_ / folder, ignored)) {
            if (file.path().extension() == suffix) {
                paths.push_back(file.path());
            }
        }
        std::sort(paths.begin(), paths.end());
        return paths;
    }

    void check_blocks() {
        const auto paths = files_of("blocks", blocks_suffix);
        for (const auto& path : paths) {
            note(check_blocks_file(path));
        }
        report_.lines.push_back("blocks: " + std::to_string(paths.size()));
    }

    void check_meshes() {
        const auto paths = files_of("meshes", mesh_suffix);
        for (const auto& path : paths) {
            const std::optional<Sha256> hash = sha256_from_hex(path.stem().string());
            if (!hash) {
                problem(path.string() + " is not named by a hash");
            } else if (const auto mesh = read_mesh(path, *hash); !mesh) {
                problem(mesh.error().detail);
            }
        }
        report_.lines.push_back("meshes: " + std::to_string(paths.size()));
    }

    const std::filesystem::path& directory_;
    StateReport report_;
};

} // namespace

StateReport check_state(const std::filesystem::path& directory) {
    return Check(directory).run();
}

} // namespace cd
