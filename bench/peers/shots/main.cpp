// Compares the shot lines of our engine and of Embree on the same meshes, in turns. See README.md
// of bench/peers.
#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/machine.hpp"
#include "bench/peers/shots/contest.hpp"
#include "bench/peers/shots/shot_scenes.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path out = "shots";
    ShotSceneOptions scenes;
    ShotContestOptions contest;
    unsigned limit_seconds = 300;
};

std::vector<ShotEngine> all_engines([[maybe_unused]] std::vector<std::string>& missing) {
    std::vector<ShotEngine> engines;
    engines.push_back(our_shots());
#ifdef CD_PEER_EMBREE
    add_embree_shots(engines);
#else
    missing.emplace_back("Embree");
    std::fprintf(stderr, "MISSING: Embree was not installed at build time: no rows\n");
#endif
    return engines;
}

/// Measures one scene; a scene without lines has no rows.
void add_scene(const ShotScene& scene,
               std::span<const ShotEngine> engines,
               const ShotContestOptions& options,
               CsvFile& csv) {
    const std::uint64_t lines = scene.line_count();
    std::printf("%s, %s: %llu lines\n",
                scene.body.c_str(),
                scene.kind.c_str(),
                static_cast<unsigned long long>(lines));
    std::fflush(stdout);
    if (lines == 0) {
        return;
    }
    const std::vector<ShotOutcome> outcomes = run_shot_contest(scene, engines, options);
    for (std::size_t i = 0; i < engines.size(); ++i) {
        const ShotOutcome& outcome = outcomes[i];
        const bool is_timed = outcome.seconds > 0;
        csv.row({scene.body,
                 scene.kind,
                 scene.is_closed ? "yes" : "no",
                 engines[i].name,
                 std::string(to_text(outcome.ending)),
                 cell(lines),
                 cell(outcome.hits),
                 is_timed ? cell(static_cast<double>(lines) / outcome.seconds) : "",
                 is_timed ? cell(outcome.seconds / outcomes.front().seconds) : "",
                 cell(outcome.missing),
                 cell(outcome.doubled),
                 cell(outcome.wrong_lines),
                 cell(outcome.odd_lines),
                 cell(outcome.judged),
                 cell(outcome.ours_wrong)});
    }
}

void run(const Options& options) {
    std::filesystem::create_directories(options.out);
    std::vector<std::string> missing;
    const std::vector<ShotEngine> engines = all_engines(missing);
    write_machine(options.out, missing);
    CsvFile csv(options.out / "shots.csv",
                {"body",
                 "kind",
                 "closed",
                 "engine",
                 "ending",
                 "lines",
                 "hits",
                 "lines_per_s",
                 "ratio",
                 "missing",
                 "doubled",
                 "wrong_lines",
                 "odd_lines",
                 "judged",
                 "ours_wrong"});
    for (const ShotTarget& target : shot_targets(options.scenes)) {
        add_scene(grid_scene(target, options.scenes.lines), engines, options.contest, csv);
        add_scene(
            vertex_scene(target, options.scenes.lines_on_features), engines, options.contest, csv);
        add_scene(
            edge_scene(target, options.scenes.lines_on_features), engines, options.contest, csv);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.scenes.models = CD_MESHES;
    CLI::App app("Compares shot lines of our engine with those of others");
    app.add_option("--out", options.out, "Folder for the CSV files");
    app.add_option("--models", options.scenes.models, "Folder of the mesh files");
    app.add_option("--only", options.scenes.only, "Bodies with this in their names");
    app.add_option("--lines", options.scenes.lines, "Lines of a grid on each side")
        ->check(CLI::Range(1, 1000000));
    app.add_option("--on-features",
                   options.scenes.lines_on_features,
                   "Lines through vertices, and through middles of edges")
        ->check(CLI::Range(1, 1000000));
    app.add_option("--sphere", options.scenes.sphere_subdivisions, "Subdivisions of the sphere")
        ->check(CLI::Range(0, 8));
    app.add_option("--rounds", options.contest.rounds, "Rounds, of which the median is taken")
        ->check(CLI::Range(1, 100));
    app.add_option("--judged", options.contest.judged_max, "Lines that the oracle judges");
    app.add_option("--limit", options.limit_seconds, "Seconds for an engine on all lines");
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
