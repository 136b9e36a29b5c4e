// Proves that poses return from the spool exactly as sent, in any runs, and that poses that do not
// continue the job are refused whole.

#include "master/submission/pose_spool.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

std::vector<Scenario> make_scenarios(std::uint64_t count) {
    std::mt19937_64 random(7);
    std::vector<Scenario> scenarios(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        scenarios[i].index = i;
        const bool matrices = i % 3 == 0;
        scenarios[i].poses.a = matrices ? make_matrix_pose(random, 2) : Pose{};
        scenarios[i].poses.b = make_pose(random, 2);
    }
    return scenarios;
}

class PoseSpoolTest : public testing::Test {
  protected:
    std::unique_ptr<PoseSpool> make_spool(std::uint64_t scenarios) {
        return std::move(PoseSpool::create(folder_ / "spool", scenarios).value());
    }
    TemporaryFolder folder_;
};

TEST_F(PoseSpoolTest, GivesBackWhatItGotInAnyRuns) {
    const auto scenarios = make_scenarios(3 * limits::spool_run_scenarios + 100);
    const auto spool = make_spool(scenarios.size());
    std::mt19937_64 random(1);
    for (std::size_t i = 0; i < scenarios.size();) {
        EXPECT_FALSE(spool->is_complete());
        const std::size_t piece = std::min<std::size_t>(1 + random() % 300, scenarios.size() - i);
        ASSERT_TRUE(spool->append(pack_scenarios(std::span(scenarios).subspan(i, piece))));
        i += piece;
        ASSERT_EQ(spool->count(), i);
    }
    EXPECT_TRUE(spool->is_complete());

    for (int round = 0; round < 50; ++round) {
        const std::size_t first = random() % scenarios.size();
        const std::size_t count = random() % (scenarios.size() - first + 1);
        const auto read = spool->read(first, count);
        ASSERT_TRUE(read) << read.error().detail;
        ASSERT_TRUE(std::ranges::equal(read.value(), std::span(scenarios).subspan(first, count)));
    }
}

TEST_F(PoseSpoolTest, OneLargePieceIsManyRuns) {
    const auto scenarios = make_scenarios(2 * limits::spool_run_scenarios);
    const auto spool = make_spool(scenarios.size());
    ASSERT_TRUE(spool->append(pack_scenarios(scenarios)));
    EXPECT_EQ(spool->read(0, scenarios.size()).value(), scenarios);
}

TEST_F(PoseSpoolTest, RefusesWhatDoesNotContinueAndKeepsNothingOfIt) {
    const auto scenarios = make_scenarios(20);
    const auto spool = make_spool(20);
    const auto run = [&](std::size_t begin, std::size_t count) {
        return std::vector<Scenario>(scenarios.begin() + static_cast<std::ptrdiff_t>(begin),
                                     scenarios.begin() +
                                         static_cast<std::ptrdiff_t>(begin + count));
    };
    EXPECT_FALSE(spool->append(pack_scenarios(run(1, 5))));
    ASSERT_TRUE(spool->append(pack_scenarios(run(0, 10))));
    EXPECT_FALSE(spool->append(pack_scenarios(run(0, 10))));
    EXPECT_FALSE(spool->append(pack_scenarios(run(11, 2))));
    auto skipping = run(10, 4);
    skipping.erase(skipping.begin() + 2);
    EXPECT_FALSE(spool->append(pack_scenarios(skipping)));
    auto foreign = run(10, 2);
    foreign[1].body_b = 2;
    EXPECT_FALSE(spool->append(pack_scenarios(foreign)));
    EXPECT_EQ(spool->count(), 10u);

    ASSERT_TRUE(spool->append(pack_scenarios(run(10, 10))));
    EXPECT_EQ(spool->read(0, 20).value(), scenarios);
}

TEST_F(PoseSpoolTest, RefusesMoreThanWasAnnounced) {
    const auto scenarios = make_scenarios(11);
    const auto spool = make_spool(10);
    const Status status = spool->append(pack_scenarios(scenarios));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::BadInput);
    EXPECT_EQ(PoseSpool::create(folder_.path(), limits::scenarios_max + 1).error().code,
              ErrorCode::TooLarge);
}

TEST_F(PoseSpoolTest, RefusesMoreAtOnceThanTheirMemoryIsWorth) {
    // Empty poses: a few bytes each on the wire would be hundreds in memory.
    std::vector<Scenario> scenarios(limits::poses_part_scenarios_max + 1);
    for (std::uint64_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
    }
    const auto spool = make_spool(limits::scenarios_max);
    const Status status = spool->append(pack_scenarios(scenarios));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::TooLarge);
    scenarios.pop_back();
    EXPECT_TRUE(spool->append(pack_scenarios(scenarios)));
    EXPECT_EQ(spool->count(), limits::poses_part_scenarios_max);
}

TEST_F(PoseSpoolTest, RefusesBytesThatAreNoScenarios) {
    const auto spool = make_spool(100);
    Bytes packed = pack_scenarios(make_scenarios(5));
    packed.pop_back();
    EXPECT_FALSE(spool->append(packed));
    EXPECT_FALSE(spool->append(Bytes(1000, std::byte{0xff})));
    EXPECT_EQ(spool->count(), 0u);
}

TEST_F(PoseSpoolTest, LeavesNoFileUnlessItWasSealed) {
    {
        const auto spool = make_spool(10);
        ASSERT_TRUE(spool->append(pack_scenarios(make_scenarios(10))));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "spool"));
}

TEST_F(PoseSpoolTest, ASealedOneComesBack) {
    for (const std::uint64_t count : {std::uint64_t{0},
                                      std::uint64_t{1},
                                      limits::spool_run_scenarios,
                                      3 * limits::spool_run_scenarios + 100}) {
        const auto scenarios = make_scenarios(count);
        {
            const auto spool = make_spool(count);
            ASSERT_TRUE(spool->append(pack_scenarios(scenarios)));
            ASSERT_TRUE(spool->seal(folder_ / "spool/1.poses", Durability::Synced));
            EXPECT_EQ(spool->count(), count);
            EXPECT_EQ(spool->read(0, count).value(), scenarios);
        }
        const auto spool = PoseSpool::open(folder_ / "spool/1.poses", count);
        ASSERT_TRUE(spool) << spool.error().detail;
        EXPECT_TRUE(spool.value()->verify());
        EXPECT_EQ(spool.value()->count(), count);
        EXPECT_EQ(spool.value()->read(0, count).value(), scenarios);
        EXPECT_FALSE(PoseSpool::open(folder_ / "spool/1.poses", count + 1));
    }
    EXPECT_FALSE(PoseSpool::open(folder_ / "spool/2.poses", 1));
}

TEST_F(PoseSpoolTest, EveryFlippedByteOfASealedOneIsSeen) {
    const auto path = folder_ / "spool/1.poses";
    {
        const auto spool = make_spool(300);
        ASSERT_TRUE(spool->append(pack_scenarios(make_scenarios(300))));
        ASSERT_TRUE(spool->seal(path, Durability::Unsynced));
    }
    const std::string good = read_text(path);
    for (std::size_t byte = 0; byte < good.size(); byte += byte + 200 < good.size() ? 37 : 1) {
        std::string bad = good;
        bad[byte] = static_cast<char>(bad[byte] ^ 4);
        write_text(path, bad);
        const auto spool = PoseSpool::open(path, 300);
        const Status status = spool ? spool.value()->verify() : Status(spool.error());
        ASSERT_FALSE(status) << "byte " << byte;
        EXPECT_NE(status.error().detail.find("1.poses"), std::string::npos);
    }
}

} // namespace
} // namespace cd::tests
