// Proves that a scenario passes the filter if it has a pair of the wanted parts, no matter which of
// the two bodies is its A, and that an error names an unknown body or part.
#include "web/server/part_filter.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {
namespace {

const std::vector<std::string> scene{"car.0", "car.1", "wall"};

/// Each body has the parts `body`, of the triangles below 5, and `wheel`.
Result<std::shared_ptr<const NamedParts>> parts_of_each(std::uint32_t /*body*/) {
    return std::make_shared<const NamedParts>(
        NamedParts{PartRuns::create({{0, 0}, {5, 1}}).value(), {"body", "wheel"}});
}

ScenarioResult result_of(std::uint32_t a, std::uint32_t b, std::vector<ContactPair> pairs) {
    ScenarioResult result;
    result.body_a = a;
    result.body_b = b;
    result.pairs = std::move(pairs);
    return result;
}

NextContact wheel_of(const std::string& body) {
    NextContact wanted;
    wanted.part_a = "wheel";
    wanted.body_a = body;
    return wanted;
}

bool passes(const NextContact& wanted, const ScenarioResult& result) {
    const auto filter = PartFilter::make(scene, parts_of_each, wanted);
    EXPECT_TRUE(filter);
    return filter && filter.value().passes(result);
}

std::string problem_of(std::span<const std::string> bodies, const NextContact& wanted) {
    const auto filter = PartFilter::make(bodies, parts_of_each, wanted);
    return filter ? "" : filter.error().detail;
}

} // namespace

TEST(PartFilter, FindsAPartOfABodyOnEitherSide) {
    const std::vector<ContactPair> pairs{{7, 2, PairClass::Proper}};
    EXPECT_TRUE(passes(wheel_of("car.1"), result_of(1, 2, pairs)));
    EXPECT_FALSE(passes(wheel_of("car.1"), result_of(0, 1, pairs))) << "car.1 is B: its body";
    EXPECT_TRUE(passes(wheel_of("car.1"), result_of(0, 1, {{2, 7, PairClass::Proper}})));
    EXPECT_FALSE(passes(wheel_of("car.1"), result_of(0, 2, pairs))) << "another body's wheel";
    EXPECT_TRUE(passes(wheel_of("1"), result_of(1, 2, pairs))) << "by its number";
}

TEST(PartFilter, WantsBothPartsInOnePair) {
    NextContact wanted = wheel_of("car.0");
    wanted.part_b = "body";
    wanted.body_b = "wall";
    EXPECT_TRUE(passes(wanted, result_of(0, 2, {{7, 2, PairClass::Proper}})));
    EXPECT_FALSE(passes(wanted, result_of(0, 1, {{7, 2, PairClass::Proper}})));
    const std::vector<ContactPair> apart{{7, 8, PairClass::Proper}, {1, 2, PairClass::Proper}};
    EXPECT_FALSE(passes(wanted, result_of(0, 2, apart)));
    EXPECT_FALSE(passes(wanted, result_of(0, 2, {{7, 2, PairClass::Near}})));
    wanted.kind = NextContact::Kind::Near;
    EXPECT_TRUE(passes(wanted, result_of(0, 2, {{7, 2, PairClass::Near}})));
}

TEST(PartFilter, TakesAAndBOfTwoBodies) {
    const std::vector<std::string> two{"a", "b"};
    NextContact wanted;
    wanted.part_b = "wheel";
    const auto filter = PartFilter::make(two, parts_of_each, wanted);
    ASSERT_TRUE(filter);
    EXPECT_TRUE(filter.value().passes(result_of(0, 1, {{1, 7, PairClass::Proper}})));
    EXPECT_FALSE(filter.value().passes(result_of(0, 1, {{7, 1, PairClass::Proper}})));
    EXPECT_TRUE(PartFilter::make(two, parts_of_each, {}).value().is_empty());
}

TEST(PartFilter, NamesWhatThereIsNot) {
    EXPECT_EQ(problem_of(scene, wheel_of("lorry")), "the job has no body 'lorry'");
    EXPECT_EQ(problem_of(scene, wheel_of("")),
              "the parts of a scene are looked for with their bodies: body_a, body_b");
    NextContact door = wheel_of("wall");
    door.part_a = "door";
    EXPECT_EQ(problem_of(scene, door), "the body has no part 'door'");
}

} // namespace cd::tests
