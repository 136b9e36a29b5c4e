// Proves that the results of a scene name step, time and bodies in every format, and that those of
// two bodies do not change.
#include "client/export/result_sink.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
namespace fs = std::filesystem;

class SceneExport : public testing::Test {
  protected:
    SceneExport() {
        const auto box = share(make_box({1, 1, 1}));
        context_.bodies = {{"car.0", "car.obj", box},
                           {"car, old", "car.obj", box},
                           {"wall", "wall.obj", box, false, true}};
        context_.level = Level::Count;
        const auto steps = std::make_shared<StepIndex>();
        for (const std::uint64_t tested : {2, 0, 1, 2}) {
            steps->add_step({tested});
        }
        steps->set_times({0, 0.5, 1, 1.5});
        context_.steps = steps;
    }

    static std::vector<ScenarioResult> results() {
        std::vector<ScenarioResult> made(5);
        for (std::uint64_t i = 0; i < made.size(); ++i) {
            made[i].index = i;
            made[i].level = Level::Count;
        }
        made[0].kind = ScenarioClass::Touch;
        made[0].pair_count = 3;
        made[1].body_b = 2;
        made[2].kind = ScenarioClass::Touch;
        made[2].pair_count = 1;
        made[3].kind = ScenarioClass::Cross;
        made[3].pair_count = 8;
        made[4].body_b = 2;
        made[4].kind = ScenarioClass::Failed;
        made[4].failure = "too large";
        return made;
    }
    void write(const std::vector<std::string>& formats) {
        auto files = ResultSink::open({dir_, formats}, context_);
        ASSERT_TRUE(files) << files.error().detail;
        for (const ScenarioResult& result : results()) {
            ASSERT_TRUE(files.value().add(result));
        }
        ASSERT_TRUE(files.value().finish(std::nullopt));
    }
    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(dir_ / name);
    }

    const TemporaryFolder folder_;
    fs::path dir_ = folder_.path();
    ExportContext context_;
};

} // namespace

TEST_F(SceneExport, CsvBeginsWithStepTimeAndBodies) {
    write({"csv"});
    EXPECT_EQ(text_of("scenarios.csv"),
              "step,time,body_a,body_b,scenario,class,count,cut,distance_bound,surfaces_only,"
              "insides_skipped,failure\n"
              "0,0,car.0,\"car, old\",0,touch,3,0,,0,0,\n"
              "0,0,car.0,wall,1,separate,0,0,,0,0,\n"
              "2,1,car.0,\"car, old\",2,touch,1,0,,0,0,\n"
              "3,1.5,car.0,\"car, old\",3,cross,8,0,,0,0,\n"
              "3,1.5,car.0,wall,4,failed,0,0,,0,0,too large\n");
}

TEST_F(SceneExport, EpisodesAreRunsOfSteps) {
    write({"csv"});
    EXPECT_EQ(text_of("episodes.csv"),
              "body_a,body_b,first_step,last_step,first_time,last_time,worst,worst_step,"
              "worst_scenario,worst_pairs\n"
              "car.0,\"car, old\",0,0,0,0,touch,0,0,3\n"
              "car.0,\"car, old\",2,3,1,1.5,cross,3,3,8\n");
}

TEST_F(SceneExport, CoverageHasARowForEachStep) {
    write({"csv"});
    EXPECT_EQ(text_of("coverage.csv"),
              "step,time,tested,apart,ignored,fixed,absent,failed\n"
              "0,0,2,0,0,0,0,0\n"
              "1,0.5,0,0,0,0,0,0\n"
              "2,1,1,0,0,0,0,0\n"
              "3,1.5,2,0,0,0,0,1\n");
}

TEST_F(SceneExport, FindingsSumTheStepsAndNameTheWorstEpisode) {
    auto sink = ResultSink::open({{}, {}, "text", 2}, context_);
    ASSERT_TRUE(sink) << sink.error().detail;
    for (const ScenarioResult& result : results()) {
        ASSERT_TRUE(sink.value().add(result));
    }
    ASSERT_TRUE(sink.value().finish(std::nullopt));
    RunReport report;
    report.findings = sink.value().findings();
    ASSERT_TRUE(report.findings.scene);
    EXPECT_EQ(report.findings.scene->coverage.tested, 5u);
    EXPECT_EQ(report.findings.scene->episodes, 2u);
    report.summary.failed = 1;
    EXPECT_THAT(
        summary_text(report),
        HasSubstr("  coverage      4 steps: 5 of 5 pairs tested, 0 apart by their boxes, 1 "
                  "failed\n"
                  "  episodes      2; the worst, cross, of car.0 and car, old in steps 2 to "
                  "3\n"
                  "  learned       these pairs in contact at step 2, as [rules] order has "
                  "them:\n{ ignore = [\"car.0\", \"car, old\"] },\n"));
}

TEST_F(SceneExport, NpzHasTheStepOfEachScenario) {
    write({"npz"});
    const auto arrays = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(arrays) << arrays.error().detail;
    const NpyArray& step = arrays.value().at("step");
    EXPECT_EQ(step.type, NpyType::U8);
    EXPECT_EQ(step.to_integers().value(), (std::vector<std::int64_t>{0, 0, 2, 3, 3}));
    EXPECT_EQ(arrays.value().at("body_b").to_integers().value(),
              (std::vector<std::int64_t>{1, 2, 1, 1, 2}));
}

TEST_F(SceneExport, JsonAndTextNameStepAndBodies) {
    write({"json", "text"});
    std::istringstream lines(text_of("results.jsonl"));
    std::string line;
    for (int i = 0; i < 3; ++i) {
        std::getline(lines, line);
    }
    const auto third = nlohmann::json::parse(line);
    EXPECT_EQ(third["step"], 2);
    EXPECT_EQ(third["time"], 1.0);
    EXPECT_EQ(third["body_b"], "car, old");
    EXPECT_THAT(text_of("results.txt"), StartsWith("0  step 0  car.0  car, old  touch  3 pairs\n"));
    EXPECT_THAT(text_of("results.txt"), HasSubstr("\n1  step 0  car.0  wall  separate"));
}

TEST_F(SceneExport, TwoBodiesHaveNoSteps) {
    context_.steps = nullptr;
    write({"csv", "npz", "json", "text"});
    EXPECT_THAT(text_of("scenarios.csv"), StartsWith("scenario,body_a,body_b,class,"));
    EXPECT_FALSE(fs::exists(dir_ / "episodes.csv"));
    EXPECT_THAT(text_of("results.jsonl"), Not(HasSubstr("step")));
    EXPECT_THAT(text_of("results.txt"), StartsWith("0  touch  3 pairs\n"));
    const auto arrays = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(arrays);
    EXPECT_FALSE(arrays.value().contains("step"));
}

} // namespace cd::tests
