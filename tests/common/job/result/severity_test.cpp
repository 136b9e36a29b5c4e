// Proves the order in which scenarios count as worse.
#include "common/job/result/severity.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {

TEST(Severity, ClassesAreOrderedFromSeparateToFailed) {
    const std::vector<ScenarioClass> order{ScenarioClass::Separate,
                                           ScenarioClass::Undecided,
                                           ScenarioClass::Near,
                                           ScenarioClass::Touch,
                                           ScenarioClass::Contact,
                                           ScenarioClass::Cross,
                                           ScenarioClass::Inside,
                                           ScenarioClass::Failed};
    EXPECT_EQ(severity(order[0]), 1u) << "0 is for scenarios without a result";
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_GT(severity(order[i]), severity(order[i - 1])) << to_text(order[i]);
    }
}

TEST(Severity, PairsOfTheClassDecideAmongEqualClasses) {
    ScenarioResult near;
    near.kind = ScenarioClass::Near;
    near.near_count = 9;
    ScenarioResult touch;
    touch.kind = ScenarioClass::Touch;
    touch.pair_count = 1;
    touch.near_count = 50;
    EXPECT_EQ(pairs_of_class(near), 9u);
    EXPECT_EQ(pairs_of_class(touch), 1u) << "near pairs of a touch do not count";
    EXPECT_GT(badness_of(touch), badness_of(near));
    ScenarioResult worse = touch;
    worse.pair_count = 2;
    worse.near_count = 0;
    EXPECT_GT(badness_of(worse), badness_of(touch));
}

TEST(Severity, HitsAreContactsAndNearScenarios) {
    for (std::uint8_t kind = 0; kind < 8; ++kind) {
        const auto value = static_cast<ScenarioClass>(kind);
        EXPECT_EQ(is_hit(value), is_contact(value) || value == ScenarioClass::Near);
    }
}

} // namespace cd::tests
