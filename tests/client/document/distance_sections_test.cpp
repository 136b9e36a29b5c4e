// Proves that a report tells the least distances, and counts every distance in one bar.
#include "client/document/distance_sections.hpp"

#include "common/job/result/record_file.hpp"
#include "tests/support/distance_results.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class DistanceReport : public testing::Test {
  protected:
    DistanceReport() {
        manifest_.unit = "m";
        manifest_.bodies.resize(2);
        manifest_.query.question = Question::Distance;
        manifest_.query.level = Level::Any;
        manifest_.query.up_to = 2.5;
    }

    [[nodiscard]] RunOverview overview_of(const std::vector<ScenarioResult>& results) const {
        auto writer = RecordWriter::create(folder_ / "records");
        for (const ScenarioResult& result : results) {
            writer.value().add(result.index, encode_result(result));
        }
        EXPECT_TRUE(writer.value().finish());
        const auto box = share(make_box({1, 1, 1}));
        auto read = RunOverview::read(
            RecordFile::open(folder_ / "records").value(), GroupSum({box, box}), 4, {});
        EXPECT_TRUE(read);
        return std::move(read.value());
    }

    const TemporaryFolder folder_;
    RunManifest manifest_;
    const PreparedJob named_{};
    const RunNames names_{manifest_, named_};
};

} // namespace

TEST_F(DistanceReport, TellsTheLeastDistanceAndItsScenario) {
    RunOverview overview = overview_of(distance_results());
    const DistanceSections sections(names_, manifest_, overview);
    EXPECT_EQ(sections.least(), "The least distance is 0.125 m, in #3.");
    const std::array<std::string, 2> pictures{"first", ""};
    const std::string markup = sections.nearest(pictures).markup();
    EXPECT_THAT(markup, HasSubstr("#3, inside, 0.125 m apart; whole x whole"));
    EXPECT_THAT(markup, HasSubstr("#0, separate, 0.25 m apart; whole x whole"));
    EXPECT_LT(markup.find("#3"), markup.find("#0"));
    EXPECT_THAT(markup, HasSubstr(data_address("image/png", "first")));
    EXPECT_THAT(markup, HasSubstr("The picture is left out"));
    const std::string chart = sections.histogram().markup();
    EXPECT_THAT(chart, HasSubstr("distance [m]"));
    EXPECT_THAT(chart, HasSubstr("2 scenarios in all"));
    EXPECT_THAT(chart, HasSubstr(">0.25</text>"));
}

TEST_F(DistanceReport, SaysWhyThereIsNoDistance) {
    std::vector<ScenarioResult> results = distance_results();
    for (ScenarioResult& result : results) {
        result.nearest.reset();
    }
    RunOverview overview = overview_of(results);
    const DistanceSections sections(names_, manifest_, overview);
    EXPECT_EQ(
        sections.least(),
        "No scenario has a distance: the bodies are in contact, or farther apart than 2.5 m.");
    EXPECT_TRUE(sections.nearest({}).is_empty());
    EXPECT_TRUE(sections.histogram().is_empty());
}

TEST(DistanceBars, CountEachDistanceOnce) {
    const std::array<double, 6> distances{0, 0.5, 0.5, 1, 9.99, 10};
    const auto bars = distance_bars(distances);
    ASSERT_EQ(bars.size(), 20u);
    EXPECT_EQ(bars.front().from, 0);
    EXPECT_EQ(bars.back().to, 10);
    EXPECT_EQ(bars[0].count, 1u);
    EXPECT_EQ(bars[1].count, 2u) << "a bar begins with its lower end";
    EXPECT_EQ(bars[2].count, 1u);
    EXPECT_EQ(bars[19].count, 2u) << "the last bar has its upper end, too";
    EXPECT_TRUE(distance_bars({}).empty());
    const std::array<double, 2> zeros{0, 0};
    ASSERT_EQ(distance_bars(zeros).size(), 1u);
    EXPECT_EQ(distance_bars(zeros)[0].count, 2u);
}

} // namespace cd::tests
