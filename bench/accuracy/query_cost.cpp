// Measures whole queries of vehicles, exact or with floats alone; certification.py runs both in
// turn.
//
//   query_cost --save FILE [--models FOLDER] [--couple 0] [--scenarios 50]   the poses, as a file
//   query_cost --load FILE [--models FOLDER] [--couple 0] --level pairs [--repeat 5]
//   [--floats-only]
//
// Prints the best seconds of `repeat` runs over all poses, and the number of contacts.
#include "bench/accuracy/suites/sources.hpp"
#include "bench/accuracy/timing.hpp"
#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

namespace cd::bench {

namespace {

struct Options {
    std::string save;
    std::string load;
    std::filesystem::path models = CD_MESHES;
    std::size_t couple = 0;
    std::uint64_t scenarios = 50;
    std::string level = "pairs";
    std::size_t repeat = 5;
    bool floats_only = false;
};

void save(const Options& options, const Scene& scene) {
    std::vector<Scenario> scenarios;
    for (const PosePair& poses : scene.poses) {
        scenarios.push_back({scenarios.size(), 0, 1, poses});
    }
    const Bytes bytes = pack_scenarios(scenarios);
    std::ofstream file(options.save, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

std::vector<Scenario> load(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    auto scenarios = unpack_scenarios(std::as_bytes(std::span(text)), limits::scenarios_max);
    CD_CHECK(scenarios.has_value());
    return std::move(scenarios.value());
}

} // namespace

/// Not inlined, so that a profiler can count its instructions alone.
[[gnu::noinline]] std::uint64_t run_queries(const ObbTree& a,
                                            const ObbTree& b,
                                            std::span<const Scenario> scenarios,
                                            const Query& query,
                                            const RunOptions& options) {
    std::uint64_t contacts = 0;
    for (const Scenario& scenario : scenarios) {
        const SubtreePair whole{a.view(), b.view()};
        const ScenarioRun run = run_on_subtrees({&whole, 1}, scenario, query, options);
        contacts += run.result.pair_count + (run.result.kind == ScenarioClass::Contact ? 1u : 0u);
    }
    return contacts;
}

namespace {

int run(const Options& options) {
    const bool saves = !options.save.empty();
    const auto scene = vehicle_scene(options.models, options.couple, saves ? options.scenarios : 0);
    if (!scene) {
        return 2;
    }
    if (saves) {
        save(options, *scene);
        return 0;
    }
    ThreadPool pool;
    const ObbTree a = build_tree(scene->a, {}, pool);
    const ObbTree b = build_tree(scene->b, {}, pool);
    const std::vector<Scenario> scenarios = load(options.load);
    Query query;
    query.level = level_from_text(options.level).value_or(Level::Pairs);
    RunOptions run_options;
    run_options.decision = options.floats_only ? PairDecision::FloatsOnly : PairDecision::Exact;
    double best = std::numeric_limits<double>::infinity();
    std::uint64_t contacts = 0;
    for (std::size_t i = 0; i < options.repeat; ++i) {
        best = std::min(
            best, seconds_of([&] { contacts = run_queries(a, b, scenarios, query, run_options); }));
    }
    std::printf("%.9f %llu\n", best, static_cast<unsigned long long>(contacts));
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Times whole queries of vehicles");
    app.add_option("--save", options.save, "Write the poses to this file and end");
    app.add_option("--load", options.load, "Take the poses from this file");
    app.add_option("--models", options.models, "Folder of the vehicles");
    app.add_option("--couple", options.couple, "Which two vehicles, from 0");
    app.add_option("--scenarios", options.scenarios, "Random poses to save, and as many near them");
    app.add_option("--level", options.level, "any, count, pairs or contacts");
    app.add_option("--repeat", options.repeat, "Runs; the best counts");
    app.add_flag(
        "--floats-only", options.floats_only, "Decide pairs by floats alone, often wrongly");
    CLI11_PARSE(app, argc, argv);
    return cd::bench::run(options);
}
