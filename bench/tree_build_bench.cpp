// Compares ways of splitting: binned splits, the paper's sweep everywhere (section 6.2), boxes
// along the body's axes, and no bound of a quarter. Builds the trees of two meshes in each way and
// runs one set of scenarios on each tree.
//
//   tree_build_bench MESH_A [MESH_B] [--poses FILE | --random 50] [--rounds 5] [--depth 12]
//                    [--no-bare]
//
// Without MESH_B the mesh meets itself. FILE holds a pose of B in A's frame per line: the rotation
// by rows, then the translation. Without FILE the poses are random ones in contact.
//
// The first table has a row per mesh: the time of the connections alone, then the least and the
// median time of a build over the rounds, on one thread and on two, without and with the wide tree.
// Times are wall time and processor time (of all threads, without waits for a busy machine).
//
// The second table measures trees kept on disk, a row per mesh. For each form: MB, and the time to
// write a file and to find it again (mapped and checked). For the wide form also: the first search
// of the mesh against itself, in a tree just found and in the one just built.
//
// The third table measures support points, a row per mesh: the same times of a build with the wide
// tree and of its points, in turn, on one thread and on two; the median share of a build that the
// points take; the mean eps of nodes whose points are chosen, and the root's, as shares of the
// body's radius; and bytes a triangle.
//
// The fourth table has a row per tree: nodes and depth of A's tree, the share of its triangles
// under the largest distribution root, bytes per triangle (nodes and order), N_b and N_p per
// scenario, C_b (processor time of a descent without triangle tests over N_b) and C_p (the
// remaining time over N_p), the paper's cost N_b C_b + N_p C_p with the first row's C_b and C_p,
// and the digest, which must be equal in all rows. All rows but the last search the paper's binary
// tree. The last row searches the wide tree, whose box tests differ: only its own C_b and C_p tell
// its cost.
#include "bench/posed_trees.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/run_scenario.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/cut.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace cd {

namespace {

struct Options {
    bench::PosedTreesOptions bodies;
    std::uint32_t depth = 12;
    std::size_t rounds = 5;
    bool skips_bare = false;
};

using MeshPointer = std::shared_ptr<const Mesh>;

double seconds_on(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double processor_seconds() {
    return seconds_on(CLOCK_PROCESS_CPUTIME_ID);
}

/// Times of several rounds, ms.
struct Times {
    std::vector<double> wall;
    std::vector<double> processor;

    template <class Function>
    void add(const Function& function) {
        const double wall_before = seconds_on(CLOCK_MONOTONIC);
        const double processor_before = processor_seconds();
        function();
        wall.push_back(1e3 * (seconds_on(CLOCK_MONOTONIC) - wall_before));
        processor.push_back(1e3 * (processor_seconds() - processor_before));
    }

    void print() {
        for (std::vector<double>* times : {&wall, &processor}) {
            std::sort(times->begin(), times->end());
            std::printf(" %.3g / %.3g |", times->front(), (*times)[times->size() / 2]);
        }
    }
};

void print_build_times(const std::string& name, const MeshPointer& mesh, std::size_t rounds) {
    Times connections;
    for (std::size_t round = 0; round < rounds; ++round) {
        connections.add([&] { static_cast<void>(analyse_topology(*mesh)); });
    }
    std::printf("| %s | %zu |", name.c_str(), mesh->triangles().size());
    connections.print();
    for (const bool wide : {false, true}) {
        BuildOptions rule;
        rule.prepare_search = wide;
        for (const unsigned threads : {1u, 2u}) {
            ThreadPool pool(threads);
            Times builds;
            for (std::size_t round = 0; round < rounds; ++round) {
                builds.add([&] { static_cast<void>(build_tree(mesh, rule, pool)); });
            }
            builds.print();
        }
    }
    std::printf("\n");
    std::fflush(stdout);
}

/// A temporary folder, deleted with its files in the destructor.
struct ScratchFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("tree-build-bench-" + std::to_string(::getpid()));
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

double megabytes(std::uint64_t bytes) {
    return 1e-6 * static_cast<double>(bytes);
}

void print_kept_times(const std::string& name, const MeshPointer& mesh, std::size_t rounds) {
    ThreadPool pool;
    const ObbTree tree = build_tree(mesh, {}, pool);
    const ScratchFolder folder;
    TreeCache cache(folder.path);
    std::printf("| %s | %zu |", name.c_str(), mesh->triangles().size());
    std::shared_ptr<const ObbTree> found;
    for (const TreeForm form : {TreeForm::Binary, TreeForm::Wide}) {
        Times kept;
        Times finds;
        for (std::size_t round = 0; round < rounds; ++round) {
            kept.add([&] { cache.keep(form, tree); });
            finds.add([&] { found = cache.find(form, mesh); });
        }
        std::uint64_t bytes = 0;
        for (const auto& file : std::filesystem::directory_iterator(folder.path)) {
            bytes += file.file_size();
            std::filesystem::remove(file.path());
        }
        std::printf(" %.1f |", megabytes(bytes));
        kept.print();
        finds.print();
    }
    Times found_searches;
    Times built_searches;
    const Vec3 half = 0.5 * bounding_box(mesh->vertices()).size();
    const PosePair poses{Pose{}, Pose::from_matrix(Mat3::Identity(), half)};
    found_searches.add([&] { static_cast<void>(contact_pairs(*found, *found, poses)); });
    built_searches.add([&] { static_cast<void>(contact_pairs(tree, tree, poses)); });
    found_searches.print();
    built_searches.print();
    std::printf("\n");
    std::fflush(stdout);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Prints times of a build and of the points, and the points' share of both.
void print_points_share(const MeshPointer& mesh, unsigned threads, std::size_t rounds) {
    ThreadPool pool(threads);
    Times builds;
    Times points;
    std::vector<double> wall_shares;
    std::vector<double> processor_shares;
    for (std::size_t round = 0; round < rounds; ++round) {
        std::optional<ObbTree> tree;
        builds.add([&] { tree = build_tree(mesh, {}, pool); });
        points.add([&] { tree->prepare_planes(&pool); });
        wall_shares.push_back(points.wall.back() / builds.wall.back());
        processor_shares.push_back(points.processor.back() / builds.processor.back());
    }
    builds.print();
    points.print();
    std::printf(" %.1f %% | %.1f %% |", 100 * median(wall_shares), 100 * median(processor_shares));
}

void print_points(const std::string& name, const MeshPointer& mesh, std::size_t rounds) {
    std::printf("| %s | %zu |", name.c_str(), mesh->triangles().size());
    print_points_share(mesh, 1, rounds);
    print_points_share(mesh, 2, rounds);
    ThreadPool pool;
    ObbTree tree = build_tree(mesh, {}, pool);
    tree.prepare_planes(&pool);
    const SupportView support = tree.view().wide.support;
    if (support.sets.empty()) {
        std::printf(" no wide tree | | |\n");
        return;
    }
    double sum = 0;
    double chosen = 0;
    for (const SupportSet& set : support.sets) {
        sum += set.is_chosen ? static_cast<double>(set.eps) : 0;
        chosen += set.is_chosen ? 1 : 0;
    }
    std::printf(" %.3g | %.3g | %.2f |\n",
                sum / std::max(chosen, 1.0) / support.radius,
                static_cast<double>(support.sets.front().eps) / support.radius,
                static_cast<double>(support.sets.size_bytes() + support.columns.size_bytes()) /
                    static_cast<double>(mesh->triangles().size()));
    std::fflush(stdout);
}

double largest_share(const ObbTree& tree, std::uint32_t depth) {
    const TreeTop top = cut_tree(tree, depth);
    std::uint32_t largest = 0;
    for (RootIndex root = 0; root < top.root_count(); ++root) {
        largest = std::max(largest, top.triangles_under(root));
    }
    return static_cast<double>(largest) / static_cast<double>(tree.triangle_ids().size());
}

struct Costs {
    double box_tests = 0;            ///< N_b per scenario.
    double triangle_tests = 0;       ///< N_p per scenario.
    double box_nanoseconds = 0;      ///< C_b, ns.
    double triangle_nanoseconds = 0; ///< C_p, ns.
};

/// Returns the processor time of all searches, s.
double search_seconds(const ObbTree& a,
                      const ObbTree& b,
                      const std::vector<Scenario>& scenarios,
                      std::span<const IgnoredRange> ignored,
                      QueryStatistics& total) {
    const double before = processor_seconds();
    total = {};
    for (const Scenario& scenario : scenarios) {
        const auto search = make_search(a.view(), b.view(), scenario.poses, ignored);
        search->collect(a.view(), b.view());
        total += search->report().statistics;
    }
    return processor_seconds() - before;
}

Costs measure_costs(const ObbTree& a,
                    const ObbTree& b,
                    const std::vector<Scenario>& scenarios,
                    std::size_t rounds) {
    constexpr std::uint32_t all = std::numeric_limits<std::uint32_t>::max();
    const std::vector<IgnoredRange> ignore_all = {{0, all, 0, all}};
    double boxes = std::numeric_limits<double>::infinity();
    double everything = boxes;
    QueryStatistics total;
    for (std::size_t round = 0; round < rounds; ++round) {
        boxes = std::min(boxes, search_seconds(a, b, scenarios, ignore_all, total));
        everything = std::min(everything, search_seconds(a, b, scenarios, {}, total));
    }
    const double count = static_cast<double>(scenarios.size());
    Costs costs;
    costs.box_tests = static_cast<double>(total.box_tests) / count;
    costs.triangle_tests = static_cast<double>(total.triangle_tests) / count;
    costs.box_nanoseconds = 1e9 * boxes / static_cast<double>(total.box_tests);
    costs.triangle_nanoseconds =
        1e9 * std::max(0.0, everything - boxes) / static_cast<double>(total.triangle_tests);
    return costs;
}

Sha256 digest_of(const ObbTree& a, const ObbTree& b, const std::vector<Scenario>& scenarios) {
    ResultMerger merger(scenarios.size());
    for (const Scenario& scenario : scenarios) {
        static_cast<void>(merger.add(run_scenario(a, b, scenario, Query{}).result));
    }
    return merger.digest().value_or(Sha256{});
}

struct Scene {
    MeshPointer a;
    MeshPointer b;
    std::vector<Scenario> scenarios;
    Costs first;     ///< Costs of the first tree.
    Sha256 expected; ///< The first tree's digest.
    bool same = true;
};

/// Prints one row.
void measure(const char* name, const BuildOptions& rule, const Options& options, Scene& scene) {
    ThreadPool pool;
    const ObbTree a = build_tree(scene.a, rule, pool);
    const std::optional<ObbTree> other =
        scene.b == scene.a ? std::nullopt : std::optional(build_tree(scene.b, rule, pool));
    const ObbTree& b = other ? *other : a;
    const Costs costs = measure_costs(a, b, scene.scenarios, options.rounds);
    const Sha256 digest = digest_of(a, b, scene.scenarios);
    if (scene.first.box_tests == 0) {
        scene.first = costs;
        scene.expected = digest;
    }
    scene.same = scene.same && digest == scene.expected;
    const double bytes =
        static_cast<double>(a.nodes().size_bytes() + a.triangle_ids().size_bytes());
    std::printf("| %s | %zu | %u | %.2f %% | %.1f | %.0f | %.0f | %.1f | %.1f | %.3f | %s |\n",
                name,
                a.nodes().size(),
                a.depth(),
                100 * largest_share(a, options.depth),
                bytes / static_cast<double>(a.triangle_ids().size()),
                costs.box_tests,
                costs.triangle_tests,
                costs.box_nanoseconds,
                costs.triangle_nanoseconds,
                1e-6 * (costs.box_tests * scene.first.box_nanoseconds +
                        costs.triangle_tests * scene.first.triangle_nanoseconds),
                to_short_hex(digest).c_str());
    std::fflush(stdout);
}

/// Returns nothing, with a line on stderr, if a file cannot be read.
std::optional<Scene> make_scene(const Options& options) {
    const auto trees = bench::load(options.bodies);
    if (!trees) {
        return std::nullopt;
    }
    Scene scene;
    scene.a = trees->mesh_a;
    scene.b = trees->mesh_b;
    for (const PosePair& poses : trees->poses) {
        scene.scenarios.push_back({scene.scenarios.size(), 0, 1, poses});
    }
    return scene;
}

/// Prints a row for each of the two bodies; one if they are the same.
template <class Print>
void print_each(const Options& options, const Scene& scene, const Print& print) {
    print(options.bodies.a, scene.a, options.rounds);
    if (scene.b != scene.a) {
        print(options.bodies.b, scene.b, options.rounds);
    }
}

int compare(const Options& options) {
    std::optional<Scene> scene = make_scene(options);
    if (!scene) {
        return 2;
    }
    std::printf(
        "| mesh | triangles | connections ms | processor ms | build ms, 1 thread | processor "
        "ms | 2 threads | processor ms | with the wide tree, 1 thread | processor ms | 2 "
        "threads | processor ms |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    print_each(options, *scene, print_build_times);
    std::printf(
        "\n| mesh | triangles | binary MB | keep ms | processor ms | find ms | processor ms | wide "
        "MB "
        "| keep ms | processor ms | find ms | processor ms | first search ms, found | processor ms "
        "| built | processor ms "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
        "\n");
    print_each(options, *scene, print_kept_times);
    std::printf(
        "\n| mesh | triangles | build ms, 1 thread | processor ms | points ms | processor ms | "
        "share | processor share | build ms, 2 threads | processor ms | points ms | processor ms | "
        "share | processor share | mean eps/radius | root eps/radius | bytes/triangle "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    print_each(options, *scene, print_points);
    std::printf("\n%zu scenarios, distribution depth %u\n\n"
                "| tree | nodes | depth | largest root | bytes/triangle | N_b | N_p | C_b ns | C_p "
                "ns | cost ms | digest |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
                scene->scenarios.size(),
                options.depth);
    BuildOptions binned;
    binned.prepare_search = false;
    measure("OBB, quarter, binned", binned, options, *scene);
    BuildOptions swept = binned;
    swept.sweep_triangles_max = std::numeric_limits<std::uint32_t>::max();
    measure("OBB, quarter, swept", swept, options, *scene);
    BuildOptions aabb = binned;
    aabb.boxes = BoxKind::Aabb;
    measure("AABB, quarter, binned", aabb, options, *scene);
    if (!options.skips_bare) {
        BuildOptions bare = binned;
        bare.rule = SplitRule::Bare;
        measure("OBB, bare, swept", bare, options, *scene);
    }
    measure("OBB, quarter, binned; wide search", {}, options, *scene);
    return scene->same ? 0 : 1;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    cd::Options options;
    CLI::App app("Compares the rules by which OBB trees are built");
    options.bodies.add_to(app);
    app.add_option("--rounds", options.rounds, "How often each is timed")
        ->check(CLI::PositiveNumber);
    app.add_option("--depth", options.depth, "Distribution depth of the share");
    app.add_flag("--no-bare", options.skips_bare, "Leave out the bare rule, which is slow");
    CLI11_PARSE(app, argc, argv);
    return cd::compare(options);
}
