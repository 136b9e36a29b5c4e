// Proves which late results are taken for what was kept: settling may have changed the class, and
// nothing else may differ.
#include "master/late_results.hpp"

#include "common/core/disk_file.hpp"
#include "common/job/packed_records.hpp"
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
    settled.surfaces_only = true;
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

class LateDifferences : public testing::Test {
  protected:
    void keep(const ScenarioResult& result) {
        const Bytes record = encode_result(result);
        const StoredRecord stored{result.index, record};
        ASSERT_TRUE(store_->write({&stored, 1}));
        store_->commit();
    }

    TemporaryFolder folder_;
    std::unique_ptr<ResultStore> store_ = ResultStore::create(folder_ / "1.results", JobId{1}, 10);
};

TEST_F(LateDifferences, AreOfScenariosThatHaveAResultThatTellsSomething) {
    ScenarioResult failed = touching(3);
    failed.kind = ScenarioClass::Failed;
    failed.pair_count = 0;
    failed.pairs.clear();
    failed.failure = "cancelled";
    keep(touching(1));
    keep(touching(2));
    keep(failed);
    ScenarioResult other = touching(2);
    other.pairs = {{7, 8}};
    const auto found = late_differences(
        *store_, message_of(std::vector{touching(1), other, touching(3), touching(4)}));
    ASSERT_TRUE(found) << found.error().detail;
    ASSERT_EQ(found.value().size(), 1u);
    EXPECT_EQ(found.value()[0].late.pairs, other.pairs);
    EXPECT_EQ(found.value()[0].kept.pairs, touching(2).pairs);
}

TEST_F(LateDifferences, OfRubbishAreAnError) {
    Results cut = message_of(std::vector{touching(1)});
    cut.count = 2;
    EXPECT_EQ(late_differences(*store_, cut).error().code, ErrorCode::BadFrame);
    cut.records.resize(cut.records.size() / 2);
    EXPECT_FALSE(late_differences(*store_, cut));
}

TEST_F(LateDifferences, AreNotLookedForInADamagedFile) {
    keep(touching(1));
    std::filesystem::resize_file(folder_ / "1.results", store_->end() - 9);
    const auto found = late_differences(*store_, message_of(std::vector{touching(1)}));
    EXPECT_EQ(found.error().code, ErrorCode::Io);
}

} // namespace
} // namespace cd::tests
