// Compares the distances of our engine and of every installed peer on the same poses and meshes, in
// turns, and on hard pairs of triangles. See README.md of bench/peers.
#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/machine.hpp"
#include "bench/accuracy/timing.hpp"
#include "bench/peers/distances/contest.hpp"
#include "bench/peers/distances/hard_pairs.hpp"
#include "bench/peers/distances/near_times.hpp"
#include "bench/peers/scenes.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>
#include <optional>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path out = "distances";
    SceneOptions scenes;
    DistanceContestOptions contest;
    std::uint64_t pairs = 1000;
    unsigned limit_seconds = 300;
    std::string only;
};

std::vector<DistanceEngine> all_engines([[maybe_unused]] std::vector<std::string>& missing) {
    std::vector<DistanceEngine> engines;
    engines.push_back(our_distances());
#ifdef CD_PEER_FCL
    add_fcl_distances(engines);
#else
    missing.emplace_back("FCL");
    std::fprintf(stderr, "MISSING: FCL was not installed at build time: no rows\n");
#endif
    return engines;
}

std::vector<std::string> cells_of(const DistanceErrors& errors) {
    return {cell(errors.unequal), cell(errors.off), cell(errors.wrong), cell(errors.worst)};
}

/// Returns the values in the poses of one kind: those in contact, or the others.
std::vector<double>
in_poses(const std::vector<double>& values, const DistanceOutcome& ours, bool in_contact) {
    std::vector<double> kept;
    for (std::size_t p = 0; p < values.size(); ++p) {
        if ((ours.found[p].distance == 0) == in_contact) {
            kept.push_back(values[p]);
        }
    }
    return kept;
}

/// Returns the mean and the median of the times in microseconds, and the median over the poses of
/// the ratio to ours.
std::vector<std::string> cells_of_times(const std::vector<double>& times,
                                        const std::vector<double>& ours) {
    if (times.empty()) {
        return {"", "", ""};
    }
    std::vector<double> ratios;
    for (std::size_t p = 0; p < times.size(); ++p) {
        ratios.push_back(times[p] / ours[p]);
    }
    const double sum = std::accumulate(times.begin(), times.end(), 0.0);
    return {cell(1e6 * sum / static_cast<double>(times.size())),
            cell(1e6 * median(times)),
            cell(median(ratios))};
}

void add_scene(const SceneSource& source,
               std::span<const DistanceEngine> engines,
               std::span<const DistanceOutcome> outcomes,
               CsvFile& csv) {
    const DistanceOutcome& ours = outcomes.front();
    for (const bool in_contact : {false, true}) {
        const std::vector<double> base = in_poses(ours.pose_seconds, ours, in_contact);
        for (std::size_t i = 0; i < engines.size() && !base.empty(); ++i) {
            const DistanceOutcome& outcome = outcomes[i];
            const DistanceErrors& errors = in_contact ? outcome.in_contact : outcome.apart;
            std::vector<std::string> row{source.name,
                                         in_contact ? "contact" : "apart",
                                         engines[i].name,
                                         std::string(to_text(outcome.ending)),
                                         cell(std::uint64_t{base.size()})};
            for (const auto& cells :
                 {cells_of_times(in_poses(outcome.pose_seconds, ours, in_contact), base),
                  cells_of(errors),
                  std::vector{cell(errors.ours_wrong)}}) {
                row.insert(row.end(), cells.begin(), cells.end());
            }
            csv.row(row);
        }
    }
}

/// The clearance of the scenes whose searches with a clearance are timed, in metres.
constexpr double clearance = 0.01;
constexpr std::array near_scenes{"drivaer near sedan", "drivaer x sedan"};
/// Number of rounds in which searches with a clearance are timed: half before a scene's distances,
/// half after them, so that a short load of the machine disturbs only some.
constexpr std::size_t near_rounds = 100;

/// Files with the times of searches with a clearance.
struct NearFiles {
    CsvFile queries;
    CsvFile floats;

    explicit NearFiles(const std::filesystem::path& folder)
        : queries(folder / "near_queries.csv",
                  {"scene", "poses", "rounds", "quickest_round_us", "median_round_us"}),
          floats(folder / "near_floats.csv",
                 {"scene", "target", "candidates", "unknown", "candidate_ns"}) {}

    void add(const Scene& scene, const NearQueries& times, std::size_t rounds) {
        queries.row({scene.name,
                     cell(std::uint64_t{scene.poses.size()}),
                     cell(std::uint64_t{times.rounds()}),
                     cell(1e6 * times.quickest_round()),
                     cell(1e6 * times.median_round())});
        for (const NearFloats& row : measure_near_floats(scene, clearance, rounds)) {
            floats.row({scene.name,
                        row.target,
                        cell(row.candidates),
                        cell(row.unknown),
                        cell(row.candidate_ns)});
        }
    }
};

void run(const Options& options) {
    std::filesystem::create_directories(options.out);
    std::vector<std::string> missing;
    const std::vector<DistanceEngine> engines = all_engines(missing);
    write_machine(options.out, missing);
    CsvFile scenes(options.out / "distances.csv",
                   {"scene",
                    "poses_are",
                    "engine",
                    "ending",
                    "poses",
                    "mean_us",
                    "median_us",
                    "ratio",
                    "unequal",
                    "off",
                    "wrong",
                    "worst",
                    "ours_wrong"});
    NearFiles near(options.out);
    for (const SceneSource& source : scene_sources(options.scenes)) {
        if (source.suite != "scenes" || source.name.find(options.only) == std::string::npos) {
            continue;
        }
        std::printf("%s\n", source.name.c_str());
        std::fflush(stdout);
        if (const auto scene = source.load()) {
            std::optional<NearQueries> queries;
            if (std::ranges::count(near_scenes, source.name) > 0) {
                queries.emplace(*scene, clearance).run(near_rounds / 2);
            }
            add_scene(
                source, engines, run_distance_contest(*scene, engines, options.contest), scenes);
            if (queries) {
                queries->run(near_rounds / 2);
                near.add(*scene, *queries, options.contest.rounds);
            }
        }
    }
    CsvFile pairs(options.out / "pairs.csv",
                  {"kind", "engine", "pairs", "unequal", "off", "wrong", "worst"});
    for (const PairDistances& kind : measure_hard_pairs(engines, options.pairs)) {
        std::vector<std::string> row{kind.kind, kind.engine, cell(kind.pairs)};
        const std::vector<std::string> cells = cells_of(kind.errors);
        row.insert(row.end(), cells.begin(), cells.end());
        pairs.row(row);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.scenes.models = CD_MESHES;
    CLI::App app("Compares distances of our engine with those of others");
    app.add_option("--out", options.out, "Folder for the CSV files");
    app.add_option("--models", options.scenes.models, "Folder of the mesh files");
    app.add_option("--scenarios",
                   options.scenes.scenarios,
                   "Folder of the pose files; by default `scenarios` beside that of the meshes");
    app.add_option("--only", options.only, "Scenes with this in their names");
    app.add_option("--poses", options.scenes.poses, "Poses of a scene")
        ->check(CLI::Range(1, 100000));
    app.add_option("--vehicle", options.scenes.vehicle_triangles, "Triangles of the truck");
    app.add_option("--rounds", options.contest.rounds, "Rounds, of which the median is taken")
        ->check(CLI::Range(1, 100));
    app.add_option("--pairs", options.pairs, "Hard pairs of each kind");
    app.add_option("--limit", options.limit_seconds, "Seconds for an engine on all poses");
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
