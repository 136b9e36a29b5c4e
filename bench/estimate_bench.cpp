// Compares the time that `cdctl run --dry-run` estimates with that of the run: estimates a job at
// each level, runs it, and prints both.
//
//   estimate_bench MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 50]
//
// Prints a row per level: seconds of the estimate, its range, seconds of the run, and their ratio,
// which should lie between a half and two. Needs an idle machine: both are wall times.
#include "client/commands/estimate.hpp"

#include "bench/posed_trees.hpp"
#include "client/local/local_run.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

PreparedJob make_job(PosedTrees loaded, Level level) {
    PreparedJob job;
    std::vector<Scenario> scenarios(loaded.poses.size());
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses = loaded.poses[i];
    }
    job.meshes = {loaded.mesh_a, loaded.mesh_b};
    job.trees = {std::make_shared<const ObbTree>(std::move(loaded.a)),
                 std::make_shared<const ObbTree>(std::move(loaded.b))};
    job.query.level = level;
    job.poses = make_list_source(std::move(scenarios));
    return job;
}

bool print_row(const PreparedJob& job, ThreadPool& pool) {
    const auto estimate = estimate_run(job, pool, {});
    const RunObserver observer{[](const DoneScenario&) { return Status(Done{}); },
                               [](const Summary&, double) {},
                               [] { return false; }};
    const auto ran =
        run_locally(*job.trees[0], *job.trees[1], *job.poses, job.query, pool, observer);
    if (!estimate || !ran) {
        std::fprintf(stderr, "%s\n", (estimate ? ran.error() : estimate.error()).detail.c_str());
        return false;
    }
    std::printf("%-9s %9.3f %9.3f %9.3f %9.3f %6.2f\n",
                std::string(to_text(job.query.level)).c_str(),
                estimate.value().seconds,
                estimate.value().seconds_low,
                estimate.value().seconds_high,
                ran.value().seconds,
                estimate.value().seconds / ran.value().seconds);
    return true;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    CLI::App app("Holds the estimate of a run's time against the run");
    cd::bench::PosedTreesOptions options;
    options.add_to(app);
    CLI11_PARSE(app, argc, argv);
    cd::ThreadPool pool;
    std::printf("%-9s %9s %9s %9s %9s %6s\n", "level", "estimate", "low", "high", "run", "ratio");
    for (const cd::Level level :
         {cd::Level::Any, cd::Level::Count, cd::Level::Pairs, cd::Level::Contacts}) {
        auto loaded = cd::bench::load(options);
        if (!loaded ||
            !cd::bench::print_row(cd::bench::make_job(std::move(*loaded), level), pool)) {
            return 1;
        }
    }
    return 0;
}
