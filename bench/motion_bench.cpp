// Measures the search over cells along motions of one body onto another, and past it.
//
//   motion_bench MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 25] [--planes]
//                [--length 3] [--degrees 30] [--resolution 0.0005] [--clearance X] [--rounds 5]
//                [--cut DEPTH]
//
// Each pose gives two paths of the given length, on each of which B turns by the given angle about
// the world's z axis: `onto` ends at the pose, coming from where A's centre is behind B; `past`
// goes sideways through the pose moved away from A by a fiftieth of B's diagonal. Prints for both
// kinds, and for each way to end, the mean, median and largest of the paths' least times, the mean
// number of cells, and a checksum of the answers, which does not depend on --cut.
#include "common/motion/motion.hpp"

#include "bench/motion_paths.hpp"
#include "bench/posed_trees.hpp"
#include "bench/timed_work.hpp"
#include "common/core/errors.hpp"
#include "common/motion/tree_questions.hpp"
#include "tests/support/cut_trees.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    PosedTreesOptions trees;
    MotionPathOptions paths;
    std::optional<double> clearance;
    int rounds = 5;
    std::uint32_t cut = 0;
};

/// A motion, and what its search has found and cost.
struct Path {
    std::string kind;
    Motion motion;
    MotionAnswer answer = {};
    double seconds = std::numeric_limits<double>::infinity();
};

Status add_paths(const MotionPaths& maker,
                 const PosePair& poses,
                 double resolution,
                 std::vector<Path>& paths) {
    const std::vector<KeyedPath> keyed = CD_TRY(maker.paths_of(poses));
    for (const KeyedPath& path : keyed) {
        paths.push_back(
            {path.kind, CD_TRY(Motion::create(path.from, path.to, maker.radii(), resolution))});
    }
    return Done{};
}

void measure(const PosedTrees& trees, const Options& options, std::vector<Path>& paths) {
    const SubtreePair whole{trees.a.view(), trees.b.view()};
    const tests::CutTrees cut_trees(trees.a, trees.b, options.cut);
    const CutBodies cut = cut_trees.bodies();
    const MovingTrees bodies = options.cut == 0 ? MovingTrees(whole) : MovingTrees(&cut);
    const double clearance = options.clearance.value_or(0);
    const auto search = make_search(whole.a, whole.b, PosePair{}, {}, {.clearance = clearance});
    TreeQuestions tree_questions(*search, bodies, options.clearance);
    const CellQuestions questions = tree_questions.for_cells();
    for (int round = 0; round < options.rounds; ++round) {
        for (Path& path : paths) {
            const double start = processor_seconds();
            path.answer = search_cells(path.motion, Until::Contact, clearance, questions);
            path.seconds = std::min(path.seconds, processor_seconds() - start);
        }
    }
}

const char* to_text(MotionEnd end) {
    constexpr std::array names{"free", "contact", "start", "limit"};
    return names[static_cast<std::size_t>(end)];
}

/// Prints the row of the paths of one kind that ended in one way, if there are any.
void print(const std::vector<Path>& paths, const std::string& kind, MotionEnd end) {
    std::vector<double> seconds;
    double sum = 0;
    double cells = 0;
    Checksum checksum;
    for (const Path& path : paths) {
        if (path.kind == kind && path.answer.end == end) {
            seconds.push_back(path.seconds);
            sum += path.seconds;
            cells += path.answer.cells;
            checksum.add(path.answer.t0);
            checksum.add(path.answer.t1);
        }
    }
    if (seconds.empty()) {
        return;
    }
    const auto count = static_cast<double>(seconds.size());
    std::sort(seconds.begin(), seconds.end());
    std::printf("%-5s %-8s %4.0f paths  mean %8.3f ms  median %8.3f ms  most %8.3f ms  "
                "cells %8.1f  checksum %.0f\n",
                kind.c_str(),
                to_text(end),
                count,
                1e3 * sum / count,
                1e3 * seconds[seconds.size() / 2],
                1e3 * seconds.back(),
                cells / count,
                checksum.value());
}

int run(const Options& options) {
    const std::optional<PosedTrees> trees = load(options.trees);
    if (!trees) {
        return 1;
    }
    const MotionPaths maker(*trees->mesh_a, *trees->mesh_b, options.paths);
    std::vector<Path> paths;
    for (const PosePair& poses : trees->poses) {
        const Status added = add_paths(maker, poses, options.paths.resolution, paths);
        if (!added) {
            std::fprintf(stderr, "%s\n", added.error().detail.c_str());
            return 1;
        }
    }
    measure(*trees, options, paths);
    for (const char* const kind : {"onto", "past"}) {
        for (const auto end :
             {MotionEnd::Contact, MotionEnd::Free, MotionEnd::Start, MotionEnd::Limit}) {
            print(paths, kind, end);
        }
    }
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.trees.random = 25;
    CLI::App app("Measures searches along motions.");
    options.trees.add_to(app);
    app.add_option("--length", options.paths.length, "Of each path, in A's unit")
        ->capture_default_str();
    app.add_option("--degrees", options.paths.degrees, "B's turn on each path")
        ->capture_default_str();
    app.add_option("--resolution", options.paths.resolution, "In A's unit")->capture_default_str();
    app.add_option("--clearance", options.clearance, "Without it the event is contact");
    app.add_option("--cut", options.cut, "Cut both trees at this depth, as for workers; 0: whole")
        ->capture_default_str();
    app.add_option("--rounds", options.rounds, "The least time of each path counts")
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return cd::bench::run(options);
}
