// Measures the broad phase of one step of a scene: the boxes of all bodies in the world, and the
// pairs of them that overlap.
//
//   scene_sweep_bench [OPTIONS OF GOOGLE BENCHMARK...]
//
// `town` is cars on streets, 4.5 by 1.8 by 1.5 m, 10 m apart on average; `assembly` is parts of
// many sizes in a cube that they fill eight times over. The label gives the number of pairs.
#include "bench/box_crowds.hpp"
#include "common/scene/box_sweep.hpp"
#include "common/scene/world_boxes.hpp"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace cd::bench {

namespace {

void measure(benchmark::State& state, const std::vector<PosedBox>& bodies) {
    std::size_t pairs = 0;
    for ([[maybe_unused]] auto _ : state) {
        WorldBoxes boxes(bodies.size());
        for (const PosedBox& body : bodies) {
            boxes.add(body.box, body.pose);
        }
        pairs = overlapping_pairs(boxes.take()).size();
    }
    state.SetLabel(std::to_string(pairs) + " pairs");
}

void town(benchmark::State& state) {
    measure(state, make_town(static_cast<std::size_t>(state.range(0))));
}

void assembly(benchmark::State& state) {
    measure(state, make_assembly(static_cast<std::size_t>(state.range(0))));
}

BENCHMARK(town)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(assembly)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

} // namespace

} // namespace cd::bench

BENCHMARK_MAIN();
