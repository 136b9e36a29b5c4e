#include "master/dispatch/cost_model.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

// Two surfaces meet along curves, and about sqrt(n) of a subtree's n triangles lie along one.
// The level, the number of pairs or of box tests, and other powers predict no better.
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
    // Fitted by `bench/cluster/fit_costs` to the traces of bench/cluster/run. A job's sum is within
    // 0.3 to 1 of the measured time at depths 2 to 14, best at 4 to 10. A scenario deviates from
    // its job's ratio by a factor of e^0.27 (large depths) to e^0.77.
    constexpr double scenario_ns = 10'000;
    constexpr double size_ns = 84;
    return static_cast<std::uint64_t>(scenario_ns + size_ns * meeting_size);
}

} // namespace cd
