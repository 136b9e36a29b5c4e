// Measures the broad phase of one step of a scene: the boxes of all bodies in the world, and the
// pairs of them that overlap.
//
//   scene_sweep_bench [OPTIONS OF GOOGLE BENCHMARK...]
//
// `town` is cars on streets, 4.5 by 1.8 by 1.5 m, 10 m apart on average; `assembly` is parts of
// many sizes in a cube that they fill eight times over. The label gives the number of pairs.
#include "common/scene/box_sweep.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

struct PosedBox {
    Aabb box;
    Pose pose;
};

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(random() >> 11);
}

Aabb box_of(const Vec3& size) {
    Aabb box;
    box.add(-0.5 * size);
    box.add(0.5 * size);
    return box;
}

/// Returns `count` cars on a square, each along x or y, or turned by a few degrees.
std::vector<PosedBox> make_town(std::size_t count) {
    std::mt19937_64 random(1);
    const double side = 10 * std::sqrt(static_cast<double>(count));
    std::vector<PosedBox> cars;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = (random() % 2 == 0 ? 0 : 0.7071) + uniform(random, -0.05, 0.05);
        cars.push_back(
            {box_of(Vec3(4.5, 1.8, 1.5)),
             Pose::from_quaternion({std::sqrt(1 - turn * turn), 0, 0, turn},
                                   Vec3(uniform(random, 0, side), uniform(random, 0, side), 0))});
    }
    return cars;
}

/// Returns `count` turned parts, of sizes from 1 to 30 cm.
std::vector<PosedBox> make_assembly(std::size_t count) {
    std::mt19937_64 random(2);
    const double side = 0.1 * std::cbrt(static_cast<double>(count));
    std::vector<PosedBox> parts;
    for (std::size_t i = 0; i < count; ++i) {
        const auto size = [&] { return 0.01 * std::pow(30, uniform(random, 0, 1)); };
        const auto place = [&] { return uniform(random, 0, side); };
        const auto turn = [&] { return uniform(random, -1, 1); };
        parts.push_back({box_of(Vec3(size(), size(), size())),
                         Pose::from_quaternion({turn(), turn(), turn(), turn()},
                                               Vec3(place(), place(), place()))});
    }
    return parts;
}

void measure(benchmark::State& state, const std::vector<PosedBox>& bodies) {
    std::vector<WorldBox> boxes(bodies.size());
    std::size_t pairs = 0;
    for ([[maybe_unused]] auto _ : state) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            boxes[i] = world_box(bodies[i].box, bodies[i].pose);
        }
        pairs = overlapping_pairs(boxes).size();
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
