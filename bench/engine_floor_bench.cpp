// Measures the three kernels that every search needs, in their barest form, with all data in the
// first cache, on each SIMD target: a lower bound for queries.
//
//   engine_floor_bench [--benchmark_...]
//
// `boxes`, `sides` and `decision` are those of floor_kernels.hpp; `each` is the time of one test.
// The program fails unless the checksum (over the numbers of tests and of inputs left) is equal for
// all targets.
#include "bench/floor_kernels.hpp"
#include "bench/timed_work.hpp"
#include "common/geometry/simd_target.hpp"

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace cd::bench {

namespace {

struct Kernel {
    const char* name;
    FloorCounts (FloorKernels::*run)();
};

constexpr Kernel kernels[] = {{"boxes", &FloorKernels::boxes},
                              {"sides", &FloorKernels::sides},
                              {"decision", &FloorKernels::decision}};

void run(benchmark::State& state,
         const Kernel& kernel,
         SimdTarget target,
         std::map<std::string, double>& checksums) {
    static_cast<void>(force_simd_target(to_text(target)));
    FloorKernels data;
    FloorCounts counts;
    for (auto _ : state) {
        counts = (data.*kernel.run)();
        benchmark::DoNotOptimize(counts);
    }
    Checksum checksum;
    checksum.add(counts.looked_at);
    checksum.add(counts.left);
    using benchmark::Counter;
    state.counters["each"] = Counter(static_cast<double>(counts.looked_at),
                                     Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["left"] = static_cast<double>(counts.left);
    state.counters["checksum"] = checksum.value();
    const auto [first, is_first] = checksums.emplace(kernel.name, checksum.value());
    if (!is_first && first->second != checksum.value()) {
        checksums["differs"] = 1;
        state.SkipWithError("the checksum differs");
    }
    static_cast<void>(force_simd_target("auto"));
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::map<std::string, double> checksums;
    for (const cd::SimdTarget target : cd::available_simd_targets()) {
        for (const auto& kernel : cd::bench::kernels) {
            const std::string name = kernel.name + ("/" + std::string(to_text(target)));
            benchmark::RegisterBenchmark(name.c_str(), [&, target](auto& state) {
                cd::bench::run(state, kernel, target, checksums);
            })->Unit(benchmark::kMicrosecond);
        }
    }
    benchmark::RunSpecifiedBenchmarks();
    return checksums.contains("differs") ? 1 : 0;
}
