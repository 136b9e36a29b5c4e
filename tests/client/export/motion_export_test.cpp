// Proves that files say in the poses' time what is proven of motions, and that the arrays of an
// archive have each run.
#include "client/export/motion_times.hpp"
#include "client/export/result_sink.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <span>

namespace cd::tests {

namespace {

using testing::HasSubstr;

ScenarioResult of_motion(std::uint64_t index, ScenarioClass kind) {
    ScenarioResult result;
    result.index = index;
    result.question = Question::Motion;
    result.level = Level::Any;
    result.kind = kind;
    result.motion.emplace().depth = 2;
    return result;
}

/// Contact from the second quarter of the time on.
ScenarioResult hitting(std::uint64_t index) {
    ScenarioResult result = of_motion(index, ScenarioClass::Contact);
    result.motion->end = MotionEnd::Contact;
    result.motion->runs = {{CellState::Free, 0, 1}, {CellState::Open, 1, 1, 2, 2}};
    result.motion->t0 = 1;
    result.motion->t1 = 2;
    return result;
}

ScenarioResult passing(std::uint64_t index) {
    ScenarioResult result = of_motion(index, ScenarioClass::Separate);
    result.motion->runs = {{CellState::Free, 0, 4}};
    result.motion->t0 = result.motion->t1 = 4;
    return result;
}

ScenarioResult leaving(std::uint64_t index) {
    ScenarioResult result = of_motion(index, ScenarioClass::Contact);
    result.motion->until = Until::Free;
    result.motion->runs = {{CellState::Open, 0, 3, 0, 2}, {CellState::Free, 3, 1}};
    result.motion->t0 = 2;
    result.motion->t1 = 3;
    return result;
}

ScenarioResult undecided(std::uint64_t index) {
    ScenarioResult result = of_motion(index, ScenarioClass::Undecided);
    result.distance_bound = 0.25;
    result.motion->until = Until::End;
    result.motion->runs = {
        {CellState::Free, 0, 2}, {CellState::Open, 2, 1}, {CellState::Free, 3, 1}};
    result.motion->t0 = result.motion->t1 = 4;
    return result;
}

ScenarioResult failed(std::uint64_t index) {
    ScenarioResult result = of_motion(index, ScenarioClass::Failed);
    result.motion.reset();
    result.failure = "lost";
    return result;
}

std::vector<ScenarioResult> examples() {
    return {hitting(0), passing(1), leaving(2), undecided(3), failed(4)};
}

ExportContext context() {
    ExportContext context;
    const auto box = share(make_box(Vec3(1, 1, 1)));
    context.bodies = {{"a", "a.obj", box}, {"b", "b.obj", box}};
    Query query;
    query.level = Level::Any;
    query.question = Question::Motion;
    query.motion = MotionQuery{0.5};
    context.describe(query);
    auto labels = std::make_shared<PoseLabels>();
    labels->times = {0, 10, 20, 30, 40};
    labels->end_times = {10, 20, 30, 40, 50};
    context.times = MotionTimes(labels);
    return context;
}

/// The files of all formats in a folder.
class MotionExport : public testing::Test {
  protected:
    MotionExport() {
        auto files = ResultSink::open({folder_.path(), {"csv", "text", "json", "npz"}}, context());
        EXPECT_TRUE(files) << files.error().detail;
        for (const ScenarioResult& result : examples()) {
            EXPECT_TRUE(files.value().add(result));
        }
        EXPECT_TRUE(files.value().finish(std::nullopt));
        first_event_ = files.value().findings().first_event;
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(folder_ / name);
    }

    const TemporaryFolder folder_;
    std::optional<FirstEvent> first_event_;
};

} // namespace

TEST(MotionTimes, AreThoseOfThePoses) {
    const MotionTimes times = context().times;
    EXPECT_EQ(times.text(hitting(0)), "first in contact between t 2.5 and 5");
    EXPECT_EQ(times.text(passing(1)), "free");
    EXPECT_EQ(times.text(leaving(2)), "free from t 27.5 on");
    EXPECT_EQ(times.bracket(leaving(2)), std::pair(25.0, 27.5));
    EXPECT_EQ(times.text(undecided(3)), "");
    EXPECT_EQ(times.bracket(undecided(3)), std::nullopt);
    EXPECT_EQ(times.text(failed(4)), "");
    ScenarioResult start = of_motion(1, ScenarioClass::Near);
    start.motion->end = MotionEnd::Start;
    EXPECT_EQ(times.text(start), "near at t 10");
    start.kind = ScenarioClass::Inside; // With a clearance.
    EXPECT_EQ(times.text(start), "near at t 10");
    ScenarioResult stuck = leaving(2);
    stuck.motion->end = MotionEnd::Contact;
    stuck.motion->runs = {{CellState::Open, 0, 4, 0, 4}};
    stuck.motion->t0 = stuck.motion->t1 = 4;
    EXPECT_EQ(times.text(stuck), "in contact at t 30, not free up to t 30");
    ScenarioResult unfinished = passing(3);
    unfinished.kind = ScenarioClass::Undecided;
    unfinished.motion->end = MotionEnd::Limit;
    unfinished.motion->runs = {{CellState::Free, 0, 3}};
    unfinished.motion->t0 = unfinished.motion->t1 = 3;
    EXPECT_EQ(times.text(unfinished), "known up to t 37.5");
    EXPECT_EQ(MotionTimes().bracket(hitting(6)), std::pair(6.25, 6.5));
    ScenarioResult begins_free = passing(1);
    begins_free.motion->until = Until::Free;
    begins_free.motion->t0 = begins_free.motion->t1 = 0;
    EXPECT_EQ(times.text(begins_free), "free at t 10");
    EXPECT_EQ(times.bracket(begins_free), std::nullopt);
}

TEST(MotionTimes, TellTheEventOrTheWayOut) {
    const MotionTimes times = context().times;
    const auto contact = times.event(hitting(0));
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->kind, FirstEvent::Kind::Contact);
    EXPECT_EQ(std::pair(contact->from, contact->to), std::pair(2.5, 5.0));
    const auto out = times.event(leaving(2));
    ASSERT_TRUE(out);
    EXPECT_EQ(out->kind, FirstEvent::Kind::Free);
    EXPECT_EQ(out->scenario, 2u);
    EXPECT_EQ(time_text(*out), "from t 27.5 on");
    ScenarioResult near = hitting(1);
    near.kind = ScenarioClass::Near;
    EXPECT_EQ(times.event(near)->kind, FirstEvent::Kind::Near);
    near.kind = ScenarioClass::Inside;
    EXPECT_EQ(times.event(near)->kind, FirstEvent::Kind::Near);
    ScenarioResult stuck = leaving(2);
    stuck.motion->end = MotionEnd::Contact;
    for (const ScenarioResult& none : {passing(1), undecided(3), failed(4), stuck}) {
        EXPECT_FALSE(times.event(none)) << none.index;
    }
}

TEST(MotionTimes, OfASceneAreThoseOfItsSteps) {
    const auto steps = std::make_shared<StepIndex>();
    steps->add_step({2});
    steps->add_step({1});
    EXPECT_EQ(MotionTimes(steps).bracket(hitting(1)), std::pair(0.25, 0.5));
    EXPECT_EQ(MotionTimes(steps).bracket(hitting(2)), std::pair(1.25, 1.5));
    steps->set_times({10, 12, 16});
    EXPECT_EQ(MotionTimes(steps).bracket(hitting(1)), std::pair(10.5, 11.0));
    EXPECT_EQ(MotionTimes(steps).text(hitting(2)), "first in contact between t 13 and 14");
}

TEST_F(MotionExport, RowsHaveTheEndAndTheBracket) {
    const std::string csv = text_of("scenarios.csv");
    EXPECT_THAT(csv, HasSubstr("class,count,end,t0,t1,cut,distance_bound"));
    EXPECT_THAT(csv, HasSubstr("0,a,b,contact,,contact,2.5,5,0,,"));
    EXPECT_THAT(csv, HasSubstr("1,a,b,separate,,free,,,0,,"));
    EXPECT_THAT(csv, HasSubstr("2,a,b,contact,,free,25,27.5,0,,"));
    EXPECT_THAT(csv, HasSubstr("3,a,b,undecided,,free,,,0,0.25,"));
    EXPECT_THAT(csv, HasSubstr("4,a,b,failed,,,,,0,,"));
    const std::string text = text_of("results.txt");
    EXPECT_THAT(text, HasSubstr("contact  first in contact between t 2.5 and 5"));
    EXPECT_THAT(text, HasSubstr("undecided  open where at most 0.25 apart"));
    const std::string json = text_of("results.jsonl");
    EXPECT_THAT(json, HasSubstr("\"end\":\"contact\",\"t0\":2.5,\"t1\":5.0"));
    EXPECT_THAT(json,
                HasSubstr("{\"state\":\"open\",\"from\":2.5,\"to\":5.0,\"event\":[5.0,5.0]}"));
}

TEST_F(MotionExport, TheFirstEventIsFound) {
    ASSERT_TRUE(first_event_);
    EXPECT_EQ(first_event_->scenario, 0u);
    EXPECT_EQ(time_text(*first_event_), "between t 2.5 and 5");
}

TEST_F(MotionExport, ArchivesHaveEachRun) {
    const auto arrays = read_npz(folder_ / "results.npz");
    ASSERT_TRUE(arrays) << arrays.error().detail;
    const auto bytes = [&](const char* name) { return arrays.value().at(name).data; };
    const auto expected = [](const auto& values) {
        const auto all = std::as_bytes(std::span(values));
        return Bytes(all.begin(), all.end());
    };
    EXPECT_EQ(bytes("end"), expected(std::vector<std::uint8_t>{1, 0, 0, 0, 0}));
    EXPECT_EQ(bytes("depth"), expected(std::vector<std::uint8_t>{2, 2, 2, 2, 0}));
    EXPECT_EQ(bytes("t1"), expected(std::vector<std::uint32_t>{2, 4, 3, 4, 0}));
    EXPECT_EQ(bytes("run_offsets"), expected(std::vector<std::uint64_t>{0, 2, 3, 5, 8, 8}));
    const std::vector<std::uint32_t> runs{0, 0, 1, 1, 0, 1, 1, 1, 2, 2, 0, 0, 4, 1,
                                          0, 1, 0, 3, 0, 2, 0, 3, 1, 1, 0, 0, 0, 2,
                                          1, 0, 1, 2, 1, 1, 0, 0, 3, 1, 1, 0};
    EXPECT_EQ(bytes("runs"), expected(runs));
    EXPECT_EQ(arrays.value().at("runs").shape, (std::vector<std::uint64_t>{8, 5}));
}

} // namespace cd::tests
