// What does a tie cost? Times the decision of hard pairs by category, each pair with its own poses,
// and of the candidates of stacked boxes, where ties are the normal case: each from stage Double
// on, from Lattice, from DoubleDouble, from WideInteger and from Arbitrary.
//
//   engine_exact_bench [--pairs 300] [--cells 6] [--rounds 5]
//
// A Markdown row a set: pairs, nanoseconds a pair from each of those stages (the least of the
// rounds, without making the poses' tests), the pairs that each stage settled when all stages may,
// and the sum of the classes, which must be one in all columns.
#include "common/geometry/aabb.hpp"
#include "common/geometry/triangle_pair.hpp"
#include "tests/corpus/pairs.hpp"
#include "tests/support/shapes.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace cd {

namespace {

struct Options {
    std::uint64_t pairs = 300;
    int cells = 6;
    int rounds = 5;
};

constexpr std::array stages{PairStage::Double,
                            PairStage::Lattice,
                            PairStage::DoubleDouble,
                            PairStage::WideInteger,
                            PairStage::Arbitrary};

/// The pairs of one set; those under one pair of poses stand together.
struct Group {
    PosePair poses;
    std::vector<std::pair<Corners, Corners>> pairs;
};

struct Timing {
    double nanoseconds = std::numeric_limits<double>::infinity();
    std::uint64_t class_sum = 0;
    PairStatistics statistics;
};

Timing measure(const std::vector<Group>& groups, PairStage first, int rounds) {
    std::vector<TrianglePairTest> tests;
    std::size_t count = 0;
    for (const Group& group : groups) {
        tests.emplace_back(group.poses, first);
        count += group.pairs.size();
    }
    Timing timing;
    for (int round = 0; round <= rounds; ++round) { // The first makes what is made once.
        const auto start = std::chrono::steady_clock::now();
        timing.class_sum = 0;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            for (const auto& [a, b] : groups[i].pairs) {
                timing.class_sum += static_cast<std::uint64_t>(tests[i].classify(a, b));
            }
        }
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (round == 0) {
            for (const TrianglePairTest& test : tests) {
                timing.statistics += test.statistics();
            }
        } else {
            timing.nanoseconds =
                std::min(timing.nanoseconds, 1e9 * seconds / static_cast<double>(count));
        }
    }
    return timing;
}

/// Prints one row; returns the time from stage Double on.
double print_row(const std::string& name, const std::vector<Group>& groups, int rounds) {
    std::size_t count = 0;
    for (const Group& group : groups) {
        count += group.pairs.size();
    }
    std::printf("| %s | %zu |", name.c_str(), count);
    double from_double = 0;
    PairStatistics statistics;
    std::string sums;
    for (const PairStage first : stages) {
        // Arbitrary precision takes long, and once is enough to see that.
        const Timing timing = measure(groups, first, first == PairStage::Arbitrary ? 1 : rounds);
        std::printf(" %.0f |", timing.nanoseconds);
        sums += (sums.empty() ? "" : " ") + std::to_string(timing.class_sum);
        if (first == PairStage::Double) {
            from_double = timing.nanoseconds;
            statistics = timing.statistics;
        }
    }
    for (const PairStage stage : stages) {
        std::printf(" %llu |", static_cast<unsigned long long>(statistics[stage]));
    }
    std::printf(" %s |\n", sums.c_str());
    return from_double;
}

Mesh scaled(const Mesh& mesh, double factor, bool to_float) {
    std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
    for (Vec3& vertex : vertices) {
        vertex *= factor;
        if (to_float) {
            vertex = Vec3(vertex.cast<float>().cast<double>());
        }
    }
    return tests::make_mesh(std::move(vertices),
                            {mesh.triangles().begin(), mesh.triangles().end()});
}

/// The pairs of triangles whose boxes overlap in the world, or nearly.
Group candidates(const Mesh& a, const Mesh& b, const PosePair& poses) {
    const auto box_of = [](const Mesh& mesh, const Triangle& triangle, const Pose& pose) {
        Aabb box;
        for (const std::uint32_t vertex : triangle) {
            box.add(pose.apply(mesh.vertices()[vertex]));
        }
        return box;
    };
    Group group{poses, {}};
    for (const Triangle& s : a.triangles()) {
        Aabb box = box_of(a, s, poses.a);
        box.min -= Vec3::Constant(1e-9);
        box.max += Vec3::Constant(1e-9);
        for (const Triangle& t : b.triangles()) {
            if (!are_apart(box, box_of(b, t, poses.b))) {
                group.pairs.push_back(
                    {{a.vertices()[s[0]], a.vertices()[s[1]], a.vertices()[s[2]]},
                     {b.vertices()[t[0]], b.vertices()[t[1]], b.vertices()[t[2]]}});
            }
        }
    }
    return group;
}

/// Two boxes of grids of cells, one on the other and shifted by a cell.
void print_boxes(const Options& options) {
    const auto cells = static_cast<double>(options.cells);
    const Mesh whole = tests::make_gridded_box(Vec3(cells, cells, cells), options.cells);
    Mat3 turn = Mat3::Zero();
    turn(0, 1) = -1;
    turn(1, 0) = turn(2, 2) = 1;
    for (const bool to_float : {false, true}) {
        for (const bool is_dyadic : {true, false}) {
            const double cell = is_dyadic ? 0.125 : 0.1;
            const std::string name =
                std::string(is_dyadic ? "dyadic" : "decimal") + (to_float ? ", float" : ", double");
            const Mesh box = scaled(whole, cell, to_float);
            const Vec3 up(cell, 0, cell * cells);
            const Mesh placed = scaled(tests::translated(whole, Vec3(1, 0, cells)), cell, to_float);
            print_row("boxes, " + name + ", placed", {candidates(box, placed, {})}, options.rounds);
            print_row("boxes, " + name + ", moved",
                      {candidates(box, box, {Pose{}, Pose::from_matrix(Mat3::Identity(), up)})},
                      options.rounds);
            print_row("boxes, " + name + ", turned by a quarter",
                      {candidates(box, box, {Pose{}, Pose::from_matrix(turn, up)})},
                      options.rounds);
        }
    }
}

int run(const Options& options) {
    std::puts(
        "| set | pairs | from double, ns | lattice | double-double | wide integer | arbitrary "
        "| in double | lattice | double-double | wide integer | arbitrary | sums |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    double sum = 0;
    for (const std::string& category : tests::pair_categories()) {
        std::vector<Group> groups;
        for (std::uint64_t seed = 0; seed < options.pairs; ++seed) {
            const tests::PosedPair pair = tests::corpus_pair(category, seed);
            groups.push_back({pair.poses, {{pair.a, pair.b}}});
        }
        sum += print_row(category, groups, options.rounds);
    }
    print_boxes(options);
    std::printf("\nmean of all categories from stage Double on: %.0f ns\n",
                sum / static_cast<double>(tests::pair_categories().size()));
    return 0;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    cd::Options options;
    CLI::App app{"What a tie between two triangles costs"};
    app.add_option("--pairs", options.pairs, "of each category");
    app.add_option("--cells", options.cells, "along an edge of the boxes");
    app.add_option("--rounds", options.rounds, "the least of which counts");
    CLI11_PARSE(app, argc, argv);
    return cd::run(options);
}
