// Proves that the explanation of a choice shows every worker, the chosen and the excluded ones, and
// what the scores do not include; for people and programs, for strategies by triangles and by time.
#include "client/report/explain_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

Explained make_explained(std::string_view strategy, bool is_by_time = false) {
    Explained explained;
    explained.job = JobId{1};
    explained.scenario = 17;
    explained.strategy = strategy;
    explained.is_by_time = is_by_time;
    explained.where = "waits";
    explained.why = "it is drawn next";
    explained.roots_a = 3;
    explained.roots_b = 2;
    explained.workers = {
        {WorkerId{4}, "node-4", true, true, 25, 0.5, 1500, 200, 0.001, 0.002, 0.003, 0.004, 0, 0.5},
        {WorkerId{9}, "node-9", false, false, 7, 0, 0, 1700, 0, 0, 0.25, 0, 0.125, 0.5}};
    return explained;
}

/// Returns the line that contains `name`.
std::string line_with(const std::string& text, const std::string& name) {
    const auto at = text.find(name);
    if (at == std::string::npos) {
        return "";
    }
    const auto begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
}

TEST(ExplainReport, ByTrianglesEachWorkerHasALineWithWhatItHoldsAndLacks) {
    const std::string text = explained_text(make_explained("best-match"), "j-1");
    EXPECT_TRUE(text.starts_with("scenario 17 of j-1, best-match\n")) << text;
    EXPECT_THAT(text, HasSubstr("touches     3 roots of A, 2 of B\n"));
    EXPECT_THAT(text, HasSubstr("is          waits\n"));
    EXPECT_THAT(text, HasSubstr("now chosen  it is drawn next\n"));
    EXPECT_THAT(text, HasSubstr("MISSING"));
    EXPECT_THAT(text, Not(HasSubstr("TOTAL MS")));
    const std::string chosen = line_with(text, "node-4");
    EXPECT_THAT(chosen, HasSubstr("w-4"));
    EXPECT_THAT(chosen, HasSubstr("1 500"));
    EXPECT_THAT(chosen, HasSubstr("50 %"));
    EXPECT_TRUE(chosen.ends_with("chosen")) << chosen;
    EXPECT_TRUE(line_with(text, "node-9").ends_with("takes none")) << text;
}

TEST(ExplainReport, ByTimeEachTermStandsInMillisecondsAndTheyAddUp) {
    const std::string text = explained_text(make_explained("earliest-finish", true), "j-1");
    EXPECT_THAT(text, Not(HasSubstr("MISSING")));
    const std::string chosen = line_with(text, "node-4");
    for (const char* term : {"1.000", "2.000", "3.000", "4.000", "0.000", "500.000", "510.000"}) {
        EXPECT_THAT(chosen, HasSubstr(term));
    }
    EXPECT_THAT(line_with(text, "node-9"), HasSubstr("875.000"));
}

TEST(ExplainReport, OmissionsOfScoresAreListedOnlyIfAny) {
    Explained explained = make_explained("best-match");
    EXPECT_THAT(explained_text(explained, "j-1"), Not(HasSubstr("note")));
    explained.note = "the job has ended";
    EXPECT_THAT(explained_text(explained, "j-1"), HasSubstr("  note        the job has ended\n"));
}

TEST(ExplainReport, WithoutWorkersThereIsNoTable) {
    Explained explained = make_explained("best-match");
    explained.workers.clear();
    const std::string text = explained_text(explained, "j-1");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
    EXPECT_TRUE(nlohmann::json::parse(explained_json(explained, "j-1"))["workers"].empty());
}

TEST(ExplainReport, OfAJobThatHasEndedThereAreNoScores) {
    Explained explained;
    explained.job = JobId{1};
    explained.scenario = 17;
    explained.strategy = "best-match";
    explained.where = "answered by node-4 (w-4)";
    explained.note = "the job has ended, so no worker is scored";
    EXPECT_EQ(explained_text(explained, "j-1"),
              "scenario 17 of j-1, best-match\n"
              "  is          answered by node-4 (w-4)\n"
              "  note        the job has ended, so no worker is scored\n");
    const auto json = nlohmann::json::parse(explained_json(explained, "j-1"));
    EXPECT_EQ(json["where"], explained.where);
    EXPECT_FALSE(json.contains("roots_a"));
    EXPECT_TRUE(json["workers"].empty());
}

TEST(ExplainReport, JsonGivesEachNumberAsItIs) {
    Explained explained = make_explained("best-match-load");
    explained.note = "as things stand";
    auto json = nlohmann::json::parse(explained_json(explained, "j-1"));
    EXPECT_EQ(json["job"], "j-1");
    EXPECT_EQ(json["scenario"], 17);
    EXPECT_EQ(json["strategy"], "best-match-load");
    EXPECT_EQ(json["note"], "as things stand");
    EXPECT_EQ(json["roots_a"], 3);
    EXPECT_EQ(json["roots_b"], 2);
    ASSERT_EQ(json["workers"].size(), 2u);
    EXPECT_EQ(json["workers"][0]["worker"], "w-4");
    EXPECT_EQ(json["workers"][0]["chosen"], true);
    EXPECT_EQ(json["workers"][0]["load"], 0.5);
    EXPECT_EQ(json["workers"][1]["missing_triangles"], 1700);
    EXPECT_EQ(json["workers"][1]["may_take"], false);
    EXPECT_FALSE(json["workers"][0].contains("total_ms")) << "it does not go by time";

    json = nlohmann::json::parse(explained_json(make_explained("earliest-finish", true), "j-1"));
    EXPECT_EQ(json["workers"][1]["eviction_ms"], 125);
    EXPECT_EQ(json["workers"][1]["total_ms"], 875);
}

TEST(ExplainReport, OfAMotionTheTestedCellsAndLeavesAreCounted) {
    Explained explained = make_explained("best-match");
    EXPECT_THAT(explained_text(explained, "j-1"), Not(HasSubstr("  tests ")));
    EXPECT_FALSE(nlohmann::json::parse(explained_json(explained, "j-1")).contains("effort"));
    explained.effort = SearchEffort{1041, 521, 12, 12};
    EXPECT_THAT(explained_text(explained, "j-1"),
                HasSubstr("  tests       1 041 cells of time, 521 of them leaves\n"));
    const auto json = nlohmann::json::parse(explained_json(explained, "j-1"));
    EXPECT_EQ(json["effort"], nlohmann::json({{"cells", 1041}, {"leaves", 521}}));
}

TEST(ExplainReport, OfADistanceTheRootPairsNamedAndUsedAreCounted) {
    Explained explained = make_explained("best-match");
    explained.effort = SearchEffort{0, 0, 12, 3};
    EXPECT_THAT(explained_text(explained, "j-1"),
                HasSubstr("  needs       3 of 12 pairs of roots that may have the distance\n"));
    const auto json = nlohmann::json::parse(explained_json(explained, "j-1"));
    EXPECT_EQ(json["effort"], nlohmann::json({{"roots_named", 12}, {"roots_used", 3}}));
}

TEST(ExplainReport, NamesCannotSteerATerminalOrBreakJson) {
    Explained explained = make_explained("best-match");
    explained.workers[0].name = "\x1b[2Jx\xff";
    EXPECT_THAT(explained_text(explained, "j-1"), Not(HasSubstr("\x1b")));
    EXPECT_TRUE(nlohmann::json::accept(explained_json(explained, "j-1")));
}

} // namespace
} // namespace cd::tests
