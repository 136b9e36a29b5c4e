#include "common/job/shots/equal_depths.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace cd::tests {

TEST(EqualDepths, AreThoseOfASet) {
    EqualDepths table;
    std::size_t equal = 0;
    std::size_t different = 0;
    for (SeededRandom random : seeds(raised(60))) {
        std::vector<std::uint32_t> lines(random() % 3000);
        std::vector<double> depths(lines.size());
        const std::uint64_t lines_most = 1 + random() % (random() % 2 == 0 ? 4096 : 8);
        const std::uint64_t depths_most = 1 + random() % 512;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            lines[i] = static_cast<std::uint32_t>(random() % lines_most);
            depths[i] = 0.1 + 0x1p-50 * static_cast<double>(random() % depths_most);
        }
        table.restart(lines, depths, lines_most);
        std::set<std::pair<std::uint32_t, double>> seen;
        for (std::uint32_t i = 0; i < lines.size(); ++i) {
            const bool is_new = seen.emplace(lines[i], depths[i]).second;
            const std::uint32_t other = table.add(i);
            ASSERT_EQ(other == EqualDepths::none, is_new);
            if (!is_new) {
                ASSERT_LT(other, i);
                ASSERT_EQ(lines[other], lines[i]);
                ASSERT_EQ(depths[other], depths[i]);
            }
            ++(is_new ? different : equal);
        }
    }
    EXPECT_GT(equal, 1000u);
    EXPECT_GT(different, 1000u);
}

TEST(EqualDepths, NoHitsAreFine) {
    EqualDepths table;
    table.restart({}, {}, 0);
    const std::vector<std::uint32_t> lines{7};
    const std::vector<double> depths{1.5};
    table.restart(lines, depths, 8);
    EXPECT_EQ(table.add(0), EqualDepths::none);
}

} // namespace cd::tests
