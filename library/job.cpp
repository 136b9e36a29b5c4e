#include "client/folder/folder_run.hpp"
#include "client/folder/opened_run.hpp"
#include "client/job/prepared_job.hpp"
#include "client/local/local_run.hpp"
#include "client/spec/job_file.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/words.hpp"
#include "common/geometry/simd_target.hpp"
#include "library/call_clock.hpp"
#include "library/errors.hpp"
#include "library/result_arrays.hpp"

#include <optional>
#include <utility>

namespace cdcluster {

/// The description of a job, or the folder of a run that is run again.
struct Job::State {
    cd::JobSpec spec;
    std::filesystem::path folder; ///< Empty: the job is described by its file alone.
};

namespace {

/// Returns the numbers of triangles of A and of B. Scenes, which may have more, have no maps.
std::array<std::size_t, 2>
triangles_of(const std::vector<std::shared_ptr<const cd::Mesh>>& meshes) {
    return {meshes.at(0)->triangles().size(), meshes.at(1)->triangles().size()};
}

std::vector<std::string> names_of(const cd::ExportContext& context) {
    std::vector<std::string> names;
    for (const cd::ExportBody& body : context.bodies) {
        names.push_back(body.name);
    }
    return names;
}

/// Passes the results in a folder on.
Results read_folder(const std::filesystem::path& folder,
                    const std::function<void(Results&&)>& each_window) {
    const cd::OpenedRun run = value_of(cd::OpenedRun::open(folder));
    const auto meshes = value_of(run.meshes());
    const cd::ExportContext context = value_of(cd::export_context(run));
    ResultArrays results(each_window, names_of(context));
    results.number_steps(context.steps);
    check(run.records().for_each([&](const cd::KeptRecord& record) -> cd::Status {
        results.add(record.result, {});
        return cd::Done{};
    }));
    return results.finish(
        run.manifest().outcome.digest, triangles_of(meshes), value_of(run.kept_map()));
}

cd::PreparedJob prepare(const Job::State& job, const RunOptions& options, cd::ThreadPool& pool) {
    cd::TreeCache cache(options.tree_cache);
    if (job.folder.empty()) {
        cd::JobSpec spec = job.spec;
        if (!options.out.empty()) {
            spec.output.dir = options.out;
        }
        return value_of(cd::prepare_job(std::move(spec), cd::Trees::Always, cache, pool));
    }
    const cd::OpenedRun run = value_of(cd::OpenedRun::open(job.folder));
    cd::JobSpec spec = value_of(run.spec());
    spec.output.dir = options.out;
    return value_of(cd::prepare_again(run.manifest(),
                                      value_of(cd::read_inputs(run)),
                                      std::move(spec),
                                      cd::Trees::Always,
                                      cache,
                                      pool));
}

/// A prepared job that runs, and the call that waits for it.
class JobRun {
  public:
    JobRun(cd::PreparedJob& job, cd::ThreadPool& pool, const RunOptions& options)
        : job_(job), pool_(pool), clock_(options.progress) {}

    /// Passes all results on and keeps none.
    Results run(const std::function<void(Results&&)>& each_window) {
        const cd::ExportContext context = cd::export_context(job_);
        ResultArrays results(each_window, names_of(context));
        results.number_steps(context.steps);
        if (job_.query.maps) {
            results.count_maps();
        }
        const cd::RunOutcome outcome = value_of(run_all({}, [&](const cd::DoneBlock& block) {
            return block.for_each([&](const cd::DoneScenario& done) -> cd::Status {
                results.add(done.result, done.found);
                return cd::Done{};
            });
        }));
        return results.finish(outcome.digest, triangles_of(job_.meshes));
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
        cd::RunReport report;
        report.summary = outcome.value().summary;
        report.query = job_.query;
        report.digest = outcome.value().digest;
        report.execution.seconds = outcome.value().seconds;
        report.execution.statistics = outcome.value().statistics;
        report.execution.cost = outcome.value().cost;
        report.execution.where = cd::counted(pool_.size(), "thread");
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
        return running.run(each_window);
    }
    const std::filesystem::path folder = prepared.spec.output.dir;
    running.run_into_folder();
    return read_folder(folder, each_window);
}

Results open(const std::filesystem::path& folder) {
    return read_folder(folder, {});
}

} // namespace cdcluster
