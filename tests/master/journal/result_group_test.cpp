// Proves that a group of results restores each result's author and the remarks on others, that this
// costs little beside the results, and that invalid bytes are errors.
#include "master/journal/result_group.hpp"

#include "tests/proto/sample_messages.hpp"
#include "tests/support/damage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using Kind = Remark::Kind;

ResultGroup some_group() {
    ResultGroup group;
    group.begin = 100;
    for (std::uint64_t i = 0; i < 6; ++i) {
        const ScenarioFacts facts{ScenarioClass::Cross,
                                  i % 2 == 0,
                                  i % 3 == 1,
                                  false,
                                  i % 4 == 3,
                                  i,
                                  i % 2 == 0 ? i << 40 : 0};
        group.rows.push_back({1000 - 70 * i, 20 + i, facts});
    }
    group.rows.back().facts.kind = ScenarioClass::Near;
    group.maps = {Bytes(3, std::byte{1}), Bytes()};
    group.authors = {{2, 77}, {1, 0}, {3, 77}};
    group.remarks = {{Kind::Disputed, 930, some_hash(8), 78},
                     {Kind::Settled, 930, some_hash(8), 78},
                     {Kind::Withdrawn, 0, {}, 79}};
    group.losses = {{{7, 1}, 77}, {{300, 1000}, 0}};
    return group;
}

void expect_same(const ResultGroup& one, const ResultGroup& other) {
    EXPECT_EQ(one.begin, other.begin);
    EXPECT_EQ(one.rows, other.rows);
    EXPECT_EQ(one.maps, other.maps);
    EXPECT_EQ(one.authors, other.authors);
    EXPECT_EQ(one.remarks, other.remarks);
    EXPECT_EQ(one.losses, other.losses);
}

TEST(ResultGroup, AGroupIsReadBackWithItsAuthorsRemarksAndLosses) {
    ResultGroup only_remarks;
    only_remarks.begin = 5;
    only_remarks.remarks = some_group().remarks;
    ResultGroup only_losses;
    only_losses.losses = some_group().losses;
    for (const ResultGroup& group : {some_group(), ResultGroup{}, only_remarks, only_losses}) {
        const auto decoded = decode_group(encode_group(group));
        ASSERT_TRUE(decoded) << decoded.error().detail;
        expect_same(decoded.value(), group);
    }
}

TEST(ResultGroup, CutShortOrFollowedByMoreIsAnError) {
    expect_no_other_length(encode_group(some_group()), decode_group);
}

TEST(ResultGroup, RowsThatDoNotAddUpAndUnknownProcessesAreErrors) {
    ResultGroup group;
    group.rows = {{4, 20, {}}};
    group.authors = {{1, 7}};
    const Bytes good = encode_group(group);
    ASSERT_TRUE(decode_group(good));
    // Bytes from the end: no losses, no remarks, one row of process 0 with one run.
    for (const auto& [from_end, value] : {std::pair(3, 2), {3, 0}, {4, 1}, {2, 9}, {1, 1}}) {
        Bytes bad = good;
        bad[bad.size() - static_cast<std::size_t>(from_end)] = static_cast<std::byte>(value);
        EXPECT_FALSE(decode_group(bad)) << from_end << " " << value;
    }
}

TEST(ResultGroup, LossesOfNoPlacesOrOfTooManyToCountAreAnError) {
    for (const PositionRange& positions :
         {PositionRange{5, 0}, PositionRange{2, ~std::uint64_t{0} - 1}}) {
        ResultGroup group;
        group.losses = {{positions, 7}};
        EXPECT_FALSE(decode_group(encode_group(group)));
    }
}

TEST(ResultGroup, ConsecutiveAlikeRowsTakeAByteEach) {
    ResultGroup group;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        group.rows.push_back({500 + i, 28, {}});
    }
    group.authors = {{1000, 7}};
    EXPECT_LE(encode_group(group).size(), 1000u + 50);
}

TEST(ResultGroup, RunsOfMoreRowsThanThereAreAreAnError) {
    ResultGroup group;
    group.rows = {{4, 20, {}}};
    group.authors = {{1, 7}};
    Bytes bytes = encode_group(group);
    // After the begin, the number of rows and one number of pairs comes the run of scenarios.
    constexpr std::size_t run = sizeof group.begin + 3;
    ASSERT_EQ(bytes[run], std::byte{0});
    bytes[run] = std::byte{1};
    EXPECT_FALSE(decode_group(bytes));
}

TEST(ResultGroup, AuthorsCostLittleBesideTheResults) {
    ResultGroup group;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        group.rows.push_back({i, 20, {}});
    }
    group.authors = {{1000, 0}};
    const std::size_t of_one = encode_group(group).size();
    group.authors.clear();
    for (std::uint64_t i = 0; i < 1000; ++i) {
        group.authors.push_back({1, ~(i % 8)}); // The worst case: alternating authors.
    }
    EXPECT_LE(encode_group(group).size(), of_one + 1000 * 2 + 8 * 8);
}

} // namespace
} // namespace cd::tests
