// Compares the broad phase of scenes of many moving bodies, ours and others, in turns. See
// README.md of bench/peers.
#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/machine.hpp"
#include "bench/accuracy/timing.hpp"
#include "bench/peers/scenes/contest.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path out = "scenes";
    std::vector<std::size_t> bodies{100, 1000, 10000};
    std::size_t steps = 20;
    SweepContestOptions contest;
    unsigned limit_seconds = 120;
};

std::vector<SweepEngine> all_engines([[maybe_unused]] std::vector<std::string>& missing) {
    std::vector<SweepEngine> engines;
    engines.push_back(our_sweep());
#ifdef CD_PEER_FCL
    add_fcl_sweeps(engines);
#else
    missing.emplace_back("FCL");
    std::fprintf(stderr, "MISSING: FCL was not installed at build time: no rows\n");
#endif
#ifdef CD_PEER_BULLET
    add_bullet_sweeps(engines);
#else
    missing.emplace_back("Bullet");
    std::fprintf(stderr, "MISSING: Bullet was not installed at build time: no rows\n");
#endif
    return engines;
}

/// Cars move by up to 1 m a step, and parts by up to a centimetre, which also turn.
CrowdScene scene_of(const std::string& name, std::size_t bodies, std::size_t steps) {
    CrowdScene scene{name, name == "town" ? make_town(bodies) : make_assembly(bodies), {}};
    scene.steps = name == "town" ? moving_poses(scene.boxes, steps, Vec3(1, 1, 0), 0.01)
                                 : moving_poses(scene.boxes, steps, Vec3(0.01, 0.01, 0.01), 0.05);
    return scene;
}

void add_scene(const CrowdScene& scene,
               std::span<const SweepEngine> engines,
               const SweepContestOptions& options,
               CsvFile& csv) {
    std::printf("%s: %zu bodies\n", scene.name.c_str(), scene.boxes.size());
    std::fflush(stdout);
    const auto outcomes = run_sweep_contest(scene, engines, options);
    const double ours = median(outcomes.front().step_seconds);
    for (std::size_t i = 0; i < engines.size(); ++i) {
        const std::vector<double>& seconds = outcomes[i].step_seconds;
        const auto steps = static_cast<double>(scene.steps.size());
        const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
        csv.row({scene.name,
                 cell(std::uint64_t{scene.boxes.size()}),
                 engines[i].name,
                 std::string(to_text(outcomes[i].ending)),
                 cell(std::uint64_t{scene.steps.size()}),
                 seconds.empty() ? "" : cell(1e3 * sum / steps),
                 seconds.empty() ? "" : cell(1e3 * median(seconds)),
                 seconds.empty() ? "" : cell(median(seconds) / ours),
                 cell(static_cast<double>(outcomes[i].pairs) / steps),
                 cell(outcomes[i].missing)});
    }
}

void run(const Options& options) {
    std::filesystem::create_directories(options.out);
    std::vector<std::string> missing;
    const std::vector<SweepEngine> engines = all_engines(missing);
    write_machine(options.out, missing);
    CsvFile csv(options.out / "scenes.csv",
                {"scene",
                 "bodies",
                 "engine",
                 "ending",
                 "steps",
                 "mean_ms",
                 "median_ms",
                 "ratio",
                 "pairs",
                 "missing"});
    for (const char* const name : {"town", "assembly"}) {
        for (const std::size_t bodies : options.bodies) {
            add_scene(scene_of(name, bodies, options.steps), engines, options.contest, csv);
        }
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Compares the broad phase of scenes with that of others");
    app.add_option("--out", options.out, "Folder for the CSV files");
    app.add_option("--bodies", options.bodies, "Numbers of bodies")->check(CLI::Range(2, 65536));
    app.add_option("--steps", options.steps, "Steps of a scene")->check(CLI::Range(1, 1000));
    app.add_option("--rounds", options.contest.rounds, "Rounds, of which the median is taken")
        ->check(CLI::Range(1, 100));
    app.add_option("--limit", options.limit_seconds, "Seconds for an engine on all steps");
    app.add_option("--cpu", options.contest.cpu, "Processor for all engines; -1 is any");
    CLI11_PARSE(app, argc, argv);
    options.contest.limit = std::chrono::seconds(options.limit_seconds);
    try {
        cd::bench::run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
