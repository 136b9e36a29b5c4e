// Compares our engine and every installed peer on the same poses and meshes, in turns. See
// README.md.
#include "bench/accuracy/machine.hpp"
#include "bench/floor_kernels.hpp"
#include "bench/peers/contest.hpp"
#include "bench/peers/engines/peers.hpp"
#include "bench/peers/ours.hpp"
#include "bench/peers/room.hpp"
#include "bench/peers/scenes.hpp"
#include "bench/peers/tables.hpp"
#include "bench/peers/threads.hpp"

#include <CLI/CLI.hpp>
#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path out = "peers";
    SceneOptions scenes;
    ContestOptions contest;
    unsigned limit_seconds = 300;
    double thread_seconds = 0.5;
    std::string only;
    std::string peers;
};

/// Returns the engines for scaling: the fastest of each kind.
std::vector<Engine> scaling_engines(const std::vector<Engine>& all) {
    std::vector<Engine> engines;
    std::copy_if(all.begin(), all.end(), std::back_inserter(engines), [](const Engine& engine) {
        return engine.name == "cdcluster" || engine.name.starts_with("FCL OBB ") ||
               engine.name.starts_with("Embree");
    });
    return engines;
}

/// Returns the last processor that this process may use: the first one does more system work.
int last_cpu() {
    cpu_set_t set;
    int last = -1;
    if (::sched_getaffinity(0, sizeof set, &set) == 0) {
        for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
            last = CPU_ISSET(static_cast<std::size_t>(cpu), &set) ? cpu : last;
        }
    }
    return last;
}

void write_floor(const std::filesystem::path& folder) {
    CsvFile csv(folder / "floor.csv", {"kernel", "ns"});
    const FloorTimes times = measure_floor();
    csv.row({"boxes", cell(times.box_ns)});
    csv.row({"sides", cell(times.side_ns)});
    csv.row({"decision", cell(times.decision_ns)});
}

void run(const Options& options) {
    std::filesystem::create_directories(options.out);
    std::vector<Engine> engines = our_mesh_engines();
    write_machine(options.out, add_peers(engines));
    std::erase_if(engines, [&](const Engine& engine) {
        return !engine.make_meshes ||
               (!engine.is_ours && engine.name.find(options.peers) == std::string::npos);
    });
    const std::vector<Engine> scaling = scaling_engines(engines);
    write_floor(options.out);
    Room room;
    Tables tables(options.out);
    CsvFile threads = open_threads_csv(options.out);
    CsvFile builds = open_builds_csv(options.out);
    const ThreadOptions thread_options{
        options.contest.rounds, options.thread_seconds, options.contest.limit};
    for (const SceneSource& source : scene_sources(options.scenes)) {
        if (source.name.find(options.only) == std::string::npos) {
            continue;
        }
        std::printf("%s: %s\n", source.suite.c_str(), source.name.c_str());
        std::fflush(stdout);
        const auto scene = source.load();
        if (!scene) {
            continue;
        }
        const Reference reference(*scene, engines.front(), options.contest.limit);
        const std::uint64_t triangles = scene->a->triangles().size() + scene->b->triangles().size();
        const std::vector<Engine> taking_part =
            room.fitting(source.suite == "scenes" ? engines : scaling, triangles);
        const auto outcomes = run_contest(*scene, reference, taking_part, options.contest);
        room.learn(outcomes, triangles);
        tables.add(source, *scene, reference, outcomes);
        run_threads(source.suite, *scene, engines.front(), thread_options, threads);
        if (source.name == "motorbike x motorbike") {
            run_builds("motorbike", scene->a, thread_options, builds);
        }
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.scenes.models = CD_MESHES;
    options.contest.cpu = cd::bench::last_cpu();
    CLI::App app("Compares our engine with those of others");
    app.add_option("--out", options.out, "Folder for the CSV files");
    app.add_option("--models", options.scenes.models, "Folder of the mesh files");
    app.add_option("--scenarios",
                   options.scenes.scenarios,
                   "Folder of the pose files; by default `scenarios` beside that of the meshes");
    app.add_option("--only", options.only, "Scenes with this in their names");
    app.add_option("--peers", options.peers, "Peers with this in their names");
    app.add_option("--poses", options.scenes.poses, "Poses of a scene")
        ->check(CLI::Range(1, 100000));
    app.add_option("--scaling-poses", options.scenes.scaling_poses, "Poses of a scene of scaling")
        ->check(CLI::Range(1, 100000));
    app.add_option("--vehicle", options.scenes.vehicle_triangles, "Triangles of the truck");
    app.add_option("--size-max", options.scenes.size_max, "Triangles of the largest truck");
    app.add_option("--rounds", options.contest.rounds, "Rounds, of which the median is taken");
    app.add_option("--passes", options.contest.passes, "Passes for any contact; the best is taken");
    app.add_option("--budget", options.contest.budget_seconds, "Seconds of an engine's rounds");
    app.add_option(
        "--thread-seconds", options.thread_seconds, "Of a run that threads are timed by");
    app.add_option("--limit", options.limit_seconds, "Seconds for an engine on all poses");
    app.add_option("--judged", options.contest.judged_max, "Disagreements put to the oracle");
    app.add_option("--cpu", options.contest.cpu, "Processor for all engines; -1 is any");
    CLI11_PARSE(app, argc, argv);
    if (options.scenes.scenarios.empty()) {
        options.scenes.scenarios = options.scenes.models.parent_path() / "scenarios";
    }
    options.contest.limit = std::chrono::seconds(options.limit_seconds);
    try {
        cd::bench::run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
