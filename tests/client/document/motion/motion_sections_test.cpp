// Proves that a report shows the time line of each motion, and names the first contact, the way out
// and what stays open.
#include "client/document/motion/motion_sections.hpp"

#include "common/job/result/record_file.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

/// A run of motions, each of 4 units of time. Motion i lasts from 10 i to 10 i + 10, and moves B by
/// 8 while A rests.
class MotionReport : public testing::Test {
  protected:
    MotionReport() { manifest_.bodies.resize(2); }

    ScenarioResult& add(ScenarioClass kind, MotionEnd end, std::vector<CellRun> runs) {
        ScenarioResult result;
        result.index = results_.size();
        result.question = Question::Motion;
        result.level = Level::Any;
        result.kind = kind;
        result.motion = MotionOutcome{until_, 2, end, 4, 4, std::move(runs)};
        results_.push_back(std::move(result));
        return results_.back();
    }
    void add_free() {
        ScenarioResult& free =
            add(ScenarioClass::Separate, MotionEnd::Free, {{CellState::Free, 0, 4}});
        if (until_ == Until::Free) {
            free.motion->t0 = free.motion->t1 = 0; // Where the free run begins.
        }
    }
    void add_hit() {
        ScenarioResult& hit = add(ScenarioClass::Contact,
                                  MotionEnd::Contact,
                                  {{CellState::Free, 0, 1}, {CellState::Open, 1, 1, 2, 2}});
        hit.motion->t0 = 1;
        hit.motion->t1 = 2;
    }
    void add_undecided(double bound) {
        add(ScenarioClass::Undecided,
            MotionEnd::Free,
            {{CellState::Free, 0, 1}, {CellState::Open, 1, 1}, {CellState::Free, 2, 2}})
            .distance_bound = bound;
    }
    void add_way_out() {
        ScenarioResult& out = add(ScenarioClass::Contact,
                                  MotionEnd::Free,
                                  {{CellState::Open, 0, 2, 0, 1}, {CellState::Free, 2, 1}});
        out.motion->t0 = 1;
        out.motion->t1 = 2;
    }

    [[nodiscard]] PreparedJob job() {
        PreparedJob job;
        job.spec.unit = "mm";
        job.query.question = Question::Motion;
        job.query.level = Level::Any;
        job.query.motion = MotionQuery{0.1, until_};
        job.meshes = {share(make_box({1, 1, 1})), share(make_box({1, 1, 1}))};
        job.names = {"a", "b"};
        std::vector<Scenario> scenarios(results_.size());
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            const auto time = static_cast<double>(10 * i);
            job.labels.times.push_back(time);
            job.labels.end_times.push_back(time + 10);
            scenarios[i].index = i;
            const Pose rests = moved_pose({1, 2, 3});
            scenarios[i].poses = {rests, moved_pose({0, 0, 0})};
            scenarios[i].to =
                PosePair{a_moves_ ? moved_pose({0, 0, 0}) : rests, moved_pose({0, 8, 0})};
        }
        job.poses = make_list_source(scenarios);
        return job;
    }

    [[nodiscard]] MotionSections sections() {
        const TemporaryFolder folder;
        auto writer = RecordWriter::create(folder / "records");
        for (const ScenarioResult& result : results_) {
            writer.value().add(result.index, encode_result(result));
        }
        EXPECT_TRUE(writer.value().finish());
        const auto records = RecordFile::open(folder / "records");
        auto read = MotionSections::read(records.value(), job(), {});
        EXPECT_TRUE(read) << (read ? "" : read.error().detail);
        return std::move(read.value());
    }

    [[nodiscard]] std::string verdict() { return sections().verdict(names_); }
    [[nodiscard]] std::string lines() { return sections().lines(names_).markup(); }

    Until until_ = Until::Contact;
    bool a_moves_ = false;
    std::vector<ScenarioResult> results_;
    RunManifest manifest_;
    const PreparedJob named_{};
    const RunNames names_{manifest_, named_};
};

} // namespace

TEST_F(MotionReport, NamesTheFirstContactAndWhatStaysOpen) {
    add_free();
    EXPECT_EQ(verdict(), "");
    add_undecided(0.25);
    add_hit();
    add_hit();
    EXPECT_EQ(verdict(),
              "The first contact is between t 22.5 and 25, in #2. 1 motion is undecided: in open "
              "parts of the time the bodies come within 0.25 mm of each other; the largest bound "
              "is that of #1.");
    add_undecided(0.5);
    EXPECT_THAT(verdict(), HasSubstr("2 motions are undecided: in open parts"));
    EXPECT_THAT(verdict(),
                HasSubstr("within 0.5 mm of each other; the largest bound is that of "
                          "#4."));
    ScenarioResult& cut =
        add(ScenarioClass::Undecided, MotionEnd::Limit, {{CellState::Free, 0, 3}});
    cut.motion->t0 = cut.motion->t1 = 3;
    cut.distance_bound = std::numeric_limits<double>::infinity();
    EXPECT_THAT(verdict(), HasSubstr("the search of #5 ended before its time did."));
    const std::string table = lines();
    EXPECT_THAT(table, HasSubstr("<td>open where at most 0.25 mm apart</td>"));
    EXPECT_THAT(table, HasSubstr("<td>known up to t 57.5</td>"));
}

TEST_F(MotionReport, ShowsALineOfEachMotion) {
    add_free();
    add_hit();
    const std::string table = lines();
    EXPECT_THAT(table, HasSubstr("<th>scenario</th><th>from t</th><th>time line</th>"));
    EXPECT_THAT(table, HasSubstr("<td>#0</td><td>0</td><td><svg "));
    EXPECT_THAT(table, HasSubstr("aria-label=\"free 100 %\""));
    EXPECT_THAT(table, HasSubstr("</svg></td><td>10</td><td>free</td>"));
    EXPECT_THAT(table, HasSubstr("<td>20</td><td>first in contact between t 12.5 and 15</td>"));
    EXPECT_THAT(table, Not(HasSubstr("B moves")));
    EXPECT_THAT(table, Not(HasSubstr("have no line")));
}

TEST_F(MotionReport, TellsTheWayOut) {
    until_ = Until::Free;
    add_free();
    EXPECT_EQ(verdict(), "No motion leads from contact to where the bodies are free.");
    add_way_out();
    EXPECT_EQ(verdict(), "The bodies are first free from t 15 on, in #1.");
    const std::string table = lines();
    EXPECT_THAT(table, HasSubstr("<th>B moves until free</th>"));
    EXPECT_THAT(table, HasSubstr("<td>free from t 15 on</td><td>2 to 4 mm</td>"));
    a_moves_ = true;
    EXPECT_THAT(lines(), HasSubstr("<td>free from t 15 on</td><td></td>"));
}

TEST_F(MotionReport, OfManyMotionsShowsThoseThatAreNotFree) {
    for (int i = 0; i < 150; ++i) {
        add_free();
        add_hit();
    }
    std::string markup = lines();
    EXPECT_THAT(markup, HasSubstr("Of 300 motions, 150 are free throughout and have no line.</p>"));
    EXPECT_THAT(markup, HasSubstr("<td>#299</td>"));
    EXPECT_THAT(markup, Not(HasSubstr("<td>#298</td>")));
    for (int i = 0; i < 100; ++i) {
        add_hit();
    }
    markup = lines();
    EXPECT_THAT(markup, HasSubstr("The first 200 of the others are shown."));
    EXPECT_THAT(markup, HasSubstr("<td>#349</td>"));
    EXPECT_THAT(markup, Not(HasSubstr("<td>#350</td>")));
}

TEST_F(MotionReport, HasNoLineOfAFailedMotion) {
    ScenarioResult& failed = add(ScenarioClass::Failed, MotionEnd::Free, {});
    failed.motion.reset();
    failed.failure = "lost";
    EXPECT_EQ(lines(), "");
    EXPECT_EQ(verdict(), "");
    EXPECT_EQ(sections().text(failed), "");
}

} // namespace cd::tests
