// Proves which targets are routes of the page, and that others are refused with a reason.
#include "web/server/page_request.hpp"

#include "common/core/limits/web.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

PageRequest parsed(const std::string& target) {
    const auto request = parse_page_request("/api/v1/" + target);
    EXPECT_TRUE(request) << target << ": " << request.error().detail;
    return request ? request.value() : PageRequest();
}

ErrorCode error_of(const std::string& target) {
    const auto request = parse_page_request(target);
    EXPECT_FALSE(request) << target;
    return request ? ErrorCode::Incomplete : request.error().code;
}

const std::string mesh(64, 'a');

} // namespace

TEST(PageRequests, EachRouteHasItsTopic) {
    EXPECT_EQ(parsed("source").topic, PageTopic::Source);
    EXPECT_EQ(parsed("cluster").topic, PageTopic::Cluster);
    EXPECT_EQ(parsed("history").topic, PageTopic::History);
    EXPECT_EQ(parsed("jobs").topic, PageTopic::Jobs);
    EXPECT_EQ(parsed("jobs/j-4f2a").topic, PageTopic::Job);
    EXPECT_EQ(parsed("jobs/j-4f2a").job, "j-4f2a");
    EXPECT_EQ(parsed("jobs/j/progress").topic, PageTopic::Progress);
    EXPECT_EQ(parsed("jobs/j/progress").job, "j");
    EXPECT_EQ(parsed("jobs/j/classes?sample=7").topic, PageTopic::Classes);
    EXPECT_EQ(parsed("jobs/j/counts?sample=7").topic, PageTopic::Counts);
    EXPECT_EQ(parsed("jobs/j/distances?sample=7").topic, PageTopic::Distances);
    EXPECT_EQ(parsed("jobs/j/poses?sample=7").topic, PageTopic::Poses);
    EXPECT_EQ(parsed("jobs/j/keys?sample=7").topic, PageTopic::Keys);
    EXPECT_EQ(parsed("jobs/j/bodies?first=2&count=3").topic, PageTopic::Bodies);
    EXPECT_EQ(parsed("jobs/j/steps?sample=7").topic, PageTopic::Steps);
    EXPECT_EQ(parsed("jobs/j/map/1").topic, PageTopic::Map);
    EXPECT_EQ(parsed("jobs/j/parts/1/names").topic, PageTopic::PartNames);
    EXPECT_EQ(parsed("jobs/j/parts/0/closed").topic, PageTopic::ClosedParts);
    EXPECT_EQ(parsed("jobs/j/scenarios/5/hits").topic, PageTopic::Hits);
    EXPECT_EQ(parsed("jobs/j/map/1").number, 1u);
    EXPECT_EQ(parsed("jobs/j/parts/1").topic, PageTopic::Parts);
    EXPECT_EQ(parsed("jobs/j/parts/1").number, 1u);
    EXPECT_EQ(parsed("jobs/j/parts/0/names").topic, PageTopic::PartNames);
    EXPECT_EQ(parsed("jobs/j/scenarios/17").topic, PageTopic::Scenario);
    EXPECT_EQ(parsed("jobs/j/scenarios/17/pairs").topic, PageTopic::Pairs);
    EXPECT_EQ(parsed("jobs/j/scenarios/17/points").topic, PageTopic::Points);
    EXPECT_EQ(parsed("jobs/j/scenarios/17/points").number, 17u);
    EXPECT_EQ(to_hex(parsed("meshes/" + mesh).mesh), mesh);
}

TEST(PageRequests, ARangeASampleAndASearchAreRead) {
    const ScenarioChoice range = parsed("jobs/j/classes?first=10&count=5").choice;
    EXPECT_EQ(range.size(), 5u);
    EXPECT_EQ(range.at(4, 1000), 14u);
    const ScenarioChoice sample = parsed("jobs/j/classes?sample=4").choice;
    EXPECT_EQ(sample.size(), 4u);
    EXPECT_EQ(sample.at(3, 10), 7u);
    const NextContact next =
        parsed("jobs/j/scenarios/next?from=9&step=-1&part_a=a%2Fb%20c&part_b=d+e").next;
    EXPECT_EQ(next.from, 9u);
    EXPECT_TRUE(next.is_backwards);
    EXPECT_EQ(next.part_a, "a/b c");
    EXPECT_EQ(next.body_a, "") << "A's";
    EXPECT_EQ(next.part_b, "d e");
    EXPECT_FALSE(parsed("jobs/j/scenarios/next?from=0").next.is_backwards);
    EXPECT_EQ(parsed("jobs/j/scenarios/next?from=0").next.body, "");
    EXPECT_EQ(parsed("jobs/j/scenarios/next?from=0&body=car.3%2Fx").next.body, "car.3/x");
    const NextContact of_scene =
        parsed("jobs/j/scenarios/next?from=0&part_a=hood&body_a=car.3&part_b=post&body_b=7").next;
    EXPECT_EQ(of_scene.body_a, "car.3");
    EXPECT_EQ(of_scene.body_b, "7");
    EXPECT_EQ(next.kind, NextContact::Kind::Contact);
    EXPECT_EQ(parsed("jobs/j/scenarios/next?from=9&class=near").next.kind, NextContact::Kind::Near);
    EXPECT_EQ(parsed("jobs/j/scenarios/next?from=9&class=either").next.kind,
              NextContact::Kind::Either);
    EXPECT_FALSE(parse_page_request("/api/v1/jobs/j/scenarios/next?from=9&class=cross"));
}

TEST(PageRequests, ASearchMeansScenariosAndPairsOfItsClass) {
    NextContact wanted;
    const auto has = [&](ScenarioClass kind) {
        return wanted.has_class(static_cast<std::uint8_t>(kind));
    };
    EXPECT_TRUE(has(ScenarioClass::Inside));
    EXPECT_FALSE(has(ScenarioClass::Near));
    EXPECT_FALSE(wanted.has_pair(PairClass::Near));
    wanted.kind = NextContact::Kind::Near;
    EXPECT_FALSE(has(ScenarioClass::Touch));
    EXPECT_TRUE(has(ScenarioClass::Near));
    EXPECT_TRUE(wanted.has_pair(PairClass::Near));
    EXPECT_FALSE(wanted.has_pair(PairClass::Touch));
    wanted.kind = NextContact::Kind::Either;
    EXPECT_TRUE(has(ScenarioClass::Near) && has(ScenarioClass::Contact));
    EXPECT_TRUE(wanted.has_pair(PairClass::Near) && wanted.has_pair(PairClass::Proper));
    EXPECT_FALSE(has(ScenarioClass::Separate) || has(ScenarioClass::Failed));
    EXPECT_FALSE(wanted.has_class(255)) << "without a result";
}

TEST(PageRequests, OtherTargetsAreNoRoutes) {
    for (const std::string target : {"/",
                                     "/api/v1/",
                                     "/api/v2/jobs",
                                     "/api/v1/job",
                                     "/api/v1/jobs/",
                                     "/api/v1/jobs/j/",
                                     "/api/v1/jobs/j/map",
                                     "/api/v1/jobs/j/bodies/1",
                                     "/api/v1/jobs/j/map/x",
                                     "/api/v1/jobs/j/map/0/names",
                                     "/api/v1/jobs/j/parts/names",
                                     "/api/v1/jobs/j/parts/0/name",
                                     "/api/v1/jobs/j/scenarios",
                                     "/api/v1/jobs/j/scenarios/-1",
                                     "/api/v1/jobs/j/scenarios/1/lines",
                                     "/api/v1/jobs/j/scenarios/1/pairs/2",
                                     "/api/v1/jobs/../../etc/passwd",
                                     "/api/v1/meshes/abc",
                                     "http://127.0.0.1/api/v1/jobs"}) {
        EXPECT_EQ(error_of(target), ErrorCode::NotFound) << target;
    }
}

TEST(PageRequests, AParameterThatIsMissingUnknownOrInvalidIsRefused) {
    for (const std::string target : {"classes",
                                     "classes?first=0",
                                     "classes?count=1&first=-1",
                                     "classes?first=0&count=99999999999999999999",
                                     "classes?sample=0",
                                     "classes?sample=4&first=0",
                                     "classes?first=0&count=1&x=2",
                                     "classes?first=%3",
                                     "bodies",
                                     "steps?step=3",
                                     "scenarios/next",
                                     "scenarios/next?from=0&step=2",
                                     "scenarios/next?from=0&part_a=%zz",
                                     "map/0?first=1"}) {
        EXPECT_EQ(error_of("/api/v1/jobs/j/" + target), ErrorCode::BadInput) << target;
    }
    EXPECT_EQ(error_of("/api/v1/jobs/j/scenarios/next?from=0&part_a=" + std::string(5000, 'x')),
              ErrorCode::BadInput);
}

TEST(PageRequests, AChoiceStaysWithinTheJobAndItsBounds) {
    const auto check = [](std::uint64_t first, std::uint64_t count, std::uint64_t sample) {
        return ScenarioChoice{first, count, sample}.check(100, 50).has_value();
    };
    EXPECT_TRUE(check(0, 50, 0));
    EXPECT_TRUE(check(50, 50, 0));
    EXPECT_TRUE(check(100, 0, 0));
    EXPECT_FALSE(check(0, 51, 0));
    EXPECT_FALSE(check(51, 50, 0));
    EXPECT_FALSE(check(UINT64_MAX, 50, 0));
    EXPECT_TRUE(check(0, 0, limits::page_sample_max));
    EXPECT_FALSE(check(0, 0, limits::page_sample_max + 1));
}

} // namespace cd::tests
