#include "master/dispatch/cost_model.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

// Two surfaces meet along curves, and a subtree of n triangles has some sqrt(n) of them along one.
// Levels, pairs, box tests of the analysis, and other powers predict no better.
double meeting_size(const TreeTop& a, const TreeTop& b, std::span<const RootPair> pairs) {
    double size = 0;
    for (const RootPair& pair : pairs) {
        const std::uint32_t smaller =
            std::min(a.triangles_under(pair.a), b.triangles_under(pair.b));
        size += std::sqrt(static_cast<double>(smaller));
    }
    return size;
}

std::uint64_t predicted_ns(double meeting_size) {
    // From `bench/cluster/fit_costs` over the traces of bench/cluster/run. The sum over a job is
    // then right within 0.3 to 1 of what is measured at depths 2 to 14, best at 4 to 10; a
    // scenario's deviation from its job's ratio is a factor of e^0.27 (large depths) to e^0.77.
    constexpr double scenario_ns = 10'000;
    constexpr double size_ns = 84;
    return static_cast<std::uint64_t>(scenario_ns + size_ns * meeting_size);
}

} // namespace cd
