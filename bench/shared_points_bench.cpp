// Measures the shared points of a pair, for the contacts of each category of hard pairs and of each
// hard scene of two meshes: by the path that SharedPoints chooses, and all in arbitrary integers.
//
//   shared_points_bench [--pairs 200] [--scene-pairs 3000] [--rounds 5]
//
// Prints a Markdown row per set: pairs, ns per pair by both paths with the origin (least of the
// rounds), pairs on the fast path, and whether all points have equal bits.
#include "common/pair/points/shared_points.hpp"

#include "common/search/contact_search.hpp"
#include "common/tree/build/build.hpp"
#include "tests/corpus/pairs.hpp"
#include "tests/corpus/scenes.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace cd {

namespace {

struct Options {
    std::uint64_t pairs = 200;
    std::size_t scene_pairs = 3000;
    int rounds = 5;
};

/// Pairs in contact; pairs under equal poses are adjacent.
struct Group {
    PosePair poses;
    std::vector<PairCorners> pairs;
};

struct Timing {
    double nanoseconds = std::numeric_limits<double>::infinity();
    std::vector<Vec3> points;
    std::uint64_t fast = 0;
};

Timing measure(const std::vector<Group>& groups, SharedPoints::Path path, int rounds) {
    Timing timing;
    std::size_t count = 0;
    for (int round = 0; round < rounds; ++round) {
        timing.points.clear();
        timing.fast = 0;
        count = 0;
        double seconds = 0;
        for (const Group& group : groups) {
            SharedPoints shared(group.poses, path);
            (void)shared.points(group.pairs[0].a,
                                group.pairs[0].b); // Builds what is built on first use, untimed.
            const std::uint64_t fast_before = shared.statistics().points_fast;
            const auto start = std::chrono::steady_clock::now();
            for (const auto& [a, b] : group.pairs) {
                timing.points.push_back(shared.origin(a));
                const auto points = shared.points(a, b);
                timing.points.insert(timing.points.end(), points.begin(), points.end());
            }
            seconds +=
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            timing.fast += shared.statistics().points_fast - fast_before;
            count += group.pairs.size();
        }
        timing.nanoseconds =
            std::min(timing.nanoseconds, 1e9 * seconds / static_cast<double>(count));
    }
    return timing;
}

void print_row(const std::string& name, const std::vector<Group>& groups, int rounds) {
    std::size_t count = 0;
    for (const Group& group : groups) {
        count += group.pairs.size();
    }
    if (count == 0) {
        return;
    }
    const Timing any = measure(groups, SharedPoints::Path::Any, rounds);
    const Timing exact = measure(groups, SharedPoints::Path::Exact, 2);
    std::printf("| %s | %zu | %.0f | %.0f | %llu | %s |\n",
                name.c_str(),
                count,
                any.nanoseconds,
                exact.nanoseconds,
                static_cast<unsigned long long>(any.fast),
                any.points == exact.points ? "yes" : "NO");
}

Group contacts_of(const tests::Scene& scene, std::size_t pairs_max, ThreadPool& pool) {
    const ObbTree a = build_tree(scene.a.mesh, {}, pool);
    const ObbTree b = build_tree(scene.b.mesh, {}, pool);
    SearchOptions options;
    options.keep_corners = true;
    options.pairs_max = pairs_max;
    const auto search = make_search(a.view(), b.view(), scene.poses, {}, options);
    search->collect(a.view(), b.view());
    search->contacts().sort();
    return {scene.poses, search->contacts().corners()};
}

int run(const Options& options) {
    std::puts("| set | pairs | as it does, ns | in integers, ns | fast | same bits |\n"
              "|---|---|---|---|---|---|");
    for (const std::string& category : tests::pair_categories()) {
        std::vector<Group> groups;
        for (std::uint64_t seed = 0; seed < options.pairs; ++seed) {
            const tests::PosedPair pair = tests::corpus_pair(category, seed);
            if (TrianglePairTest(pair.poses).classify(pair.a, pair.b) != PairClass::Separate) {
                groups.push_back({pair.poses, {{pair.a, pair.b}}});
            }
        }
        print_row(category, groups, options.rounds);
    }
    ThreadPool pool(1);
    for (const tests::Scene& scene : tests::corpus_scenes()) {
        Group group = contacts_of(scene, options.scene_pairs, pool);
        if (!group.pairs.empty()) {
            print_row("scene: " + scene.name, {std::move(group)}, options.rounds);
        }
    }
    return 0;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    cd::Options options;
    CLI::App app{"What the shared points of a pair cost"};
    app.add_option("--pairs", options.pairs, "of each category, before those apart are left out");
    app.add_option("--scene-pairs", options.scene_pairs, "of each scene at the most");
    app.add_option("--rounds", options.rounds, "the least of which counts");
    CLI11_PARSE(app, argc, argv);
    return cd::run(options);
}
