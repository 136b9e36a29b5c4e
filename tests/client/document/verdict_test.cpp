// Proves that the verdict says what was found, and names everything that was not tested.
#include "client/document/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

} // namespace

TEST(Verdict, SaysHowManyScenariosAreInContact) {
    Summary summary;
    summary.total = 1200;
    summary.separate = 1190;
    summary.touch = 1;
    summary.cross = 9;
    EXPECT_EQ(verdict_text(summary),
              "The bodies are in contact in 10 of 1 200 scenarios (cross 9, touch 1).");
    summary.touch = 0;
    EXPECT_EQ(verdict_text(summary),
              "The bodies are in contact in 9 of 1 200 scenarios (cross 9); 1 has no answer.");
}

TEST(Verdict, IsCleanOnlyIfEverythingWasTested) {
    Summary summary;
    summary.total = 5;
    summary.separate = 5;
    EXPECT_EQ(verdict_text(summary), "No contact: the bodies are separate in all of 5 scenarios.");
    summary.separate = 4;
    EXPECT_THAT(verdict_text(summary), HasSubstr("No contact was found"));
    summary.undecided = 1;
    EXPECT_THAT(verdict_text(summary), HasSubstr("in 4 of 5 scenarios; 1 is undecided."));
}

TEST(Verdict, SaysWhichBodiesAreOnlyNear) {
    Summary summary;
    summary.total = 1200;
    summary.separate = 1195;
    summary.near = 5;
    EXPECT_EQ(verdict_text(summary, "0.005 m"),
              "No contact, but the bodies are at most 0.005 m apart in 5 of 1 200 scenarios.");
    summary.cross = 2;
    summary.separate = 1190;
    EXPECT_EQ(verdict_text(summary, "0.005 m"),
              "The bodies are in contact in 2 of 1 200 scenarios (cross 2), and at most 0.005 m "
              "apart in 5 more; 3 have no answer.");
    summary.cross = 0;
    EXPECT_THAT(verdict_text(summary, "0.005 m"), HasSubstr("No contact was found, but"));
    summary.near = 0;
    summary.separate = 1200;
    EXPECT_EQ(verdict_text(summary, "0.005 m"),
              "No contact: the bodies are more than 0.005 m apart in all of 1 200 scenarios.");
    summary.separate = 1199;
    EXPECT_EQ(verdict_text(summary, "0.005 m"),
              "No contact was found: the bodies are more than 0.005 m apart in 1 199 of 1 200 "
              "scenarios; 1 has no answer.");
}

TEST(Verdict, NamesWhatWasNotTested) {
    Summary summary;
    summary.total = 5;
    summary.separate = 5;
    EXPECT_THAT(untested_texts(summary, {}, ""), IsEmpty());
    summary.separate = 1;
    summary.failed = 1;
    summary.undecided = 1;
    summary.surfaces_only = 1;
    summary.insides_skipped = 1;
    summary.cut = 1;
    Query query;
    query.level = Level::Count;
    query.limit_pairs = 3;
    query.ignored.push_back({0, 1, 0, 1});
    EXPECT_THAT(untested_texts(summary, query, "groups need pairs"),
                ElementsAre(HasSubstr("2 scenarios: without a result"),
                            HasSubstr("1 scenario: failed"),
                            HasSubstr("1 scenario: undecided"),
                            HasSubstr("a body is open"),
                            HasSubstr("parts are ignored and the rest is not closed"),
                            HasSubstr("ends at 3 pairs"),
                            HasSubstr("the job ignores"),
                            "The run lists no pairs of triangles (level count).",
                            "The groups are unknown: groups need pairs."));
}

TEST(Verdict, TellsUndecidedMotionsFromMissingAnswers) {
    Summary summary;
    summary.total = 9;
    summary.separate = 3;
    summary.contact = 2;
    summary.undecided = 2;
    EXPECT_EQ(verdict_text(summary),
              "The bodies are in contact in 2 of 9 scenarios (contact 2); 2 have no answer, 2 are "
              "undecided.");
    summary.separate = 5;
    EXPECT_THAT(verdict_text(summary), HasSubstr("(contact 2); 2 are undecided."));
    Query query;
    query.level = Level::Pairs;
    EXPECT_THAT(untested_texts(summary, query, ""),
                ElementsAre(HasSubstr("2 scenarios: undecided, since an earlier version")));
    query.question = Question::Motion;
    query.motion = MotionQuery{0.01};
    EXPECT_THAT(untested_texts(summary, query, ""),
                ElementsAre("2 scenarios: undecided, since parts of the time stay open at this "
                            "resolution"));
}

TEST(Verdict, LinesHitInBundles) {
    Summary summary;
    summary.total = 5;
    summary.separate = 5;
    EXPECT_EQ(shots_verdict_text(summary, "A"), "No line hits A in 5 bundles.");
    summary.separate = 2;
    summary.contact = 2;
    summary.pairs = 1234;
    EXPECT_EQ(shots_verdict_text(summary, "a body"),
              "Lines hit a body in 2 of 5 bundles, with 1 234 hits; 1 has no answer.");
    Query query;
    query.question = Question::Shots;
    query.level = Level::Count;
    EXPECT_THAT(untested_texts(summary, query, ""),
                testing::Contains("The run lists no hits (level count)."));
}

} // namespace cd::tests
