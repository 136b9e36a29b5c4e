// Proves that labels return from disk as sent, in any parts, and that data that is damaged or
// differs from the announcement is an error.
#include "master/submission/label_spool.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <string>

namespace cd::tests {
namespace {

constexpr LabelColumns texts_and_times{IdKind::Text, true};

PoseLabels labels_of(std::uint64_t first, std::uint64_t count) {
    PoseLabels labels;
    for (std::uint64_t i = first; i < first + count; ++i) {
        labels.texts.push_back("stop " + std::to_string(i));
        labels.times.push_back(0.25 * static_cast<double>(i));
    }
    return labels;
}

class Labels : public testing::Test {
  protected:
    static constexpr std::uint64_t scenarios = 2 * limits::pose_run_scenarios + 7;

    void write() {
        auto spool = LabelSpool::create(folder_.path(), texts_and_times, scenarios);
        ASSERT_TRUE(spool);
        for (std::uint64_t first = 0; first < scenarios; first += 100) {
            const std::uint64_t count = std::min<std::uint64_t>(100, scenarios - first);
            ASSERT_TRUE(spool.value()->append(labels_of(first, count), count));
        }
        ASSERT_TRUE(spool.value()->seal(path_, Durability::Unsynced));
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "1.labels";
};

TEST_F(Labels, ComeBackAsTheyWere) {
    write();
    const auto spool = LabelSpool::open(path_, texts_and_times, scenarios);
    ASSERT_TRUE(spool) << spool.error().detail;
    for (const auto& [first, count] : {std::pair<std::uint64_t, std::uint64_t>{0, scenarios},
                                       {limits::pose_run_scenarios - 1, 2},
                                       {scenarios - 1, 1},
                                       {scenarios, 0}}) {
        const auto labels = spool.value()->read(first, count);
        ASSERT_TRUE(labels) << labels.error().detail;
        EXPECT_EQ(labels.value(), labels_of(first, count)) << first;
    }
}

TEST_F(Labels, AreOfTheColumnsAndTheNumberThatWereAnnounced) {
    auto spool = LabelSpool::create(folder_.path(), texts_and_times, 3);
    ASSERT_TRUE(spool);
    PoseLabels without_times = labels_of(0, 2);
    without_times.times.clear();
    EXPECT_EQ(spool.value()->append(without_times, 2).error().code, ErrorCode::BadInput);
    EXPECT_EQ(spool.value()->append(labels_of(0, 2), 3).error().code, ErrorCode::BadInput);
    EXPECT_EQ(spool.value()->append(labels_of(0, 4), 4).error().code, ErrorCode::BadInput);
    PoseLabels endless = labels_of(0, 1);
    endless.texts[0] = std::string(limits::label_bytes_max + 1, 'x');
    EXPECT_EQ(spool.value()->append(endless, 1).error().code, ErrorCode::BadInput);
    EXPECT_TRUE(spool.value()->append(labels_of(0, 3), 3));
}

TEST_F(Labels, DamagedOrForeignLabelsNameTheFile) {
    write();
    EXPECT_FALSE(LabelSpool::open(path_, texts_and_times, scenarios + 1));
    EXPECT_FALSE(LabelSpool::open(path_, LabelColumns{IdKind::Integer, true}, scenarios));
    std::string bytes = read_text(path_);
    bytes[bytes.size() / 4] ^= 1;
    write_text(path_, bytes);
    const auto spool = LabelSpool::open(path_, texts_and_times, scenarios);
    ASSERT_TRUE(spool);
    const auto labels = spool.value()->read(0, scenarios);
    ASSERT_FALSE(labels);
    EXPECT_NE(labels.error().detail.find("1.labels"), std::string::npos);
}

} // namespace
} // namespace cd::tests
