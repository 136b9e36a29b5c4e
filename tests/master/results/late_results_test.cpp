// Proves which late results equal the stored ones: settling may change the class, and nothing else
// may differ.
#include "master/results/late_results.hpp"

#include "common/core/files/disk_file.hpp"
#include "common/job/result/packed_records.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

ScenarioResult touching(std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.kind = ScenarioClass::Touch;
    result.pair_count = 1;
    result.pairs = {{3, 4}};
    return result;
}

ScenarioResult of_kind(ScenarioClass kind) {
    ScenarioResult result;
    result.kind = kind;
    return result;
}

TEST(LateResults, SettlingExplainsAClassAndNothingElse) {
    ScenarioResult settled = touching(1);
    settled.kind = ScenarioClass::Cross;
    settled.insides_skipped = true;
    EXPECT_TRUE(agrees(touching(1), touching(1)));
    EXPECT_TRUE(agrees(touching(1), settled));
    EXPECT_FALSE(agrees(settled, touching(1)));
    settled.pairs = {{3, 5}};
    EXPECT_FALSE(agrees(touching(1), settled));
    using enum ScenarioClass;
    EXPECT_TRUE(agrees(of_kind(Separate), of_kind(Inside)));
    EXPECT_FALSE(agrees(of_kind(Inside), of_kind(Separate)));
    EXPECT_FALSE(agrees(of_kind(Separate), of_kind(Cross)));
    EXPECT_FALSE(agrees(of_kind(Touch), of_kind(Inside)));
}

Results message_of(std::span<const ScenarioResult> all) {
    ByteWriter records;
    for (const ScenarioResult& one : all) {
        const Bytes record = encode_result(one);
        records.put(static_cast<std::uint32_t>(record.size()));
        put_bytes(records, record);
    }
    Results results;
    results.count = static_cast<std::uint32_t>(all.size());
    results.records = pack_records(records.bytes());
    return results;
}

class LateDifferenceTest : public testing::Test {
  protected:
    void keep(const ScenarioResult& result) {
        const Bytes record = encode_result(result);
        const StoredRecord stored{result.index, record};
        ASSERT_TRUE(store_->write({&stored, 1}));
        store_->commit();
    }
    [[nodiscard]] auto difference(const std::vector<ScenarioResult>& late) const {
        return late_difference(*store_, message_of(late));
    }

    TemporaryFolder folder_;
    std::unique_ptr<ResultStore> store_ = ResultStore::create(folder_ / "1.results", JobId{1}, 10);
};

TEST_F(LateDifferenceTest, IsOfAScenarioThatHasAResultThatTellsSomething) {
    ScenarioResult failed = of_kind(ScenarioClass::Failed);
    failed.index = 3;
    failed.failure = "cancelled";
    keep(touching(1));
    keep(touching(2));
    keep(failed);
    ScenarioResult other = touching(2);
    other.pairs = {{7, 8}};
    const auto none = difference({touching(1), touching(2), touching(3), touching(4)});
    ASSERT_TRUE(none) << none.error().detail;
    EXPECT_FALSE(none.value());
    const auto found = difference({touching(1), other, touching(3), touching(4)});
    ASSERT_TRUE(found && found.value()) << found.error().detail;
    EXPECT_EQ(found.value()->late.pairs, other.pairs);
    EXPECT_EQ(found.value()->kept.pairs, touching(2).pairs);
}

TEST_F(LateDifferenceTest, InvalidRecordsAreAnError) {
    Results cut = message_of(std::vector{touching(1)});
    cut.count = 2;
    EXPECT_EQ(late_difference(*store_, cut).error().code, ErrorCode::BadFrame);
    cut.records.resize(cut.records.size() / 2);
    EXPECT_FALSE(late_difference(*store_, cut));
}

/// Lookups read the disk, and millions of repeated scenarios compress to nothing.
TEST_F(LateDifferenceTest, AScenarioIsLookedUpOnce) {
    keep(touching(1));
    EXPECT_EQ(difference({touching(1), touching(1)}).error().code, ErrorCode::BadFrame);
    EXPECT_EQ(difference({touching(4), touching(4)}).error().code, ErrorCode::BadFrame);
}

TEST_F(LateDifferenceTest, IsNotLookedForInADamagedFile) {
    keep(touching(1));
    std::filesystem::resize_file(folder_ / "1.results", store_->end() - 9);
    EXPECT_EQ(difference({touching(1)}).error().code, ErrorCode::Io);
    EXPECT_EQ(kept_result(*store_, 2).error().code, ErrorCode::Io);
}

TEST_F(LateDifferenceTest, IsNotLookedForWhenTheMasterEnds) {
    keep(touching(1));
    const auto stopped =
        late_difference(*store_, message_of(std::vector{touching(1)}), [] { return true; });
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
}

} // namespace
} // namespace cd::tests
