// Proves that a report of a scene counts the pairs of bodies, and lists its episodes, the worst
// first.
#include "client/document/scene_sections.hpp"

#include "common/job/poses/pose_source.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

class SceneReport : public testing::Test {
  protected:
    SceneReport() {
        job_.names = {"truck", "car", "wall"};
        job_.query.level = Level::Count;
    }

    /// Adds the next step, in which the truck has this class with one other body.
    void add_step(std::uint32_t other, ScenarioClass kind, std::uint64_t pairs) {
        ScenarioResult result;
        result.index = results_.size();
        result.body_b = other;
        result.step = results_.size();
        result.level = Level::Count;
        result.kind = kind;
        result.pair_count = pairs;
        results_.push_back(result);
        index_.add_step({.tested = 1, .apart = 2});
    }

    [[nodiscard]] std::string section() {
        job_.scene =
            JobScene{{}, {false, false, true}, std::make_shared<const StepIndex>(index_), {}};
        auto writer = RecordWriter::create(folder_ / "records");
        for (const ScenarioResult& result : results_) {
            writer.value().add(result.index, encode_result(result));
        }
        EXPECT_TRUE(writer.value().finish());
        const auto records = RecordFile::open(folder_ / "records");
        const auto read = SceneSections::read(records.value(), job_, {});
        EXPECT_TRUE(read) << (read ? "" : read.error().detail);
        return read.value().section().markup();
    }

    const TemporaryFolder folder_;
    PreparedJob job_;
    StepIndex index_;
    std::vector<ScenarioResult> results_;
};

} // namespace

TEST_F(SceneReport, ListsTheEpisodesTheWorstFirst) {
    add_step(1, ScenarioClass::Touch, 3);
    add_step(1, ScenarioClass::Touch, 4);
    add_step(1, ScenarioClass::Separate, 0);
    add_step(2, ScenarioClass::Cross, 7);
    const std::string html = section();
    EXPECT_THAT(html, HasSubstr("4 steps: 4 of 12 pairs tested, 8 apart by their boxes, 0 failed"));
    const std::string touch = "<td>truck x car</td><td>0 to 1</td><td>0</td><td>1</td>"
                              "<td>touch</td><td>#1</td><td>4</td>";
    const std::string cross = "<td>truck x wall</td><td>3 to 3</td><td>3</td><td>3</td>"
                              "<td>cross</td><td>#3</td><td>7</td>";
    EXPECT_THAT(html, HasSubstr(touch));
    EXPECT_THAT(html, HasSubstr(cross));
    EXPECT_LT(html.find(cross), html.find(touch));
}

TEST_F(SceneReport, OfManyEpisodesTheWorstAreShown) {
    for (std::uint64_t i = 0; i < 120; ++i) {
        add_step(
            1, i % 2 == 0 ? ScenarioClass::Touch : ScenarioClass::Separate, i % 2 == 0 ? i : 0);
    }
    results_[0].pair_count = 1;
    const std::string html = section();
    EXPECT_THAT(html, HasSubstr("These are the worst 50 of 60 episodes; episodes.csv has all."));
    EXPECT_THAT(html, HasSubstr("<td>#118</td>"));
    EXPECT_THAT(html, Not(HasSubstr("<td>#18</td>")));
}

TEST_F(SceneReport, CountsFailuresAndSaysIfThereIsNoEpisode) {
    add_step(1, ScenarioClass::Separate, 0);
    add_step(1, ScenarioClass::Failed, 0);
    results_[1].failure = "cancelled";
    const std::string html = section();
    EXPECT_THAT(html, HasSubstr("1 failed"));
    EXPECT_THAT(html, HasSubstr("No two bodies are in contact or near at any step."));
}

TEST_F(SceneReport, OfLinesOnlyThePairsAreCounted) {
    job_.query.question = Question::Shots;
    add_step(2, ScenarioClass::Separate, 0);
    const std::string html = section();
    EXPECT_THAT(html, HasSubstr("Bodies and bundles"));
    EXPECT_THAT(html, Not(HasSubstr("No two bodies")));
}

} // namespace cd::tests
