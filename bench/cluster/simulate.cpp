// Runs the paper's experiments over recorded traces, under SimGrid. See README.md.
//
//   simulate HEAVY_TRACE CARS_TRACE --out FOLDER [--only paper|gains|measured|additions] [--quick]
#include "bench/accuracy/machine.hpp"
#include "bench/cluster/paper/additions.hpp"
#include "bench/cluster/paper/attribution.hpp"
#include "bench/cluster/paper/experiments.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <exception>
#include <numeric>

namespace cd::bench {

namespace {

/// Lowest reaches a speed-up of 12 in the heavy case (7.2): the weighted serial time of Table 2
/// divided by the parallel time.
constexpr double paper_lowest_seconds = 3133.0 / 12;

/// Writes the scenarios' costs by the paper's function: N_b, C_b, N_p, C_p.
void write_costs(const std::filesystem::path& out, const std::array<Scene, 2>& scenes) {
    CsvFile csv(out / "costs.csv",
                {"scene",
                 "depth",
                 "roots",
                 "analysis_us",
                 "analysis_tests",
                 "work_us",
                 "binary_us",
                 "roots_a",
                 "roots_b",
                 "batch_bytes",
                 "result_bytes",
                 "bytes_triangle",
                 "wire_bytes_triangle",
                 "open_ms",
                 "top_kb"});
    for (const Scene& scene : scenes) {
        for (const DepthTrace& depth : scene.trace->depths) {
            const auto mean = [&](auto value) {
                double sum = 0;
                for (const ScenarioTrace& scenario : depth.scenarios) {
                    sum += static_cast<double>(value(scenario));
                }
                return cell(sum / static_cast<double>(depth.scenarios.size()));
            };
            const auto total = [&](auto member) {
                double sum = 0;
                for (const RootTrace& root : depth.a.roots) {
                    sum += static_cast<double>(root.*member);
                }
                return sum;
            };
            const auto triangles = static_cast<double>(scene.trace->triangles_a);
            using Of = const ScenarioTrace&;
            csv.row({scene.trace->name,
                     cell(std::uint64_t{depth.a.depth}),
                     cell(std::uint64_t{depth.a.roots.size()}),
                     mean([](Of one) { return 1e6 * one.analysis_seconds; }),
                     mean([](Of one) { return one.analysis_box_tests; }),
                     mean([](Of one) { return 1e6 * one.work_seconds; }),
                     mean([](Of one) { return 1e6 * one.binary_seconds; }),
                     mean([](Of one) { return one.roots_a.size(); }),
                     mean([](Of one) { return one.roots_b.size(); }),
                     mean([](Of one) { return one.batch_bytes; }),
                     mean([](Of one) { return one.result_bytes; }),
                     cell(total(&RootTrace::bytes) / triangles),
                     cell(total(&RootTrace::compressed_bytes) / triangles),
                     cell(1e3 * total(&RootTrace::open_seconds)),
                     cell(1e-3 * static_cast<double>(depth.a.top_bytes))});
        }
    }
}

void write_whole(const std::filesystem::path& out, const std::array<Scene, 2>& scenes) {
    CsvFile csv(out / "whole.csv",
                {"scene",
                 "scenarios",
                 "us",
                 "binary_us",
                 "box_tests",
                 "triangle_tests",
                 "wide_box_tests",
                 "wide_triangle_tests",
                 "box_test_ns",
                 "triangle_test_ns"});
    for (const Scene& scene : scenes) {
        const auto mean = [&](auto member, double unit) {
            double sum = 0;
            for (const WholeTrace& whole : scene.trace->whole) {
                sum += static_cast<double>(whole.*member);
            }
            return cell(unit * sum / static_cast<double>(scene.trace->whole.size()));
        };
        csv.row({scene.trace->name,
                 cell(std::uint64_t{scene.trace->whole.size()}),
                 mean(&WholeTrace::seconds, 1e6),
                 mean(&WholeTrace::binary_seconds, 1e6),
                 mean(&WholeTrace::box_tests, 1),
                 mean(&WholeTrace::triangle_tests, 1),
                 mean(&WholeTrace::wide_box_tests, 1),
                 mean(&WholeTrace::wide_triangle_tests, 1),
                 cell(scene.trace->box_test_ns),
                 cell(scene.trace->triangle_test_ns)});
    }
}

void run_paper(Experiments& experiments, const Setting& setting, const Scene& scene) {
    experiments.vary_scenarios(setting, scene);
    experiments.at_paper_depth(setting, scene);
    experiments.vary_q(setting, scene);
    experiments.vary_cores(setting, scene);
}

/// Measures today's product: the paper's numbers of scenarios, mostly also ten times as many, and a
/// hundred times, since its scenarios are much shorter.
void run_measured(Experiments& experiments, const Scene& scene) {
    const Setting setting = measured_setting();
    const std::uint64_t count = 10 * scene.trace->whole.size();
    Scene best = scene;
    best.depth = experiments.vary_depth(setting, scene, count);
    experiments.vary_rounds(setting, best, {1, 10, 30});
    experiments.vary_q(setting, best, count);
    experiments.vary_cores(setting, best, count);
}

/// Uses a depth at which neither the master's analysis nor the block size dominates.
void compare_additions(const ExperimentOptions& options, Scene scene) {
    scene.depth = 6;
    compare_additions(options, {paper_setting(), measured_setting()}, scene);
}

/// Runs the experiments without a fitted constant, then with one.
void run_both(Experiments& experiments, CsvFile& fit, std::array<Scene, 2> scenes) {
    for (Scene& scene : scenes) {
        scene.depth = experiments.vary_depth(paper_setting(), scene);
        run_paper(experiments, paper_setting(), scene);
    }
    if (const auto rate = experiments.fit_pipe(fitted_setting, scenes[0], paper_lowest_seconds)) {
        fit.row({"pipe, bytes a second", cell(*rate)});
        for (const Scene& scene : scenes) {
            static_cast<void>(experiments.vary_depth(fitted_setting(*rate), scene));
            run_paper(experiments, fitted_setting(*rate), scene);
        }
    }
}

/// With two fitted constants, at the paper's depths: where the optimum of depth and q lies, and
/// what each part contributes.
void run_gains(Experiments& experiments,
               CsvFile& fit,
               const ExperimentOptions& options,
               std::array<Scene, 2> scenes) {
    for (Scene& scene : scenes) {
        const bool has_it = scene.trace->at(scene.paper_depth) != nullptr;
        scene.depth = has_it ? scene.paper_depth : scene.trace->depths.back().a.depth;
    }
    CsvFile attribution(options.out / "attribution.csv", attribution_columns());
    if (const auto rate =
            experiments.fit_pipe(client_first_setting, scenes[0], paper_lowest_seconds)) {
        fit.row({"pipe with 3 ms an analysis, bytes a second", cell(*rate)});
        const Setting setting = client_first_setting(*rate);
        for (const Scene& scene : scenes) {
            static_cast<void>(experiments.vary_depth(setting, scene));
            experiments.vary_q(setting, scene);
            attribute(attribution, options, setting, scene);
        }
    }
}

void run(const ExperimentOptions& options,
         const std::array<Scene, 2>& scenes,
         const std::string& which) {
    std::filesystem::create_directories(options.out);
    if (which == "additions") {
        return compare_additions(options, scenes[0]);
    }
    write_machine(options.out, {});
    write_whole(options.out, scenes);
    write_costs(options.out, scenes);
    Experiments experiments(options);
    CsvFile fit(options.out / "fit.csv", {"what", "value"});
    if (which == "gains") {
        return run_gains(experiments, fit, options, scenes);
    }
    if (which != "measured") {
        run_both(experiments, fit, scenes);
        compare_additions(options, scenes[0]);
    }
    if (which != "paper") {
        for (const Scene& scene : scenes) {
            run_measured(experiments, scene);
        }
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    using namespace cd::bench;
    ExperimentOptions options;
    std::filesystem::path heavy_path;
    std::filesystem::path cars_path;
    std::string which;
    CLI::App app("Simulates the paper's experiments");
    app.add_option("HEAVY", heavy_path, "The trace of a heavy vehicle against a car")->required();
    app.add_option("CARS", cars_path, "The trace of a car against another")->required();
    app.add_option("--out", options.out, "A folder for CSV files")->required();
    app.add_option("--seeds", options.seeds, "Of each point")->check(CLI::PositiveNumber);
    app.add_option("--only", which, "Of the settings")
        ->check(CLI::IsMember({"paper", "gains", "measured", "additions"}));
    app.add_flag("--quick", options.quick, "Few points, one seed");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto heavy = read_trace(heavy_path);
        const auto cars = read_trace(cars_path);
        for (const auto* trace : {&heavy, &cars}) {
            if (!*trace) {
                std::fprintf(stderr, "%s\n", trace->error().detail.c_str());
                return 2;
            }
        }
        run(options,
            {Scene{&heavy.value(), &paper_table_heavy, 12, 12},
             Scene{&cars.value(), &paper_table_cars, 10, 10}},
            which);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
