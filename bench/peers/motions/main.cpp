// Compares when moving bodies meet by our engine and by others, on the same paths, in turns. See
// README.md of bench/peers.
#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/machine.hpp"
#include "bench/accuracy/timing.hpp"
#include "bench/peers/motions/contest.hpp"
#include "bench/peers/motions/motion_scenes.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>
#include <set>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path out = "motions";
    MotionSceneOptions scenes;
    MotionContestOptions contest;
    unsigned limit_seconds = 20;
};

std::vector<MotionEngine> all_engines([[maybe_unused]] std::vector<std::string>& missing) {
    std::vector<MotionEngine> engines;
    engines.push_back(our_motions());
#ifdef CD_PEER_FCL
    add_fcl_motions(engines);
#else
    missing.emplace_back("FCL");
    std::fprintf(stderr, "MISSING: FCL was not installed at build time: no rows\n");
#endif
#ifdef CD_PEER_BULLET
    add_bullet_motions(engines);
#else
    missing.emplace_back("Bullet");
    std::fprintf(stderr, "MISSING: Bullet was not installed at build time: no rows\n");
#endif
    return engines;
}

/// Returns the mean and the median in milliseconds of the paths that ended.
std::vector<std::string> cells_of_times(std::span<const PathOutcome> outcomes) {
    std::vector<double> times;
    for (const PathOutcome& outcome : outcomes) {
        if (outcome.seconds > 0) {
            times.push_back(1e3 * outcome.seconds);
        }
    }
    if (times.empty()) {
        return {"", ""};
    }
    const double sum = std::accumulate(times.begin(), times.end(), 0.0);
    return {cell(sum / static_cast<double>(times.size())), cell(median(times))};
}

/// Returns how far outside of the bracket the times are, in lengths of the path: the median of the
/// amounts, the earliest and the latest.
std::vector<std::string> cells_of_errors(const std::vector<double>& shares, double length) {
    if (shares.empty()) {
        return {"", "", ""};
    }
    std::vector<double> amounts;
    for (const double share : shares) {
        amounts.push_back(std::abs(share) * length);
    }
    const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
    return {cell(median(amounts)), cell(*least * length), cell(*most * length)};
}

/// Returns the outcomes of the paths of one kind.
std::vector<PathOutcome> of_kind(const std::vector<PathOutcome>& outcomes,
                                 const MotionScene& scene,
                                 const std::string& kind) {
    std::vector<PathOutcome> kept;
    for (std::size_t p = 0; p < outcomes.size(); ++p) {
        if (scene.paths[p].kind == kind) {
            kept.push_back(outcomes[p]);
        }
    }
    return kept;
}

std::uint64_t count_of(std::span<const PathOutcome> outcomes, Impact::Kind kind) {
    return static_cast<std::uint64_t>(
        std::count_if(outcomes.begin(), outcomes.end(), [&](const PathOutcome& outcome) {
            return outcome.impact.kind == kind;
        }));
}

std::uint64_t tried_of(std::span<const PathOutcome> outcomes) {
    return static_cast<std::uint64_t>(std::ranges::count(outcomes, true, &PathOutcome::is_tried));
}

void add_scene(const MotionScene& scene,
               std::span<const MotionEngine> engines,
               const MotionContestOptions& options,
               CsvFile& csv) {
    std::printf("%s: %zu paths\n", scene.name.c_str(), scene.paths.size());
    std::fflush(stdout);
    const auto outcomes = run_motion_contest(scene, engines, options);
    std::set<std::string> kinds;
    for (const KeyedPath& path : scene.paths) {
        kinds.insert(path.kind);
    }
    for (const std::string& kind : kinds) {
        const std::vector<PathOutcome> ours = of_kind(outcomes.front(), scene, kind);
        for (std::size_t i = 0; i < engines.size(); ++i) {
            const std::vector<PathOutcome> theirs = of_kind(outcomes[i], scene, kind);
            const ImpactErrors errors = compare_impacts(ours, theirs);
            std::vector<std::string> row{scene.name,
                                         kind,
                                         engines[i].name,
                                         cell(tried_of(theirs)),
                                         cell(count_of(theirs, Impact::Kind::Found)),
                                         cell(count_of(theirs, Impact::Kind::Undecided)),
                                         cell(errors.unanswered),
                                         cell(errors.missed),
                                         cell(errors.invented)};
            for (const auto& cells :
                 {cells_of_times(theirs), cells_of_errors(errors.shares_off, scene.length)}) {
                row.insert(row.end(), cells.begin(), cells.end());
            }
            csv.row(row);
        }
    }
}

void run(const Options& options) {
    std::filesystem::create_directories(options.out);
    std::vector<std::string> missing;
    const std::vector<MotionEngine> engines = all_engines(missing);
    write_machine(options.out, missing);
    CsvFile csv(options.out / "motions.csv",
                {"scene",
                 "kind",
                 "engine",
                 "paths",
                 "impacts",
                 "undecided",
                 "unanswered",
                 "missed",
                 "invented",
                 "mean_ms",
                 "median_ms",
                 "off_median",
                 "off_early",
                 "off_late"});
    for (const MotionScene& scene : motion_scenes(options.scenes)) {
        add_scene(scene, engines, options.contest, csv);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.scenes.scenes.models = CD_MESHES;
    CLI::App app("Compares motions of our engine with those of others");
    app.add_option("--out", options.out, "Folder for the CSV files");
    app.add_option("--models", options.scenes.scenes.models, "Folder of the mesh files");
    app.add_option("--scenarios",
                   options.scenes.scenes.scenarios,
                   "Folder of the pose files; by default `scenarios` beside that of the meshes");
    app.add_option("--only", options.scenes.only, "Scenes with this in their names");
    app.add_option("--poses", options.scenes.scenes.poses, "Poses of a scene")
        ->check(CLI::Range(1, 1000));
    app.add_option("--rounds", options.contest.rounds, "Rounds, of which the median is taken")
        ->check(CLI::Range(1, 100));
    app.add_option("--limit", options.limit_seconds, "Seconds for an engine on a path");
    app.add_option("--budget", options.contest.budget_seconds, "Seconds of an engine in a scene");
    app.add_option("--cpu", options.contest.cpu, "Processor for all engines; -1 is any");
    CLI11_PARSE(app, argc, argv);
    if (options.scenes.scenes.scenarios.empty()) {
        options.scenes.scenes.scenarios = options.scenes.scenes.models.parent_path() / "scenarios";
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
