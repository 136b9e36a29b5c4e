// Proves that levels have the names that users write, and that a query asks one question.

#include "common/job/query.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace cd::tests {

TEST(Query, LevelsHaveNames) {
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        EXPECT_EQ(level_from_text(to_text(level)), level);
    }
    EXPECT_EQ(to_text(Level::Contacts), "contacts");
    EXPECT_EQ(level_from_text("Any"), std::nullopt);
    EXPECT_EQ(level_from_text(""), std::nullopt);
}

namespace {

Query distance_query() {
    Query query;
    query.level = Level::Any;
    query.question = Question::Distance;
    return query;
}

std::string problem_with(Query query, const std::function<void(Query&)>& change) {
    change(query);
    const char* problem = query_problem(query);
    return problem != nullptr ? problem : "none";
}

} // namespace

TEST(Query, AskedForContactsHasALevelAndAClearanceButNoUpTo) {
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        Query query;
        query.level = level;
        EXPECT_EQ(query_problem(query), nullptr);
        EXPECT_EQ(problem_with(query, [](Query& q) { q.clearance = 0.0; }), "none");
        EXPECT_EQ(problem_with(query, [](Query& q) { q.clearance = -1.0; }),
                  "a clearance that is negative or not finite");
        EXPECT_EQ(problem_with(query, [](Query& q) { q.up_to = 1.0; }),
                  "an up_to without the question of the distance");
    }
}

TEST(Query, IgnoredPartsAreInTheOrderOfTheirBodies) {
    EXPECT_EQ(problem_with({},
                           [](Query& q) {
                               q.ignored = {{0, 1, 0, 1, 0, 2}, {0, 1, 0, 1, 1, 2}};
                           }),
              "none");
    EXPECT_EQ(problem_with({},
                           [](Query& q) {
                               q.ignored = {{0, 1, 0, 1, 1, 2}, {0, 1, 0, 1, 0, 2}};
                           }),
              "ignored parts whose bodies are not in order");
}

TEST(Query, AskedForADistanceHasAnUpToAndIgnoredTrianglesAlone) {
    EXPECT_EQ(query_problem(distance_query()), nullptr);
    EXPECT_EQ(problem_with(distance_query(), [](Query& q) { q.ignored = {{0, 1, 0, 1}}; }), "none");
    for (const double up_to : {0.0, 5e-324, 1e300}) {
        EXPECT_EQ(problem_with(distance_query(), [&](Query& q) { q.up_to = up_to; }), "none");
    }
    for (const double none : {-1.0, HUGE_VAL, std::nan("")}) {
        EXPECT_EQ(problem_with(distance_query(), [&](Query& q) { q.up_to = none; }),
                  "an up_to that is negative or not finite");
    }
    const std::string more = "a distance with a level, clearance, maps or limit_pairs";
    EXPECT_EQ(problem_with(distance_query(), [](Query& q) { q.level = Level::Count; }), more);
    EXPECT_EQ(problem_with(distance_query(), [](Query& q) { q.clearance = 1; }), more);
    EXPECT_EQ(problem_with(distance_query(), [](Query& q) { q.maps = true; }), more);
    EXPECT_EQ(problem_with(distance_query(), [](Query& q) { q.limit_pairs = 1; }), more);
}

TEST(Query, AskedForMotionsHasAResolutionAndListsPairsAtMost) {
    Query motion;
    motion.question = Question::Motion;
    motion.motion = MotionQuery{0.5, Until::Free};
    const std::string misfit = "a motion with maps, or at another level than any and pairs";
    for (const Level level : {Level::Any, Level::Pairs}) {
        motion.level = level;
        EXPECT_EQ(query_problem(motion), nullptr);
        EXPECT_EQ(problem_with(motion, [](Query& q) { q.clearance = 0.1; }), "none");
        EXPECT_EQ(problem_with(motion, [](Query& q) { q.limit_pairs = 7; }), "none");
        EXPECT_EQ(problem_with(motion, [](Query& q) { q.maps = true; }), misfit);
        EXPECT_EQ(problem_with(motion, [](Query& q) { q.up_to = 1; }),
                  "an up_to without the question of the distance");
    }
    for (const Level level : {Level::Count, Level::Contacts}) {
        EXPECT_EQ(problem_with(motion, [&](Query& q) { q.level = level; }), misfit);
    }
    const std::string none = "a motion without a resolution above 0";
    EXPECT_EQ(problem_with(motion, [](Query& q) { q.motion.reset(); }), none);
    for (const double resolution : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
        EXPECT_EQ(problem_with(motion, [&](Query& q) { q.motion->resolution = resolution; }), none);
    }
    EXPECT_EQ(problem_with({}, [](Query& q) { q.motion = MotionQuery{0.5}; }),
              "a resolution without the question of motions");
}

TEST(Query, AskedForShotsHasALevelLimitsAndMapsButNoClearance) {
    Query shots;
    shots.question = Question::Shots;
    const std::string misfit = "shots with a clearance, or at another level than count and pairs";
    for (const Level level : {Level::Count, Level::Pairs}) {
        shots.level = level;
        EXPECT_EQ(query_problem(shots), nullptr);
        EXPECT_EQ(problem_with(shots, [](Query& q) { q.first_hits = true; }), "none");
        EXPECT_EQ(problem_with(shots, [](Query& q) { q.maps = true; }), "none");
        EXPECT_EQ(problem_with(shots, [](Query& q) { q.limit_pairs = 1; }), "none");
        EXPECT_EQ(problem_with(shots, [](Query& q) { q.ignored = {{0, 1, 0, 1}}; }), "none");
        EXPECT_EQ(problem_with(shots, [](Query& q) { q.clearance = 1; }), misfit);
        EXPECT_EQ(problem_with(shots, [](Query& q) { q.up_to = 1; }),
                  "an up_to without the question of the distance");
    }
    for (const Level level : {Level::Any, Level::Contacts}) {
        EXPECT_EQ(problem_with(shots, [&](Query& q) { q.level = level; }), misfit);
    }
    Query contacts;
    for (const Question question : {Question::Contacts, Question::Distance}) {
        contacts.question = question;
        EXPECT_EQ(problem_with(contacts, [](Query& q) { q.first_hits = true; }),
                  "first hits without the question of shots");
    }
}

TEST(Query, HasAQuestionThatExists) {
    Query query;
    for (const int question : {4, 7, 255}) {
        query.question = static_cast<Question>(question);
        EXPECT_STREQ(query_problem(query), "an unknown question") << question;
    }
}

} // namespace cd::tests
