#include "bench/floor_kernels.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace cd::bench {

FloorTimes measure_floor() {
    FloorKernels kernels;
    const auto best_ns = [&](FloorCounts (FloorKernels::*kernel)()) {
        constexpr int runs = 2000;
        double best = std::numeric_limits<double>::infinity();
        for (int i = 0; i < runs; ++i) {
            const auto start = std::chrono::steady_clock::now();
            const FloorCounts counts = (kernels.*kernel)();
            const std::chrono::duration<double, std::nano> spent =
                std::chrono::steady_clock::now() - start;
            best = std::min(best, spent.count() / static_cast<double>(counts.looked_at));
        }
        return best;
    };
    return {best_ns(&FloorKernels::boxes),
            best_ns(&FloorKernels::sides),
            best_ns(&FloorKernels::decision)};
}

} // namespace cd::bench
