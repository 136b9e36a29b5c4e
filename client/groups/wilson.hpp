// Confidence intervals of shares that are counted in random scenarios.
#pragma once

#include <cstdint>

namespace cd {

/// A range of shares, each between 0 and 1.
struct ShareInterval {
    double low = 0;
    double high = 1;
};

/// Returns the Wilson score interval at 95 % (Wilson, Probable inference, the law of succession,
/// and statistical inference, JASA 1927) of a share: `hits` of `trials` independent scenarios.
/// Without trials it is [0, 1].
[[nodiscard]] ShareInterval wilson_interval(std::uint64_t hits, std::uint64_t trials);

} // namespace cd
