// What does each rule of splitting cost and give? Builds one mesh's tree under the rules of the
// paper (section 6.2) with and without the bound of a quarter, and with boxes along the body's
// axes, and runs the same random scenarios of the mesh against itself on each.
//
//   tree_build_bench MESH [--scenarios 50] [--depth 12] [--no-bare]
//
// A Markdown row a tree: seconds to build with one thread and with two, nodes, depth, the share of
// the triangles under the largest distribution root, bytes a triangle (nodes and order), N_b and
// N_p a scenario, the paper's cost as measured milliseconds a scenario, and the digest, which must
// be one.
#include "client/mesh_import.hpp"
#include "common/core/thread_pool.hpp"
#include "common/job/merge.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build.hpp"
#include "common/tree/cut.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace cd {

namespace {

struct Options {
    std::string mesh;
    std::uint64_t scenarios = 50;
    std::uint32_t depth = 12;
    bool skips_bare = false;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double
build_seconds(const std::shared_ptr<const Mesh>& mesh, const BuildOptions& rule, unsigned threads) {
    ThreadPool pool(threads);
    const auto start = std::chrono::steady_clock::now();
    const ObbTree tree = build_tree(mesh, rule, pool);
    return seconds_since(start);
}

double largest_share(const ObbTree& tree, std::uint32_t depth) {
    const TreeTop top = cut_tree(tree, depth);
    std::uint32_t largest = 0;
    for (RootIndex root = 0; root < top.root_count(); ++root) {
        largest = std::max(largest, top.triangles_under(root));
    }
    return static_cast<double>(largest) / static_cast<double>(tree.triangle_ids().size());
}

/// Prints one row and returns the digest.
Sha256 measure(const char* name,
               const std::shared_ptr<const Mesh>& mesh,
               const BuildOptions& rule,
               const std::vector<Scenario>& scenarios,
               std::uint32_t depth) {
    const double one = build_seconds(mesh, rule, 1);
    const double two = build_seconds(mesh, rule, 2);
    ThreadPool pool;
    const ObbTree tree = build_tree(mesh, rule, pool);

    ResultMerger merger(scenarios.size());
    QueryStatistics total;
    const auto start = std::chrono::steady_clock::now();
    for (const Scenario& scenario : scenarios) {
        const ScenarioRun run = run_scenario(tree, tree, scenario, Query{});
        total += run.statistics;
        static_cast<void>(merger.add(run.result));
    }
    const double count = static_cast<double>(scenarios.size());
    const double triangles = static_cast<double>(mesh->triangles().size());
    const double tree_bytes = static_cast<double>(tree.nodes().size_bytes()) +
                              static_cast<double>(tree.triangle_ids().size_bytes());
    const Sha256 digest = merger.digest().value_or(Sha256{});
    std::printf("| %s | %.2f | %.2f | %zu | %u | %.2f %% | %.1f | %.0f | %.0f | %.3f | %s |\n",
                name,
                one,
                two,
                tree.nodes().size(),
                tree.depth(),
                100 * largest_share(tree, depth),
                tree_bytes / triangles,
                static_cast<double>(total.box_tests) / count,
                static_cast<double>(total.triangle_tests) / count,
                1e3 * seconds_since(start) / count,
                to_short_hex(digest).c_str());
    std::fflush(stdout);
    return digest;
}

int compare(const Options& options) {
    const auto imported = import_mesh(options.mesh, {});
    if (!imported) {
        std::fprintf(stderr, "%s\n", imported.error().detail.c_str());
        return 2;
    }
    const auto& mesh = imported.value().mesh;
    ThreadPool pool;
    const ObbTree tree = build_tree(mesh, {}, pool);
    RandomPoses random;
    random.count = options.scenarios;
    const auto scenarios = make_random_poses(random, tree, tree, pool);

    std::printf("%s, %zu triangles, distribution depth %u, %llu scenarios\n\n",
                options.mesh.c_str(),
                mesh->triangles().size(),
                options.depth,
                static_cast<unsigned long long>(options.scenarios));
    std::printf(
        "| tree | build s, 1 thread | 2 threads | nodes | depth | largest root | bytes/triangle "
        "| N_b | N_p | ms/scenario | digest |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    BuildOptions rule;
    const Sha256 expected = measure("OBB, quarter", mesh, rule, scenarios, options.depth);
    rule.boxes = BoxKind::Aabb;
    bool same = measure("AABB, quarter", mesh, rule, scenarios, options.depth) == expected;
    if (!options.skips_bare) {
        rule = {};
        rule.rule = SplitRule::Bare;
        same = measure("OBB, bare", mesh, rule, scenarios, options.depth) == expected && same;
    }
    return same ? 0 : 1;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    cd::Options options;
    CLI::App app("Compares the rules by which OBB trees are built");
    app.add_option("MESH", options.mesh, "A mesh file")->required();
    app.add_option("--scenarios", options.scenarios, "Random scenarios of the mesh against itself");
    app.add_option("--depth", options.depth, "Distribution depth of the share");
    app.add_flag("--no-bare", options.skips_bare, "Leave out the bare rule, which is slow");
    CLI11_PARSE(app, argc, argv);
    return cd::compare(options);
}
