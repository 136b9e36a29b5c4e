// Measures what a call of the C++ library with one pose costs beside the engine.
//
//   library_call_bench MESH_A [MESH_B] [--unit-a 1] [--poses FILE | --random 50] [--rounds 5]
//
// The engine and the library answer each pose in turn at level any, on this thread. Prints for both
// the median over the poses of their least times, and the median difference.
#include "bench/posed_trees.hpp"
#include "bench/timed_work.hpp"
#include "common/job/run_scenario.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    PosedTreesOptions trees;
    int rounds = 5;
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

std::vector<double> numbers_of(const Pose& pose) {
    const Vec3& t = pose.translation();
    if (pose.kind() == Pose::Kind::Quaternion) {
        const Quaternion& q = pose.quaternion();
        return {t[0], t[1], t[2], q.w, q.x, q.y, q.z};
    }
    std::vector<double> numbers;
    for (int row = 0; row < 3; ++row) {
        const Mat3& r = pose.matrix();
        numbers.insert(numbers.end(), {r(row, 0), r(row, 1), r(row, 2), t[row]});
    }
    return numbers;
}

int measure(const PosedTrees& trees, int rounds) {
    Query query;
    query.level = Level::Any;
    const ScenarioRunner runner(trees.a, trees.b, query);
    ScenarioSession session(runner);
    const auto a = cdcluster::Mesh::from_canonical_bytes(trees.mesh_a->canonical_bytes());
    const auto b = cdcluster::Mesh::from_canonical_bytes(trees.mesh_b->canonical_bytes());
    cdcluster::Query asked;
    asked.level = cdcluster::Level::Any;
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> engine(trees.poses.size(), never);
    std::vector<double> library(trees.poses.size(), never);
    for (int round = 0; round <= rounds; ++round) { // The first one warms up.
        for (std::size_t i = 0; i < trees.poses.size(); ++i) {
            Scenario scenario;
            scenario.poses = trees.poses[i];
            const double start = processor_seconds();
            const ScenarioRun run = session.run(scenario);
            const double middle = processor_seconds();
            const std::vector<double> numbers = numbers_of(trees.poses[i].b);
            const cdcluster::Poses poses{numbers,
                                         numbers.size() == 7 ? cdcluster::PoseForm::Wxyz
                                                             : cdcluster::PoseForm::Matrix34};
            const double begin = processor_seconds();
            const auto results = cdcluster::find_contacts(a, b, poses, asked);
            const double end = processor_seconds();
            if (is_contact(run.result.kind) != results.is_hit(0)) {
                std::fprintf(stderr, "pose %zu: the answers differ\n", i);
                return 1;
            }
            if (round > 0) {
                engine[i] = std::min(engine[i], middle - start);
                library[i] = std::min(library[i], end - begin);
            }
        }
    }
    std::vector<double> more(engine.size());
    std::ranges::transform(library, engine, more.begin(), std::minus());
    std::printf("one pose a call, %zu poses: engine %.2f us, library %.2f us, median difference "
                "%.2f us\n",
                engine.size(),
                1e6 * median(engine),
                1e6 * median(library),
                1e6 * median(more));
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    CLI::App app("Measures what the C++ library costs beside the engine.");
    cd::bench::Options options;
    options.trees.add_to(app);
    app.add_option("--rounds", options.rounds, "The least time of each pose counts")
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    const auto trees = cd::bench::load(options.trees);
    return trees ? cd::bench::measure(*trees, options.rounds) : 2;
}
