// Speed against error: our settings and other engines on hard pairs, whole meshes and vehicles,
// compared with an exact oracle. See README.md.
#include "bench/accuracy/machine.hpp"
#include "bench/accuracy/ours.hpp"
#include "bench/accuracy/suites/coarse_suite.hpp"
#include "bench/accuracy/suites/pair_suite.hpp"
#include "bench/accuracy/suites/point_suite.hpp"
#include "bench/accuracy/suites/scene_suite.hpp"
#include "bench/accuracy/suites/sources.hpp"
#include "bench/accuracy/suites/stage_suite.hpp"
#include "bench/peers/engines/peers.hpp"
#include "tests/corpus/pairs.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <thread>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path out = "accuracy";
    std::filesystem::path models = CD_MESHES;
    std::uint64_t pairs = 200000;
    std::uint64_t chunk = 20000;
    std::uint64_t scenarios = 20;
    std::size_t scenes = 1000;
    std::size_t couples = 100;
    std::size_t rounds = 5;
    std::size_t timed = 2000;
    std::size_t points = 200;
    unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    unsigned limit_seconds = 120;
    bool answers_only = false;
};

void say(const std::string& what) {
    std::printf("%s\n", what.c_str());
    std::fflush(stdout);
}

PairSuiteOptions pair_options(const Options& options) {
    return {options.threads,
            options.answers_only ? 0 : options.rounds,
            options.timed,
            std::chrono::seconds(options.limit_seconds)};
}

/// Returns at least the requested number of pairs.
std::uint64_t pairs_of_category(const Options& options) {
    const std::uint64_t categories = tests::pair_categories().size();
    return std::max<std::uint64_t>(1, (options.pairs + categories - 1) / categories);
}

void ask_category(const std::string& category,
                  const Options& options,
                  std::span<const Engine> engines,
                  CsvFile& pairs_csv) {
    say("pairs: " + category);
    const std::uint64_t each = pairs_of_category(options);
    std::uint64_t made = 0;
    const auto next_chunk = [&] {
        const std::uint64_t count = std::min(options.chunk, each - made);
        const std::uint64_t first = made;
        made += count;
        return corpus_batch(category, first, count);
    };
    run_category("corpus", category, next_chunk, engines, pair_options(options), pairs_csv);
}

void run_corpus(const Options& options, std::span<const Engine> engines, CsvFile& pairs_csv) {
    CsvFile points_csv = open_points_csv(options.out);
    const std::uint64_t each = pairs_of_category(options);
    for (const std::string& category : tests::pair_categories()) {
        ask_category(category, options, engines, pairs_csv);
        const std::uint64_t timed = std::min<std::uint64_t>(each, options.timed);
        run_points(category,
                   corpus_batch(category, 0, timed),
                   options.points,
                   engines,
                   std::chrono::seconds(options.limit_seconds),
                   points_csv);
    }
}

struct SceneFiles {
    CsvFile queries;
    CsvFile coarse;
};

/// Runs the pair engines on the pairs that a scene's boxes leave, then the whole-mesh engines.
void run_one_scene(const Scene& scene,
                   const Options& options,
                   std::span<const Engine> pair_engines,
                   std::span<const Engine> mesh_engines,
                   CsvFile& pairs_csv,
                   CsvFile& stages_csv,
                   SceneFiles& files) {
    say(scene.suite + ": " + scene.name);
    const SceneCandidates candidates(scene);
    bool given = false;
    const auto next_chunk = [&] {
        PairBatch batch = given ? PairBatch(std::vector<PairGroup>{}) : candidates.batch();
        given = true;
        return batch;
    };
    run_category(
        scene.suite, scene.name, next_chunk, pair_engines, pair_options(options), pairs_csv);
    run_stages(scene.suite, scene.name, candidates.batch(), options.rounds, stages_csv);

    const std::vector<TrueContacts> truth = true_contacts(scene, options.threads);
    SceneSuiteOptions scene_options;
    scene_options.rounds = options.rounds;
    scene_options.limit = std::chrono::seconds(options.limit_seconds);
    run_scene(scene, truth, mesh_engines, scene_options, files.queries);
    if (scene.poses.size() > 1) {
        CoarseOptions coarse;
        coarse.rounds = options.rounds;
        run_coarse(scene, truth, coarse, files.coarse);
    }
}

void run(const Options& options) {
    std::filesystem::create_directories(options.out);
    std::vector<Engine> pair_engines = our_engines();
    write_machine(options.out, add_peers(pair_engines));
    std::erase_if(pair_engines, [](const Engine& engine) { return !engine.make_pairs; });
    std::vector<Engine> mesh_engines = pair_engines;
    std::erase_if(mesh_engines, [](const Engine& engine) { return !engine.make_meshes; });

    CsvFile pairs_csv = open_pairs_csv(options.out);
    if (options.answers_only) {
        for (const std::string& category : tests::pair_categories()) {
            ask_category(category, options, pair_engines, pairs_csv);
        }
        return;
    }
    CsvFile stages_csv = open_stages_csv(options.out);
    run_corpus(options, pair_engines, pairs_csv);
    SceneFiles files{open_queries_csv(options.out), open_coarse_csv(options.out)};
    std::vector<Scene> scenes = hard_scenes(options.scenes);
    scenes.push_back(torus_scene(2 * options.scenarios));
    for (std::size_t i = 0; i < std::min(options.couples, vehicle_scene_count()); ++i) {
        if (auto scene = vehicle_scene(options.models, i, options.scenarios)) {
            scenes.push_back(std::move(*scene));
        }
    }
    for (const Scene& scene : scenes) {
        run_one_scene(scene, options, pair_engines, mesh_engines, pairs_csv, stages_csv, files);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Measures speed against error of our settings and of other engines");
    app.add_option("--out", options.out, "Folder for the CSV files");
    app.add_option("--models", options.models, "Folder of the vehicles");
    app.add_option("--pairs", options.pairs, "Hard pairs in all, spread over their categories");
    app.add_flag("--answers", options.answers_only, "Hard pairs alone, and no times");
    app.add_option("--chunk", options.chunk, "Hard pairs in memory at a time");
    app.add_option("--scenarios", options.scenarios, "Poses of each two vehicles");
    app.add_option("--scenes", options.scenes, "Hard scenes of whole meshes, at most");
    app.add_option("--couples", options.couples, "Couples of vehicles, at most");
    app.add_option("--rounds", options.rounds, "Rounds of timing, in which all engines take turns");
    app.add_option("--timed", options.timed, "Pairs of each category that are timed");
    app.add_option("--points", options.points, "Pairs of each category whose points are compared");
    app.add_option("--threads", options.threads, "Threads of the oracle");
    app.add_option("--limit", options.limit_seconds, "Seconds for an engine on a chunk or scene");
    CLI11_PARSE(app, argc, argv);
    try {
        cd::bench::run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
