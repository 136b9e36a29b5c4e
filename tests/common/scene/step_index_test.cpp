// Proves that each scenario belongs to the step that has it, also beside steps without scenarios.

#include "common/scene/step_index.hpp"

#include "common/core/files/compress.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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

TEST(StepIndex, MotionsLastUntilTheNextStepBegins) {
    StepIndex index;
    index.add_step({1});
    index.add_step({1});
    EXPECT_EQ(index.time_at(1, 0.25), 1.25);
    index.set_times({0.5, 2.5, 3.5});
    EXPECT_EQ(index.time_at(0, 0), 0.5);
    EXPECT_EQ(index.time_at(0, 0.25), 1.0);
    EXPECT_EQ(index.time_at(0, 1), index.time_of(1));
    EXPECT_EQ(index.time_at(1, 0.75), 3.25);
    EXPECT_EQ(index.time_at(1, 1), 3.5);
}

namespace {

StepIndex some_steps(SeededRandom& random) {
    StepIndex index;
    const std::uint64_t steps = 1 + random() % 20;
    for (std::uint64_t step = 0; step < steps; ++step) {
        index.add_step({random() % 300, random() % 70000, random(), random() % 2, 0});
    }
    if (random() % 2 == 0) {
        std::vector<double> times;
        // Of motions also the last one's end has a time.
        const std::uint64_t count = steps + random() % 2;
        for (std::uint64_t step = 0; step < count; ++step) {
            times.push_back(uniform(random, -1, 1));
        }
        index.set_times(std::move(times));
    }
    return index;
}

bool are_equal(const StepIndex& left, const StepIndex& right) {
    return std::ranges::equal(left.coverage(), right.coverage()) &&
           std::ranges::equal(left.times(), right.times());
}

} // namespace

TEST(PackedSteps, ComeBackAsTheyWere) {
    for (SeededRandom random : seeds(100)) {
        const StepIndex index = some_steps(random);
        const Bytes packed = pack_steps(index);
        const auto unpacked = unpack_steps(packed, index.count());
        ASSERT_TRUE(unpacked) << unpacked.error().detail;
        EXPECT_TRUE(are_equal(*unpacked.value(), index));
        EXPECT_EQ(unpacked.value()->count(), index.count());
        EXPECT_FALSE(unpack_steps(packed, index.count() + 1));
        EXPECT_FALSE(index.count() > 0 && unpack_steps(packed, index.count() - 1));
    }
}

TEST(PackedSteps, RefuseTimesOfAnotherKind) {
    // Version 1, one step without pairs, times of a kind that does not exist.
    const auto packed = [](std::uint8_t kind) {
        ByteWriter out;
        for (const std::uint8_t byte : {std::uint8_t{1}, std::uint8_t{1}, kind}) {
            out.put(byte);
        }
        out.put_array(std::span<const std::uint8_t>(std::array<std::uint8_t, 5>{}));
        out.put_array(std::span<const double>(std::array<double, 2>{0, 1}));
        return compress(out.bytes(), 3);
    };
    const auto with_end = unpack_steps(packed(2), 0);
    ASSERT_TRUE(with_end) << with_end.error().detail;
    EXPECT_EQ(with_end.value()->time_at(0, 0.5), 0.5);
    EXPECT_FALSE(unpack_steps(packed(1), 0)) << "one number too many";
    EXPECT_FALSE(unpack_steps(packed(3), 0));
}

TEST(PackedSteps, RefuseDamage) {
    for (SeededRandom random : seeds(200)) {
        const StepIndex index = some_steps(random);
        Bytes packed = pack_steps(index);
        EXPECT_FALSE(
            unpack_steps(std::span(packed).first(random() % packed.size()), index.count()));
        packed[random() % packed.size()] = static_cast<std::byte>(random());
        const auto unpacked = unpack_steps(packed, index.count());
        if (unpacked) {
            EXPECT_EQ(unpacked.value()->count(), index.count());
        }
    }
}

} // namespace cd::tests
