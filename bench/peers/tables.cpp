#include "bench/peers/tables.hpp"

#include "bench/accuracy/timing.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace cd::bench {

namespace {

/// Returns an empty cell for an unknown value.
std::string known(double value, bool is_known) {
    return is_known ? cell(value) : std::string();
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns the median over the poses of the ratio of the two times.
std::string median_ratio(const Heat& heat, const Heat& ours) {
    if (heat.pose_seconds.empty() || ours.pose_seconds.empty()) {
        return {};
    }
    std::vector<double> ratios;
    for (std::size_t p = 0; p < heat.pose_seconds.size(); ++p) {
        ratios.push_back(heat.pose_seconds[p] / ours.pose_seconds[p]);
    }
    return cell(median(ratios));
}

std::string ending_of(const Heat& heat) {
    return heat.took_part ? std::string(to_text(heat.ending)) : std::string();
}

std::vector<std::string> cells_of_pairs(const Outcome& outcome, const Outcome& ours) {
    const Heat& heat = outcome.pairs;
    const auto count = [&](std::uint64_t n) { return heat.took_part ? cell(n) : std::string(); };
    return {ending_of(heat),
            count(outcome.pairs_found),
            count(outcome.missing),
            count(outcome.extra),
            count(outcome.judged),
            count(outcome.ours_wrong),
            cell(std::uint64_t{heat.rounds}),
            heat.pose_seconds.empty() ? std::string() : cell(1e6 * mean(heat.pose_seconds)),
            median_ratio(heat, ours.pairs)};
}

std::vector<std::string>
cells_of_any(const Outcome& outcome, const Outcome& ours, std::size_t poses) {
    const Heat& heat = outcome.any;
    const bool has_best = heat.passes > 0;
    return {ending_of(heat),
            heat.took_part ? cell(outcome.wrong_any) : std::string(),
            cell(std::uint64_t{heat.passes}),
            known(1e6 * heat.pass_seconds / static_cast<double>(poses), has_best),
            known(heat.pass_seconds / ours.any.pass_seconds, has_best && ours.any.passes > 0)};
}

std::vector<std::string> cells_of_load(const Outcome& outcome, const Scene& scene) {
    const auto triangles =
        static_cast<double>(scene.a->triangles().size() + scene.b->triangles().size());
    const auto each = [&](std::uint64_t bytes) {
        return known(static_cast<double>(bytes) / triangles, bytes > 0);
    };
    return {known(1e3 * outcome.build_seconds, outcome.build_seconds > 0),
            each(outcome.memory_bytes),
            each(outcome.resident_bytes)};
}

void add_scene(CsvFile& csv,
               const SceneSource& source,
               const Scene& scene,
               const Reference& reference) {
    std::uint64_t touching = 0;
    std::uint64_t pairs = 0;
    for (std::size_t p = 0; p < reference.pose_count(); ++p) {
        const std::uint64_t count = reference.pair_count(p);
        pairs += count;
        touching += count > 0 ? 1u : 0u;
    }
    csv.row({source.suite,
             source.name,
             cell(source.x),
             cell(std::uint64_t{scene.a->triangles().size()}),
             cell(std::uint64_t{scene.b->triangles().size()}),
             cell(std::uint64_t{scene.poses.size()}),
             cell(touching),
             cell(pairs)});
}

} // namespace

Tables::Tables(const std::filesystem::path& folder)
    : scenes(folder / "scenes.csv",
             {"suite",
              "scene",
              "x",
              "triangles_a",
              "triangles_b",
              "poses",
              "poses_touching",
              "pairs"}),
      engines(folder / "engines.csv",
              {"suite",
               "scene",
               "x",
               "engine",
               "ours",
               "build_ms",
               "bytes_triangle",
               "resident_bytes_triangle",
               "ending",
               "pairs_found",
               "missing",
               "extra",
               "judged",
               "ours_wrong",
               "rounds",
               "mean_us",
               "ratio",
               "any_ending",
               "any_wrong",
               "any_passes",
               "any_best_us",
               "any_best_ratio"}) {}

void Tables::add(const SceneSource& source,
                 const Scene& scene,
                 const Reference& reference,
                 std::span<const Outcome> outcomes) {
    add_scene(scenes, source, scene, reference);
    for (const Outcome& outcome : outcomes) {
        std::vector<std::string> row{source.suite,
                                     source.name,
                                     cell(source.x),
                                     outcome.engine->name,
                                     outcome.engine->is_ours ? "yes" : "no"};
        const Outcome& ours = outcomes.front();
        for (const auto& cells : {cells_of_load(outcome, scene),
                                  cells_of_pairs(outcome, ours),
                                  cells_of_any(outcome, ours, scene.poses.size())}) {
            row.insert(row.end(), cells.begin(), cells.end());
        }
        engines.row(row);
    }
}

} // namespace cd::bench
