#include "common/job/shots/stable_order.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace cd::tests {

TEST(StableOrder, IsThatOfASortByComparison) {
    StableOrder order;
    for (SeededRandom random : seeds(raised(60))) {
        std::vector<std::uint32_t> keys(random() % 2000);
        const std::uint32_t mask = 0xffffffffu >> random() % 32;
        std::ranges::generate(keys, [&] { return static_cast<std::uint32_t>(random()) & mask; });
        std::vector<std::uint32_t> expected(keys.size());
        std::iota(expected.begin(), expected.end(), 0u);
        std::ranges::stable_sort(expected, {}, [&](std::uint32_t i) { return keys[i]; });
        ASSERT_TRUE(std::ranges::equal(order.of(keys), expected)) << keys.size();
    }
}

} // namespace cd::tests
