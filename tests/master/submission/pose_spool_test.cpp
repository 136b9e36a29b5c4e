// Proves that runs of poses are stored exactly as sent, and that runs that do not continue the job
// are refused whole.

#include "master/submission/pose_spool.hpp"

#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "tests/support/packed_poses.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

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
    std::shared_ptr<PoseSpool> make_spool(std::uint64_t scenarios) {
        return std::move(PoseSpool::create(folder_ / "spool", {scenarios, 2}).value());
    }
    TemporaryFolder folder_;
};

TEST_F(PoseSpoolTest, StoresRunsAsTheyCome) {
    const auto runs = packed_runs(make_scenarios(3 * limits::pose_run_scenarios + 100));
    const auto spool = make_spool(3 * limits::pose_run_scenarios + 100);
    for (const Bytes& run : runs) {
        EXPECT_FALSE(spool->is_complete());
        ASSERT_TRUE(spool->append(run));
    }
    EXPECT_TRUE(spool->is_complete());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(spool->run(i).value().bytes(), runs[i]);
    }
}

TEST_F(PoseSpoolTest, RefusesRunsThatDoNotContinueAndKeepsNothingOfThem) {
    const std::uint64_t run = limits::pose_run_scenarios;
    const auto scenarios = make_scenarios(2 * run);
    const auto packed = [&](std::uint64_t first, std::uint64_t count) {
        return pack_scenarios(std::span(scenarios).subspan(first, count));
    };
    const auto spool = make_spool(2 * run);
    EXPECT_FALSE(spool->append(packed(0, run - 1))) << "too few";
    EXPECT_FALSE(spool->append(packed(0, run + 1))) << "too many";
    ASSERT_TRUE(spool->append(packed(run, run))) << "a window may come in any order";
    EXPECT_FALSE(spool->append(packed(run, run))) << "twice";
    auto others = std::vector(scenarios.begin(), scenarios.begin() + run);
    others[7].index = 2 * run;
    EXPECT_FALSE(spool->append(pack_scenarios(others))) << "outside of the window";
    others[7].index = 8;
    EXPECT_FALSE(spool->append(pack_scenarios(others))) << "twice in the run";
    others[7] = scenarios[7];
    others[7].body_b = 2;
    EXPECT_FALSE(spool->append(pack_scenarios(others))) << "an unknown body";
    EXPECT_EQ(spool->count(), run);
    ASSERT_TRUE(spool->append(packed(0, run)));

    OrderedPoses poses((std::shared_ptr<const PoseRuns>(spool)));
    EXPECT_EQ(poses.read_submitted(0, 2 * run).value(), scenarios);
}

TEST_F(PoseSpoolTest, EachScenarioHasTwoBodiesOfTheJobTheFirstBeforeTheSecond) {
    const auto spool = std::move(PoseSpool::create(folder_ / "spool", {4, 5}).value());
    auto scenarios = make_scenarios(4);
    const auto refusal_of = [&](std::uint32_t a, std::uint32_t b) {
        auto changed = scenarios;
        changed[2].body_a = a;
        changed[2].body_b = b;
        const Status appended = spool->append(pack_scenarios(changed));
        return appended ? "" : appended.error().detail;
    };
    EXPECT_EQ(refusal_of(3, 5),
              "scenario 2 names bodies 3 and 5; the job has 0 to 4, and A comes before B");
    EXPECT_NE(refusal_of(3, 3), "");
    EXPECT_NE(refusal_of(3, 2), "");
    EXPECT_EQ(refusal_of(3, 4), "");
    ASSERT_TRUE(spool->is_complete());
    ASSERT_TRUE(spool->seal(folder_ / "spool/1.poses", Durability::Unsynced));
    EXPECT_TRUE(PoseSpool::open(folder_ / "spool/1.poses", {4, 5}).value()->verify());
    EXPECT_FALSE(PoseSpool::open(folder_ / "spool/1.poses", {4, 4}).value()->verify());
}

TEST_F(PoseSpoolTest, AWindowBeginsAnew) {
    const std::uint64_t window = limits::order_window_scenarios;
    std::vector<Scenario> scenarios(window + 1);
    for (std::uint64_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
    }
    const auto spool = make_spool(window + 1);
    const auto runs = packed_runs(scenarios);
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
        ASSERT_TRUE(spool->append(runs[i]));
    }
    EXPECT_FALSE(spool->append(pack_scenarios(std::span(scenarios).first(1))));
    EXPECT_TRUE(spool->append(runs.back()));
}

TEST_F(PoseSpoolTest, RefusesMoreThanWasAnnounced) {
    const auto spool = make_spool(10);
    const Status status = spool->append(pack_scenarios(make_scenarios(11)));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::BadInput);
    EXPECT_EQ(PoseSpool::create(folder_.path(), {limits::scenarios_max + 1, 2}).error().code,
              ErrorCode::TooLarge);
}

TEST_F(PoseSpoolTest, NamesAScenarioWithoutAPose) {
    auto scenarios = make_scenarios(5);
    scenarios[3].poses.b = Pose::from_quaternion({1, 0, 0, 0}, {1, 2, std::nan("")});
    const Status status = make_spool(5)->append(pack_scenarios(scenarios));
    ASSERT_FALSE(status);
    EXPECT_NE(status.error().detail.find("scenario 3"), std::string::npos);
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
                                      limits::pose_run_scenarios,
                                      3 * limits::pose_run_scenarios + 100}) {
        const auto scenarios = make_scenarios(count);
        {
            const auto spool = make_spool(count);
            for (const Bytes& run : packed_runs(scenarios)) {
                ASSERT_TRUE(spool->append(run));
            }
            ASSERT_TRUE(spool->seal(folder_ / "spool/1.poses", Durability::Synced));
            EXPECT_EQ(spool->count(), count);
        }
        auto spool = PoseSpool::open(folder_ / "spool/1.poses", {count, 2});
        ASSERT_TRUE(spool) << spool.error().detail;
        EXPECT_TRUE(spool.value()->verify());
        EXPECT_EQ(spool.value()->count(), count);
        OrderedPoses poses((std::shared_ptr<const PoseRuns>(std::move(spool.value()))));
        EXPECT_EQ(poses.read_submitted(0, count).value(), scenarios);
        EXPECT_FALSE(PoseSpool::open(folder_ / "spool/1.poses", {count + 1, 2}));
    }
    EXPECT_FALSE(PoseSpool::open(folder_ / "spool/2.poses", {1, 2}));
}

TEST_F(PoseSpoolTest, VerifyingSeesAPoseThatIsNoPoseBehindRightChecksums) {
    const auto path = folder_ / "spool/1.poses";
    {
        const auto spool = make_spool(3);
        ASSERT_TRUE(spool->append(pack_scenarios(make_scenarios(3))));
        ASSERT_TRUE(spool->seal(path, Durability::Unsynced));
    }
    // After the only run: its end, its checksum, the kind, two counts, and the index's checksum.
    constexpr std::size_t index_bytes = 6 * sizeof(std::uint64_t);
    std::string text = read_text(path);
    const std::size_t run_bytes = text.size() - index_bytes;
    const auto sum_up = [&](std::size_t from, std::size_t to, std::size_t at) {
        const std::uint64_t sum = checksum(std::as_bytes(std::span(text)).subspan(from, to - from));
        std::memcpy(text.data() + at, &sum, sizeof sum);
    };
    const double nan = std::nan("");
    std::memcpy(text.data() + run_bytes - sizeof nan, &nan, sizeof nan);
    sum_up(0, run_bytes, run_bytes + sizeof(std::uint64_t));
    sum_up(run_bytes, text.size() - sizeof(std::uint64_t), text.size() - sizeof(std::uint64_t));
    write_text(path, text);
    const auto spool = PoseSpool::open(path, {3, 2});
    ASSERT_TRUE(spool) << spool.error().detail;
    const Status status = spool.value()->verify();
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::Io);
    EXPECT_NE(status.error().detail.find("scenario 2"), std::string::npos);
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
        const auto spool = PoseSpool::open(path, {300, 2});
        const Status status = spool ? spool.value()->verify() : Status(spool.error());
        ASSERT_FALSE(status) << "byte " << byte;
        EXPECT_NE(status.error().detail.find("1.poses"), std::string::npos);
    }
}

} // namespace
} // namespace cd::tests
