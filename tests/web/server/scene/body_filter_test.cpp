// Proves that a body is found by its name, or else by its number, and that its scenarios pass.
#include "web/server/scene/body_filter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

const std::vector<std::string> names{"car.0", "car.1", "0"};

bool passes(const BodyFilter& filter, std::uint32_t a, std::uint32_t b) {
    ScenarioHead head;
    head.body_a = a;
    head.body_b = b;
    return filter.passes(head);
}

} // namespace

TEST(BodyFilter, PassesTheScenariosOfTheNamedBody) {
    const BodyFilter filter = BodyFilter::make(names, "car.1").value();
    EXPECT_FALSE(filter.is_empty());
    EXPECT_TRUE(passes(filter, 1, 2));
    EXPECT_TRUE(passes(filter, 0, 1));
    EXPECT_FALSE(passes(filter, 0, 2));
}

TEST(BodyFilter, ANumberIsTakenUnlessABodyHasItAsItsName) {
    EXPECT_TRUE(passes(BodyFilter::make(names, "1").value(), 0, 1));
    EXPECT_FALSE(passes(BodyFilter::make(names, "1").value(), 0, 2));
    EXPECT_TRUE(passes(BodyFilter::make(names, "0").value(), 1, 2));
    EXPECT_FALSE(passes(BodyFilter::make(names, "0").value(), 0, 1));
}

TEST(BodyFilter, WithoutABodyAllPassAndAnUnknownOneIsAnError) {
    EXPECT_TRUE(BodyFilter::make(names, "").value().is_empty());
    EXPECT_TRUE(passes(BodyFilter(), 0, 2));
    for (const std::string wanted : {"car.2", "3", "-1"}) {
        const auto filter = BodyFilter::make(names, wanted);
        ASSERT_FALSE(filter) << wanted;
        EXPECT_EQ(filter.error().code, ErrorCode::BadInput);
        EXPECT_THAT(filter.error().detail, testing::HasSubstr("no body '" + wanted + "'"));
    }
}

} // namespace cd::tests
