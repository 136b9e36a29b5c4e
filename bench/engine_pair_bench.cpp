// Measures the decision of candidate pairs, and how many the floats settle, on the pairs that the
// trees of two real bodies leave, in the order of a search.
//
//   engine_pair_bench MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 50] [--clearance 0.01]
//                     [--benchmark_...]
//
// FILE holds a pose of B in A's frame per line: the rotation by rows, then the translation. `float`
// is the float stage alone on each SIMD target, including the gathering of corners, from blocks of
// 16 consecutive triangles of the tree; `mesh` reads the mesh's arrays instead. Corners are read
// before the clock starts, except in cold rows. `decision` is the whole decision. `each` is the
// time of one candidate. The checksum of the decisions must be equal for all targets.
//
// `near` asks the candidates that share no point whether they are within the clearance: floats
// alone. `within` is the whole decision, `rounded` the rounded distance.
#include "bench/posed_trees.hpp"
#include "bench/timed_work.hpp"
#include "common/distance/stages/float/float_distance.hpp"
#include "common/distance/triangle_distance.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"
#include "common/tree/wide/candidates_at_once.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

/// Candidates of one pose.
struct Work {
    PosePair poses;
    std::vector<Candidate> candidates;
};

std::size_t count_of(const std::vector<Work>& works) {
    std::size_t sum = 0;
    for (const Work& work : works) {
        sum += work.candidates.size();
    }
    return sum;
}

struct Scene : PosedTrees {
    TriangleBlockArrays blocks_a;
    TriangleBlockArrays blocks_b;
    std::vector<Work> works;
    std::vector<Work> works_apart; ///< The candidates that share no point.
    double clearance = 0;

    [[nodiscard]] std::size_t candidates() const { return count_of(works); }
};

TriangleSpan triangles_of(const ObbTree& tree) {
    return {tree.view().vertices, tree.view().triangles};
}

/// Returns blocks of consecutive triangles of the tree; positions are kept.
TriangleBlockArrays blocks_of(const ObbTree& tree, Precision precision) {
    TriangleBlockArrays blocks(precision);
    const TriangleSpan all = triangles_of(tree);
    for (std::size_t i = 0; i < all.triangles.size(); i += block_size) {
        const std::size_t size = std::min<std::size_t>(block_size, all.triangles.size() - i);
        const std::array<std::uint32_t, block_size> ids{};
        blocks.add(all.triangles.subspan(i, size), std::span(ids).first(size), all.vertices);
    }
    return blocks;
}

void report(benchmark::State& state, std::size_t candidates, const Checksum& checksum) {
    using benchmark::Counter;
    const double all = static_cast<double>(candidates);
    state.counters["each"] = Counter(all, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["candidates"] = all;
    state.counters["checksum"] = checksum.value();
}

template <class OnBlock>
void for_each_block(const Work& work, const OnBlock& on_block) {
    const std::span<const Candidate> all(work.candidates);
    for (std::size_t i = 0; i < all.size(); i += candidates_at_once) {
        on_block(all.subspan(i, std::min(candidates_at_once, all.size() - i)));
    }
}

/// Reads the candidates' corners from the mesh.
struct MeshSource {
    TriangleSpan a;
    TriangleSpan b;

    explicit MeshSource(const Scene& scene) : a(triangles_of(scene.a)), b(triangles_of(scene.b)) {}
    [[nodiscard]] Corners corners_a(std::uint32_t place) const { return a.corners_at(place); }
    [[nodiscard]] Corners corners_b(std::uint32_t place) const { return b.corners_at(place); }
};

struct BlockSource {
    TriangleBlocks a;
    TriangleBlocks b;

    explicit BlockSource(const Scene& scene) : a(scene.blocks_a.view()), b(scene.blocks_b.view()) {}
    [[nodiscard]] Corners corners_a(std::uint32_t place) const { return a.corners_at(place); }
    [[nodiscard]] Corners corners_b(std::uint32_t place) const { return b.corners_at(place); }
};

/// Reads the corners of the candidates.
template <class Source>
void touch(const Source& source, std::span<const Candidate> block) {
    double sum = 0;
    for (const Candidate& candidate : block) {
        for (const Vec3& corner : source.corners_a(candidate.a)) {
            sum += corner.x();
        }
        for (const Vec3& corner : source.corners_b(candidate.b)) {
            sum += corner.x();
        }
    }
    benchmark::DoNotOptimize(sum);
}

enum class Memory { Touched, Cold };

template <class Source>
void run_float(benchmark::State& state, const Scene& scene, SimdTarget target, Memory memory) {
    static_cast<void>(force_simd_target(to_text(target)));
    std::vector<FloatTrianglePair> tests;
    for (const Work& work : scene.works) {
        tests.emplace_back(work.poses);
    }
    const Source source(scene);
    std::vector<FloatVerdict> verdicts(candidates_at_once);
    double spent = 0;
    const auto run = [&](const auto& on_verdicts) {
        for (std::size_t i = 0; i < tests.size(); ++i) {
            if (memory == Memory::Touched) {
                touch(source, scene.works[i].candidates);
            }
            const double start = processor_seconds();
            for_each_block(scene.works[i], [&](std::span<const Candidate> block) {
                const auto some = std::span(verdicts).first(block.size());
                tests[i].classify(source.a, source.b, block, some);
                on_verdicts(some);
            });
            spent += processor_seconds() - start;
        }
    };
    for (auto _ : state) {
        spent = 0;
        run([](std::span<const FloatVerdict> some) { benchmark::DoNotOptimize(some.data()); });
        state.SetIterationTime(spent);
    }
    Checksum checksum;
    std::size_t unknown = 0;
    run([&](std::span<const FloatVerdict> some) {
        checksum.add_all(some);
        unknown +=
            static_cast<std::size_t>(std::count(some.begin(), some.end(), FloatVerdict::Unknown));
    });
    report(state, scene.candidates(), checksum);
    state.counters["unknown_ppm"] =
        1e6 * static_cast<double>(unknown) / static_cast<double>(scene.candidates());
    static_cast<void>(force_simd_target("auto"));
}

void run_decision(benchmark::State& state, const Scene& scene) {
    const BlockSource source(scene);
    std::vector<TrianglePairTest> tests;
    for (const Work& work : scene.works) {
        tests.emplace_back(work.poses);
    }
    const auto run = [&](const auto& on_kinds) {
        for (std::size_t i = 0; i < tests.size(); ++i) {
            for_each_block(scene.works[i], [&](std::span<const Candidate> block) {
                on_kinds(tests[i].classify(source.a, source.b, block));
            });
        }
    };
    for (auto _ : state) {
        run([](std::span<const PairClass> kinds) { benchmark::DoNotOptimize(kinds.data()); });
    }
    Checksum checksum;
    run([&](std::span<const PairClass> kinds) { checksum.add_all(kinds); });
    report(state, scene.candidates(), checksum);
    PairStatistics statistics;
    for (const TrianglePairTest& test : tests) {
        statistics += test.statistics();
    }
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        const auto stage = static_cast<PairStage>(i);
        state.counters[std::string(to_text(stage)) + "_ppm"] =
            1e6 * static_cast<double>(statistics[stage]) / static_cast<double>(statistics.total());
    }
}

void run_near(benchmark::State& state, const Scene& scene, SimdTarget target) {
    static_cast<void>(force_simd_target(to_text(target)));
    const BlockSource source(scene);
    std::vector<FloatDistance> tests;
    for (const Work& work : scene.works_apart) {
        tests.emplace_back(work.poses);
    }
    std::vector<NearVerdict> verdicts(candidates_at_once);
    const auto run = [&](const auto& on_verdicts) {
        for (std::size_t i = 0; i < tests.size(); ++i) {
            for_each_block(scene.works_apart[i], [&](std::span<const Candidate> block) {
                const auto some = std::span(verdicts).first(block.size());
                tests[i].decide(source.a, source.b, block, scene.clearance, some);
                on_verdicts(some);
            });
        }
    };
    for (auto _ : state) {
        run([](std::span<const NearVerdict> some) { benchmark::DoNotOptimize(some.data()); });
    }
    Checksum checksum;
    run([&](std::span<const NearVerdict> some) { checksum.add_all(some); });
    report(state, count_of(scene.works_apart), checksum);
    static_cast<void>(force_simd_target("auto"));
}

/// Times `decide(distance, work, on_answer)` for all candidates that share no point.
template <class Decide>
void run_distance(benchmark::State& state, const Scene& scene, const Decide& decide) {
    std::vector<TriangleDistance> tests;
    for (const Work& work : scene.works_apart) {
        tests.emplace_back(work.poses);
    }
    const auto run = [&](const auto& on_answer) {
        for (std::size_t i = 0; i < tests.size(); ++i) {
            decide(tests[i], scene.works_apart[i], on_answer);
        }
    };
    for (auto _ : state) {
        run([](std::uint64_t answer) { benchmark::DoNotOptimize(answer); });
    }
    Checksum checksum;
    run([&](std::uint64_t answer) { checksum.add(answer); });
    report(state, count_of(scene.works_apart), checksum);
    DistanceStatistics statistics;
    for (const TriangleDistance& test : tests) {
        statistics += test.statistics();
    }
    for (std::size_t i = 0; i < distance_stage_count; ++i) {
        const auto stage = static_cast<DistanceStage>(i);
        state.counters[std::string(to_text(stage)) + "_ppm"] =
            1e6 * static_cast<double>(statistics[stage]) / static_cast<double>(statistics.total());
    }
}

void run_within(benchmark::State& state, const Scene& scene) {
    const BlockSource source(scene);
    run_distance(state, scene, [&](auto& distance, const Work& work, const auto& on_answer) {
        for_each_block(work, [&](std::span<const Candidate> block) {
            for (const std::uint8_t answer :
                 distance.within(source.a, source.b, block, scene.clearance)) {
                on_answer(answer);
            }
        });
    });
}

void run_rounded(benchmark::State& state, const Scene& scene) {
    const BlockSource source(scene);
    run_distance(state, scene, [&](auto& distance, const Work& work, const auto& on_answer) {
        for (const Candidate& c : work.candidates) {
            const double rounded = distance.rounded(source.corners_a(c.a), source.corners_b(c.b));
            on_answer(std::bit_cast<std::uint64_t>(rounded));
        }
    });
}

/// Returns the candidates of each pose that share no point.
std::vector<Work> apart(const Scene& scene) {
    const BlockSource source(scene);
    std::vector<Work> works;
    for (const Work& work : scene.works) {
        TrianglePairTest test(work.poses);
        const auto kinds = test.classify(source.a, source.b, work.candidates);
        works.push_back({work.poses, {}});
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (kinds[i] == PairClass::Separate) {
                works.back().candidates.push_back(work.candidates[i]);
            }
        }
    }
    return works;
}

/// Returns nothing, with a line on stderr, if there is nothing to measure.
std::optional<Scene> make_scene(const PosedTreesOptions& options, double clearance) {
    auto posed = load(options);
    if (!posed) {
        return std::nullopt;
    }
    TriangleBlockArrays blocks_a = blocks_of(posed->a, posed->mesh_a->precision());
    TriangleBlockArrays blocks_b = blocks_of(posed->b, posed->mesh_b->precision());
    Scene scene{std::move(*posed), std::move(blocks_a), std::move(blocks_b), {}, {}, clearance};
    for (const PosePair& pair : scene.poses) {
        scene.works.push_back({pair, candidates_of(scene.a, scene.b, pair)});
    }
    if (scene.candidates() == 0) {
        std::fprintf(stderr, "no candidates under %zu poses\n", scene.poses.size());
        return std::nullopt;
    }
    scene.works_apart = apart(scene);
    return scene;
}

template <class Source>
void register_float(const Scene& scene, const std::string& name, SimdTarget target, Memory memory) {
    benchmark::RegisterBenchmark(
        (name + std::string(to_text(target))).c_str(),
        [&scene, target, memory](auto& state) { run_float<Source>(state, scene, target, memory); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
}

void register_all(const Scene& scene) {
    for (const SimdTarget target : available_simd_targets()) {
        register_float<BlockSource>(scene, "float/", target, Memory::Touched);
        register_float<BlockSource>(scene, "float cold/", target, Memory::Cold);
        register_float<MeshSource>(scene, "mesh/", target, Memory::Touched);
        register_float<MeshSource>(scene, "mesh cold/", target, Memory::Cold);
    }
    benchmark::RegisterBenchmark("decision", [&scene](auto& state) {
        run_decision(state, scene);
    })->Unit(benchmark::kMicrosecond);
    for (const SimdTarget target : available_simd_targets()) {
        benchmark::RegisterBenchmark(
            ("near/" + std::string(to_text(target))).c_str(),
            [&scene, target](auto& state) { run_near(state, scene, target); })
            ->Unit(benchmark::kMicrosecond);
    }
    benchmark::RegisterBenchmark("within", [&scene](auto& state) {
        run_within(state, scene);
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("rounded", [&scene](auto& state) {
        run_rounded(state, scene);
    })->Unit(benchmark::kMicrosecond);
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    cd::bench::PosedTreesOptions options;
    CLI::App app("Times the decision of the candidate pairs of two bodies");
    options.add_to(app);
    double clearance = 0.01;
    app.add_option("--clearance", clearance, "Distance that candidates are compared with");
    CLI11_PARSE(app, argc, argv);
    const auto scene = cd::bench::make_scene(options, clearance);
    if (!scene) {
        return 2;
    }
    cd::bench::register_all(*scene);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
