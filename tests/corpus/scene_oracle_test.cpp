// Proves that the scenario oracle agrees with interval tests on boxes.
#include "tests/support/scene_oracle.hpp"

#include "tests/corpus/solids.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

namespace cd::tests {

TEST(SceneOracle, EqualsTheIntervalsOfBoxes) {
    std::map<ScenarioClass, int> seen;
    for (SeededRandom random : seeds(400)) {
        std::array<Vec3, 4> ends;
        for (int k = 0; k < 3; ++k) {
            for (const std::size_t body : {std::size_t{0}, std::size_t{2}}) {
                ends[body][k] = static_cast<double>(random() % 4);
                ends[body + 1][k] = ends[body][k] + 1 + static_cast<double>(random() % 3);
            }
        }
        if (random.seed % 4 == 0) { // B encloses A or shares a wall with it.
            const double low = -static_cast<double>(random() % 2);
            ends[2] = Vec3::Constant(low);
            ends[3] = Vec3::Constant(7);
        }
        bool overlap = true;
        bool touch = true;
        bool a_in_b = true;
        bool b_in_a = true;
        for (int k = 0; k < 3; ++k) {
            overlap = overlap && ends[0][k] < ends[3][k] && ends[2][k] < ends[1][k];
            touch = touch && ends[0][k] <= ends[3][k] && ends[2][k] <= ends[1][k];
            a_in_b = a_in_b && ends[2][k] < ends[0][k] && ends[1][k] < ends[3][k];
            b_in_a = b_in_a && ends[0][k] < ends[2][k] && ends[3][k] < ends[1][k];
        }
        const ScenarioClass meeting = a_in_b || b_in_a ? ScenarioClass::Inside
                                      : overlap        ? ScenarioClass::Cross
                                      : touch          ? ScenarioClass::Touch
                                                       : ScenarioClass::Separate;
        const SceneOracle oracle(
            make_box_between(ends[0], ends[1]), make_box_between(ends[2], ends[3]), {});
        ASSERT_EQ(to_text(oracle.scenario_class(true)), to_text(meeting));
        ++seen[meeting];
    }
    EXPECT_EQ(seen.size(), 4u);
}

} // namespace cd::tests
