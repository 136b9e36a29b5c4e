// Proves that a block gives back the results that were added, with their records and digests.
#include "client/local/done_block.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

ScenarioResult random_result(SeededRandom& random, std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.level = static_cast<Level>(random() % 4);
    if (random() % 5 == 0) {
        result.kind = ScenarioClass::Failed;
        result.failure = std::string(random() % 9, 'f');
        return result;
    }
    const auto pairs = static_cast<std::uint32_t>(random() % 4);
    if (pairs > 0) {
        result.kind = result.level == Level::Any ? ScenarioClass::Contact : ScenarioClass::Cross;
        result.pair_count = result.level == Level::Any ? 0 : pairs;
    } else if (random() % 3 == 0) {
        result.kind = ScenarioClass::Undecided;
        result.distance_bound = 0.25;
    }
    if (result.level == Level::Contacts) {
        result.point_offsets.push_back(0);
    }
    for (std::uint32_t i = 0; i < pairs && result.level >= Level::Pairs; ++i) {
        result.pairs.push_back({i, i, PairClass::Proper});
        if (result.level == Level::Contacts) {
            result.point_origins.emplace_back(i, 0, 0);
            result.points.resize(result.points.size() + random() % 3, Vec3(1, 2, 3));
            result.point_offsets.push_back(static_cast<std::uint32_t>(result.points.size()));
        }
    }
    return result;
}

TEST(DoneBlock, ResultsComeBackAsTheyWere) {
    for (SeededRandom random : seeds(50)) {
        const bool has_maps = random() % 2 == 0;
        std::vector<ScenarioResult> results;
        DoneBlock block;
        for (std::uint64_t i = 0; i < 1 + random() % 20; ++i) {
            results.push_back(random_result(random, 7 + i));
            if (has_maps) {
                block.add(results.back(), results.back().pairs);
            } else {
                block.add(results.back());
            }
        }
        ASSERT_EQ(block.size(), results.size());
        EXPECT_EQ(block.first(), 7u);
        std::uint64_t bytes = 0;
        std::size_t i = 0;
        ASSERT_TRUE(block.for_each([&](const DoneScenario& done) {
            const ScenarioResult& expected = results[i];
            EXPECT_EQ(done.record, encode_result(expected));
            EXPECT_EQ(encode_result(done.result), done.record);
            EXPECT_EQ(done.digest, digest_of(expected));
            EXPECT_EQ(block.facts()[i], facts_of(expected));
            EXPECT_EQ(done.found, has_maps ? expected.pairs : std::vector<ContactPair>());
            bytes += done.record.size();
            ++i;
            return Status(Done{});
        }));
        EXPECT_EQ(i, results.size());
        EXPECT_GE(block.bytes(), bytes);
    }
}

} // namespace

} // namespace cd::tests
