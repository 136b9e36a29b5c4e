// Proves that bodies are chosen by their names, and that a wrong name is told with the nearest one.
#include "client/groups/body_choice.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

Result<BodyChoice> choose(const std::vector<std::string>& names) {
    const std::vector<std::string> bodies{"truck", "car.0", "car.1", "wall"};
    return BodyChoice::of_names(names, bodies);
}

} // namespace

TEST(BodyChoice, AScenarioIsOfTheChosenIfOneOfItsBodiesIs) {
    const BodyChoice choice = choose({"wall", "car.1"}).value();
    EXPECT_FALSE(choice.is_all());
    EXPECT_EQ(choice.text(), "wall, car.1");
    EXPECT_TRUE(choice.has(0, 3));
    EXPECT_TRUE(choice.has(2, 3));
    EXPECT_TRUE(choice.has(1, 2));
    EXPECT_FALSE(choice.has(0, 1));
}

TEST(BodyChoice, WithoutNamesAllAreChosen) {
    const BodyChoice choice = choose({}).value();
    EXPECT_TRUE(choice.is_all());
    EXPECT_TRUE(choice.has(0, 1));
    EXPECT_EQ(choice.text(), "");
}

TEST(BodyChoice, AWrongNameIsToldWithTheNearest) {
    const auto wrong = choose({"wall", "car.2"});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, ErrorCode::BadInput);
    EXPECT_EQ(wrong.error().detail,
              "--body: the run has no body \"car.2\"; did you mean \"car.0\"?");
}

} // namespace cd::tests
