#include "client/groups/wilson.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

ShareInterval wilson_interval(std::uint64_t hits, std::uint64_t trials) {
    if (trials == 0) {
        return {};
    }
    constexpr double z = 1.959963984540054; // The normal distribution has 95 % within -z to z.
    const auto n = static_cast<double>(trials);
    const double share = static_cast<double>(hits) / n;
    const double scale = 1 + z * z / n;
    const double centre = (share + z * z / (2 * n)) / scale;
    const double half = z / scale * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    return {hits == 0 ? 0 : std::max(0.0, centre - half),
            hits == trials ? 1 : std::min(1.0, centre + half)};
}

} // namespace cd
