#include "client/folder/folder_run.hpp"
#include "client/folder/opened_run.hpp"
#include "client/job/prepared_job.hpp"
#include "client/local/local_report.hpp"
#include "client/local/local_run.hpp"
#include "client/spec/job_file.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/job/poses/poses_hash.hpp"
#include "library/call_clock.hpp"
#include "library/errors.hpp"
#include "library/kept_run.hpp"
#include "library/result_arrays.hpp"

#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace cdcluster {

/// The description of a job, or the folder of a run that is run again.
struct Job::State {
    cd::JobSpec spec;
    std::filesystem::path folder; ///< Empty: the job is described by its file alone.
};

namespace {

/// Passes the results in a folder on.
Results read_folder(const std::filesystem::path& folder,
                    const std::function<void(Results&&)>& each_window) {
    const cd::OpenedRun run = value_of(cd::OpenedRun::open(folder));
    const auto meshes = value_of(run.meshes());
    const cd::ExportContext context = value_of(cd::export_context(run));
    ResultArrays results(each_window, names_of(context));
    results.number_steps(context);
    check(run.records().for_each([&](const cd::RecordView& record) -> cd::Status {
        results.add(record.result, {});
        return cd::Done{};
    }));
    return results.finish(
        run.manifest().outcome.digest, triangles_of(meshes), value_of(run.kept_map()));
}

cd::PreparedJob prepare(const Job::State& job,
                        const RunOptions& options,
                        cd::ThreadPool& pool,
                        cd::Trees trees = cd::Trees::Always) {
    cd::TreeCache cache(options.tree_cache);
    if (job.folder.empty()) {
        cd::JobSpec spec = job.spec;
        if (!options.out.empty()) {
            spec.output.dir = options.out;
        }
        return value_of(cd::prepare_job(std::move(spec), trees, cache, pool));
    }
    const cd::OpenedRun run = value_of(cd::OpenedRun::open(job.folder));
    cd::JobSpec spec = value_of(run.spec());
    spec.output.dir = options.out;
    return value_of(cd::prepare_again(
        run.manifest(), value_of(cd::read_inputs(run)), std::move(spec), trees, cache, pool));
}

/// A prepared job that runs, and the call that waits for it.
class JobRun {
  public:
    JobRun(cd::PreparedJob& job, cd::ThreadPool& pool, const RunOptions& options)
        : job_(job), pool_(pool), clock_(options.progress) {}

    /// Passes all results on. Keeps their records in `kept` unless it is null.
    Results run(const std::function<void(Results&&)>& each_window, KeptAnswers* kept) {
        const cd::ExportContext context = cd::export_context(job_);
        ResultArrays results(each_window, names_of(context));
        results.number_steps(context);
        if (job_.query.maps) {
            results.count_maps(cd::body_part_runs(*job_.meshes[0], *job_.meshes[1]));
        }
        const cd::RunOutcome outcome = value_of(run_all({}, [&](const cd::DoneBlock& block) {
            if (kept != nullptr) {
                const auto records = block.records();
                kept->records.insert(kept->records.end(), records.begin(), records.end());
            }
            return block.for_each([&](const cd::DoneScenario& done) -> cd::Status {
                results.add(done.result, done.found);
                return cd::Done{};
            });
        }));
        const std::optional<cd::ContactMap> map = results.take_map();
        if (kept != nullptr) {
            kept->map = map;
            kept->seconds = outcome.seconds;
            kept->threads = pool_.size();
            kept->statistics = outcome.statistics;
        }
        return results.finish(outcome.digest, triangles_of(job_.meshes), map);
    }

    /// Runs into the job's folder, from where an interrupted run left off.
    void run_into_folder() {
        cd::FolderRunOptions options;
        options.where.threads = pool_.size();
        options.where.simd = cd::to_text(cd::simd_target());
        options.command = "library";
        auto folder = value_of(cd::FolderRun::begin(job_, std::move(options)));
        if (folder.is_complete()) {
            return;
        }
        const auto outcome =
            run_all(value_of(folder.done()),
                    [&](const cd::DoneBlock& block) -> cd::Status { return folder.add(block); });
        if (!outcome) {
            check(folder.keep());
            throw_error(outcome.error());
        }
        cd::RunReport report = cd::report_of(outcome.value(), job_.query, pool_.size());
        check(folder.finish(report, "text", std::nullopt));
    }

  private:
    cd::Result<cd::RunOutcome> run_all(std::optional<cd::ResultMerger> done,
                                       std::function<cd::Status(const cd::DoneBlock&)> take) {
        const cd::RunObserver observer{
            std::move(take),
            [&](const cd::Summary& summary, double) { clock_.tell(summary); },
            [&] { return clock_.was_stopped(); }};
        cd::LocalRunOptions options;
        options.done = std::move(done);
        options.scene = cd::scene_head(job_);
        clock_.restart();
        return cd::run_locally(
            cd::TreesByBody(job_.trees), *job_.poses, job_.query, pool_, observer, options);
    }

    cd::PreparedJob& job_;
    cd::ThreadPool& pool_;
    CallClock clock_;
};

/// Returns the hashes of a job's meshes.
std::vector<cd::Sha256> hashes_of(const cd::PreparedJob& job) {
    std::vector<cd::Sha256> hashes;
    for (const auto& mesh : job.meshes) {
        hashes.push_back(mesh->hash());
    }
    return hashes;
}

/// Returns the hash of a job's poses if they come from a file; other poses follow from the job's
/// description and its meshes.
std::optional<cd::Sha256> file_poses_hash(const cd::PreparedJob& job) {
    const bool has_file = job.scene || std::holds_alternative<cd::PoseFileSpec>(job.spec.poses);
    return has_file ? std::optional(value_of(cd::hash_of(*job.poses))) : std::nullopt;
}

} // namespace

Job Job::from_toml(std::string_view text, const std::filesystem::path& folder) {
    return Job(std::make_shared<const State>(
        State{value_of(cd::parse_job(text, folder / "job.toml")), {}}));
}

Job Job::from_file(const std::filesystem::path& file) {
    return Job(std::make_shared<const State>(State{value_of(cd::read_job_file(file)), {}}));
}

Job Job::from_folder(const std::filesystem::path& folder) {
    const cd::OpenedRun run = value_of(cd::OpenedRun::open(folder));
    return Job(std::make_shared<const State>(State{value_of(run.spec()), folder}));
}

Job::Job(std::shared_ptr<const State> state) : state_(std::move(state)) {}
Job::Job(const Job&) = default;
Job::Job(Job&&) noexcept = default;
Job& Job::operator=(const Job&) = default;
Job& Job::operator=(Job&&) noexcept = default;
Job::~Job() = default;

std::string Job::name() const {
    return state_->spec.name;
}

Results run(const Job& job, const RunOptions& options) {
    return run(job, options, {});
}

Results
run(const Job& job, const RunOptions& options, const std::function<void(Results&&)>& each_window) {
    cd::ThreadPool pool(options.threads);
    cd::PreparedJob prepared = prepare(*job.state(), options, pool);
    JobRun running(prepared, pool, options);
    if (prepared.spec.output.dir.empty()) {
        return running.run(each_window, nullptr);
    }
    const std::filesystem::path folder = prepared.spec.output.dir;
    running.run_into_folder();
    return read_folder(folder, each_window);
}

Results run_and_keep(const Job& job, const RunOptions& options, KeptRun& kept) {
    cd::ThreadPool pool(options.threads);
    cd::PreparedJob prepared = prepare(*job.state(), options, pool);
    kept.folder = prepared.spec.output.dir;
    JobRun running(prepared, pool, options);
    if (!kept.folder.empty()) {
        running.run_into_folder();
        return read_folder(kept.folder, {});
    }
    kept.meshes = hashes_of(prepared);
    kept.poses = file_poses_hash(prepared);
    return running.run({}, &kept.answers);
}

cd::PreparedJob
prepare_to_submit(const Job& job, const std::filesystem::path& tree_cache, cd::ThreadPool& pool) {
    RunOptions options;
    options.tree_cache = tree_cache;
    return prepare(*job.state(), options, pool, cd::Trees::ForPosesOnly);
}

void save_run(const Job& job,
              const KeptRun& kept,
              const std::filesystem::path& folder,
              bool overwrite) {
    cd::ThreadPool pool;
    RunOptions options;
    options.out = folder;
    cd::PreparedJob prepared = prepare(*job.state(), options, pool, cd::Trees::ForPosesOnly);
    if (hashes_of(prepared) != kept.meshes || file_poses_hash(prepared) != kept.poses) {
        throw Error(ErrorCode::BadInput,
                    "a mesh or pose file of the job has changed since it ran; run it again");
    }
    save_answers(prepared, kept.answers, overwrite);
}

Results open(const std::filesystem::path& folder) {
    return read_folder(folder, {});
}

} // namespace cdcluster
