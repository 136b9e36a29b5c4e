// Proves that each scenario belongs to the step that has it, also beside steps without scenarios.

#include "common/scene/step_index.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

TEST(StepIndex, FindsTheStepOfEachScenario) {
    for (SeededRandom random : seeds(30)) {
        StepIndex index;
        std::vector<std::uint64_t> expected;
        for (std::uint64_t step = 0; step < 20; ++step) {
            const std::uint64_t scenarios = random() % 3;
            EXPECT_EQ(index.count(), expected.size());
            index.add_step({scenarios, 1, 2, 3, 4});
            EXPECT_EQ(index.first_of(step), expected.size());
            expected.insert(expected.end(), scenarios, step);
            EXPECT_EQ(index.end_of(step), expected.size());
        }
        ASSERT_EQ(index.count(), expected.size());
        for (std::uint64_t scenario = 0; scenario < expected.size(); ++scenario) {
            EXPECT_EQ(index.step_of(scenario), expected[scenario]);
        }
    }
}

TEST(StepIndex, HasTheGivenTimesOrCountsTheSteps) {
    StepIndex index;
    index.add_step({1});
    index.add_step({0});
    EXPECT_EQ(index.time_of(1), 1.0);
    index.set_times({0.5, 2.25});
    EXPECT_EQ(index.time_of(0), 0.5);
    EXPECT_EQ(index.time_of(1), 2.25);
}

} // namespace cd::tests
