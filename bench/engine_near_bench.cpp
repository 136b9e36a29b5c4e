// Measures clearance and distance queries of two trees under real or random poses.
//
//   engine_near_bench MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 50] [--planes]
//                     [--clearance 0.01] [--rounds 5]
//
// Each kind of query runs over all poses in turn, `rounds` times; the kinds take turns. Prints for
// each kind the mean over the poses of their least times, the median, and mean counts. `near?` asks
// whether any pair is within the clearance, `near` collects all such pairs and contacts, `distance`
// finds the nearest pair where no pair touches. Rows of poses in contact and of others are apart.
#include "bench/posed_trees.hpp"
#include "bench/timed_work.hpp"
#include "common/search/wide_search.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    PosedTreesOptions trees;
    double clearance = 0.01;
    int rounds = 5;
};

/// What a query of one pose finds and costs.
struct Found {
    double answer = 0;
    std::uint64_t tests = 0;
};

struct Kind {
    std::string name;
    std::function<Found(const PosePair&)> ask;
    std::vector<double> seconds; ///< Least of each pose.
    std::vector<Found> found;
};

std::vector<Kind> kinds_of(const PosedTrees& trees, const Options& options) {
    const auto search_with = [&](const SearchOptions& with) {
        return std::make_shared<WideSearch>(trees.poses[0], std::span<const IgnoredRange>(), with);
    };
    const TreeView a = trees.a.view();
    const TreeView b = trees.b.view();
    SearchOptions near{.keep_pairs = true};
    near.clearance = options.clearance;
    SearchOptions nearest;
    nearest.nearest_up_to = std::numeric_limits<double>::infinity();
    std::vector<Kind> kinds;
    const auto add = [&](const char* name, const SearchOptions& with, auto ask) {
        kinds.push_back({name,
                         [search = search_with(with), ask](const PosePair& poses) {
                             search->restart(poses);
                             return ask(*search);
                         },
                         {},
                         {}});
    };
    const auto tests = [](ContactSearch& search) {
        return search.report().statistics.triangle_tests;
    };
    add("touch?", {}, [=](ContactSearch& search) {
        const double answer = search.any(a, b) ? 1 : 0;
        return Found{answer, tests(search)};
    });
    add("near?", near, [=](ContactSearch& search) {
        const double answer = search.any_near(a, b) == Nearness::Far ? 0 : 1;
        return Found{answer, tests(search)};
    });
    add("near", near, [=](ContactSearch& search) {
        search.collect(a, b);
        const FoundContacts& found = search.contacts();
        return Found{static_cast<double>(found.count() + found.near_count()), tests(search)};
    });
    add("distance", nearest, [=](ContactSearch& search) {
        if (search.any(a, b)) {
            return Found{0, 0};
        }
        search.find_nearest(a, b);
        return Found{search.nearest().best()->distance, search.nearest().triangle_tests()};
    });
    return kinds;
}

void measure(const PosedTrees& trees, int rounds, std::vector<Kind>& kinds) {
    for (Kind& kind : kinds) {
        kind.seconds.assign(trees.poses.size(), std::numeric_limits<double>::infinity());
        kind.found.resize(trees.poses.size());
    }
    for (int round = 0; round < rounds; ++round) {
        for (Kind& kind : kinds) {
            for (std::size_t i = 0; i < trees.poses.size(); ++i) {
                const double start = processor_seconds();
                kind.found[i] = kind.ask(trees.poses[i]);
                kind.seconds[i] = std::min(kind.seconds[i], processor_seconds() - start);
            }
        }
    }
}

/// Prints a kind's row for the poses whose bodies touch, or for the others.
void print(const Kind& kind, const Kind& touching, bool touch) {
    std::vector<double> seconds;
    double answers = 0;
    double tests = 0;
    for (std::size_t i = 0; i < kind.seconds.size(); ++i) {
        if ((touching.found[i].answer != 0) == touch) {
            seconds.push_back(kind.seconds[i]);
            answers += kind.found[i].answer;
            tests += static_cast<double>(kind.found[i].tests);
        }
    }
    if (seconds.empty()) {
        return;
    }
    const auto count = static_cast<double>(seconds.size());
    double sum = 0;
    for (const double s : seconds) {
        sum += s;
    }
    std::sort(seconds.begin(), seconds.end());
    std::printf(
        "%-10s %-8s %5.0f poses  mean %9.2f us  median %9.2f us  answer %12.5g  tests %9.1f\n",
        kind.name.c_str(),
        touch ? "contact" : "apart",
        count,
        1e6 * sum / count,
        1e6 * seconds[seconds.size() / 2],
        answers / count,
        tests / count);
}

int run(const Options& options) {
    const std::optional<PosedTrees> trees = load(options.trees);
    if (!trees) {
        return 1;
    }
    std::vector<Kind> kinds = kinds_of(*trees, options);
    measure(*trees, options.rounds, kinds);
    for (const bool touch : {false, true}) {
        for (const Kind& kind : kinds) {
            print(kind, kinds.front(), touch);
        }
    }
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Measures clearance and distance queries.");
    options.trees.add_to(app);
    app.add_option("--clearance", options.clearance, "In A's unit")->capture_default_str();
    app.add_option("--rounds", options.rounds, "The least time of each pose counts")
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return cd::bench::run(options);
}
