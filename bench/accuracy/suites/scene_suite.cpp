#include "bench/accuracy/suites/scene_suite.hpp"

#include "bench/accuracy/timing.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace cd::bench {

namespace {

/// One engine at one of its levels.
struct Setting {
    const Engine* engine;
    Level level;
    QueryTotals totals;
    Ending ending = Ending::Done;
    double seconds_a_query = 0;
};

void count_pairs(MeshAnswer& answer, const TrueContacts& truth, QueryTotals& totals) {
    std::sort(answer.pairs.begin(), answer.pairs.end());
    answer.pairs.erase(std::unique(answer.pairs.begin(), answer.pairs.end()), answer.pairs.end());
    for (const IdPair& pair : answer.pairs) {
        totals.wrong[0] += true_class(truth, pair) == PairClass::Separate ? 1u : 0u;
    }
    for (const TruePair& pair : truth) {
        const bool found = std::binary_search(answer.pairs.begin(), answer.pairs.end(), pair.ids);
        totals.wrong[static_cast<std::size_t>(pair.kind)] += found ? 0u : 1u;
    }
}

void judge(MeshAnswer answer, Level level, const TrueContacts& truth, QueryTotals& totals) {
    totals.wrong_any += answer.touches == truth.empty() ? 1u : 0u;
    if (level >= Level::Pairs) {
        count_pairs(answer, truth, totals);
        answer.pair_count = answer.pairs.size();
    }
    totals.wrong_count += level >= Level::Count && answer.pair_count != truth.size() ? 1u : 0u;
    ++totals.queries;
}

void ask(const Scene& scene,
         std::span<const TrueContacts> truth,
         const SceneSuiteOptions& options,
         Setting& setting) {
    const SharedArray<QueryTotals> shared(1);
    setting.ending = run_isolated(options.limit, [&] {
        const auto meshes = setting.engine->make_meshes();
        meshes->load(scene.a, scene.b);
        for (std::size_t s = 0; s < scene.poses.size(); ++s) {
            judge(meshes->ask(scene.poses[s], setting.level), setting.level, truth[s], shared[0]);
        }
    });
    setting.totals = shared[0];
}

/// Times the settings that neither crashed nor hung.
void time_settings(const Scene& scene,
                   const SceneSuiteOptions& options,
                   std::vector<Setting>& settings) {
    const SharedArray<double> seconds(settings.size());
    const auto limit = options.limit * static_cast<int>(settings.size());
    const Ending ending = run_isolated(limit, [&] {
        std::vector<std::size_t> sound;
        std::vector<std::unique_ptr<MeshEngine>> loaded;
        for (std::size_t i = 0; i < settings.size(); ++i) {
            if (settings[i].ending == Ending::Done) {
                sound.push_back(i);
                loaded.push_back(settings[i].engine->make_meshes());
                loaded.back()->load(scene.a, scene.b);
            }
        }
        const auto medians = interleaved_medians(options.rounds, loaded.size(), [&](std::size_t i) {
            for (const PosePair& poses : scene.poses) {
                static_cast<void>(loaded[i]->ask(poses, settings[sound[i]].level));
            }
        });
        for (std::size_t i = 0; i < sound.size(); ++i) {
            seconds[sound[i]] = medians[i] / static_cast<double>(scene.poses.size());
        }
    });
    for (std::size_t i = 0; i < settings.size() && ending == Ending::Done; ++i) {
        settings[i].seconds_a_query = seconds[i];
    }
}

void write_row(CsvFile& csv, const Scene& scene, const Setting& setting) {
    const QueryTotals& totals = setting.totals;
    csv.row({scene.suite,
             scene.name,
             setting.engine->name,
             setting.engine->is_ours ? "yes" : "no",
             std::string(to_text(setting.level)),
             cell(std::uint64_t{scene.poses.size()}),
             cell(totals.queries),
             cell(totals.wrong_any),
             cell(totals.wrong_count),
             cell(totals.wrong[0]),
             cell(totals.wrong[1]),
             cell(totals.wrong[2]),
             cell(totals.wrong[3]),
             std::string(to_text(setting.ending)),
             setting.seconds_a_query > 0 ? cell(1e6 * setting.seconds_a_query) : std::string()});
}

} // namespace

void run_scene(const Scene& scene,
               std::span<const TrueContacts> truth,
               std::span<const Engine> engines,
               const SceneSuiteOptions& options,
               CsvFile& csv) {
    std::vector<Setting> settings;
    for (const Engine& engine : engines) {
        for (const Level level : engine.levels) {
            settings.push_back({&engine, level, {}});
        }
    }
    for (Setting& setting : settings) {
        ask(scene, truth, options, setting);
    }
    time_settings(scene, options, settings);
    for (const Setting& setting : settings) {
        write_row(csv, scene, setting);
    }
}

CsvFile open_queries_csv(const std::filesystem::path& folder) {
    return {folder / "queries.csv",
            {"suite",
             "scene",
             "engine",
             "ours",
             "level",
             "asked",
             "answered",
             "wrong_any",
             "wrong_count",
             "invented",
             "missed_touch",
             "missed_coplanar",
             "missed_proper",
             "ending",
             "us_query"}};
}

} // namespace cd::bench
