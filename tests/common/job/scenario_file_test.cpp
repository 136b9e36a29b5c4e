// Proves that poses are read back bit for bit, even from a truncated file, and that their hash
// depends on their numbers alone.
#include "common/job/scenario_file.hpp"

#include "common/job/poses/poses_hash.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

namespace cd::tests {

namespace {

std::vector<Scenario> make_scenarios(std::uint64_t count) {
    std::mt19937_64 random(7);
    const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    std::vector<Scenario> scenarios(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        scenarios[i].index = i;
        const Vec3 translation(number(), number(), number());
        scenarios[i].poses.b =
            i % 3 == 0 ? Pose::from_matrix(Mat3::Identity(), translation)
                       : Pose::from_quaternion({1, number(), number(), number()}, translation);
    }
    return scenarios;
}

Sha256 hash(std::span<const Scenario> scenarios) {
    PosesHash hash;
    hash.add(scenarios);
    return hash.finish();
}

TEST(ScenarioFile, PosesComeBackAsTheyWere) {
    const TemporaryFolder folder;
    const auto scenarios = make_scenarios(9'000);
    {
        auto writer = ScenarioWriter::create(folder / "scenarios");
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer.value().add(std::span(scenarios).first(5'000)));
        ASSERT_TRUE(writer.value().add(std::span(scenarios).subspan(5'000)));
        ASSERT_TRUE(writer.value().finish());
    }
    const auto source = open_scenario_file(folder / "scenarios");
    ASSERT_TRUE(source) << source.error().detail;
    ASSERT_EQ(source.value()->count(), 9'000u);
    EXPECT_EQ(source.value()->read(0, 9'000).value(), scenarios);
    EXPECT_EQ(source.value()->read(4'990, 20).value(),
              (std::vector<Scenario>{scenarios.begin() + 4'990, scenarios.begin() + 5'010}));
    EXPECT_EQ(hash_of(*source.value()).value(), hash(scenarios));
}

TEST(ScenarioFile, AFileThatWasCutHasItsWholeBlocksAndGoesOn) {
    const TemporaryFolder folder;
    const auto path = folder / "scenarios";
    const auto scenarios = make_scenarios(100);
    {
        auto writer = ScenarioWriter::create(path);
        ASSERT_TRUE(writer);
        for (std::size_t i = 0; i < 100; i += 20) {
            ASSERT_TRUE(writer.value().add(std::span(scenarios).subspan(i, 20)));
        }
    }
    EXPECT_FALSE(open_scenario_file(path)) << "it has no table";
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
    {
        const auto source = open_unfinished_scenario_file(path);
        ASSERT_TRUE(source) << source.error().detail;
        EXPECT_EQ(source.value()->count(), 80u);
    }
    auto writer = ScenarioWriter::resume(path);
    ASSERT_TRUE(writer);
    EXPECT_EQ(writer.value().written(), 80u);
    ASSERT_TRUE(writer.value().add(std::span(scenarios).subspan(80)));
    ASSERT_TRUE(writer.value().finish());
    EXPECT_EQ(open_scenario_file(path).value()->read(0, 100).value(), scenarios);
}

TEST(PosesHash, DependsOnTheNumbersAlone) {
    const auto scenarios = make_scenarios(50);
    PosesHash in_pieces;
    in_pieces.add(std::span(scenarios).first(17));
    in_pieces.add(std::span(scenarios).subspan(17));
    EXPECT_EQ(in_pieces.finish(), hash(scenarios));
    EXPECT_NE(hash(std::span(scenarios).first(49)), hash(scenarios));

    std::vector<Scenario> changed = scenarios;
    changed[3].poses.b = Pose::from_matrix(Mat3::Identity(), Vec3(0, -0.0, 1));
    const Sha256 minus_zero = hash(changed);
    changed[3].poses.b = Pose::from_matrix(Mat3::Identity(), Vec3(-0.0, 0, 1));
    EXPECT_EQ(hash(changed), minus_zero) << "-0 counts as 0";
    changed[3].poses.b = Pose::from_quaternion({1, 0, 0, 0}, Vec3(0, 0, 1));
    EXPECT_NE(hash(changed), minus_zero) << "another form is another pose";
}

TEST(PosesHash, IsTheHashOfFormsAndDoubles) {
    Scenario scenario;
    scenario.index = 77;
    scenario.poses.b = Pose::from_quaternion({1, 2, 3, 4}, Vec3(5, -0.0, 7));
    ByteWriter expected;
    expected.put(std::uint8_t{0}); // A's identity has no numbers.
    expected.put(std::uint8_t{3});
    for (const double number : {1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 7.0}) {
        expected.put(number);
    }
    EXPECT_EQ(hash({&scenario, 1}), sha256(expected.bytes()));
}

TEST(PosesHash, IsTheHashOfAGridsDescription) {
    Grid grid;
    grid.position[0] = {0, 1, 5};
    auto source = make_grid_source(grid);
    EXPECT_EQ(hash_of(*source).value(), hash_of(grid));
    grid.position[0].count = 6;
    EXPECT_NE(hash_of(*source).value(), hash_of(grid));
}

} // namespace

} // namespace cd::tests
