// Proves that packed scenarios keep their exact numbers, that packing is as small as documented,
// that parts of packed lists are packed as their scenarios are, and that no bytes make the decoder
// crash or allocate without bound.

#include "common/job/packed_scenarios.hpp"

#include "tests/support/damage.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace cd::tests {

namespace {

Pose pose_of_any_form(std::mt19937_64& random) {
    switch (random() % 4) {
    case 0:
        return Pose{};
    case 1:
        return translation_pose(uniform(random, -1, 1), 0.0, 2.5);
    case 2:
        return make_matrix_pose(random, 3.0);
    default:
        return make_pose(random, 3.0);
    }
}

std::vector<Scenario> mixed_scenarios(std::mt19937_64& random, std::size_t count) {
    std::vector<Scenario> scenarios;
    std::uint64_t index = random() % 1000;
    for (std::size_t i = 0; i < count; ++i) {
        Scenario scenario =
            make_scenario({pose_of_any_form(random), pose_of_any_form(random)}, index);
        scenario.body_b = random() % 8 == 0 ? 7u : 1u;
        if (random() % 4 == 0) {
            scenario.step = random();
        }
        if (random() % 4 == 0) {
            scenario.poses = {make_pose(random, 3.0), make_pose(random, 3.0)};
            scenario.to = PosePair{random() % 2 == 0 ? scenario.poses.a : make_pose(random, 3.0),
                                   make_pose(random, 3.0)};
        }
        scenarios.push_back(scenario);
        index = random() % 4 == 0 ? random() >> 1 : index + 1;
    }
    return scenarios;
}

Result<std::vector<Scenario>> unpack(std::span<const std::byte> bytes) {
    return unpack_scenarios(bytes, 1000);
}

std::size_t packed_size(std::span<const Scenario> scenarios) {
    return pack_scenarios(scenarios).size();
}

} // namespace

TEST(PackedScenarios, ComesBackAsItWas) {
    for (SeededRandom random : seeds(200)) {
        const auto scenarios = mixed_scenarios(random, random.seed % 40);
        const auto unpacked = unpack(pack_scenarios(scenarios));
        ASSERT_TRUE(unpacked) << unpacked.error().detail;
        ASSERT_EQ(unpacked.value(), scenarios);
    }
}

TEST(PackedScenarios, PosesKeepTheirKindAndNumbers) {
    const Pose turned = Pose::from_quaternion({2, 0, 0, 0}, Vec3(1e300, 5e-324, -0.1));
    const Pose identity = Pose::from_quaternion({1, 0, 0, 0}, Vec3::Zero());
    const std::vector<Scenario> scenarios{make_scenario({turned, Pose{}}, 0),
                                          make_scenario({Pose{}, identity}, 1)};
    const auto unpacked = unpack(pack_scenarios(scenarios));
    ASSERT_TRUE(unpacked);
    EXPECT_EQ(unpacked.value()[0].poses.a.quaternion(), (Quaternion{2, 0, 0, 0}));
    EXPECT_EQ(unpacked.value()[0].poses.a.translation(), Vec3(1e300, 5e-324, -0.1));
    EXPECT_EQ(unpacked.value()[0].poses.b.kind(), Pose::Kind::Matrix);
    EXPECT_EQ(unpacked.value()[1].poses.b.kind(), Pose::Kind::Quaternion);
}

TEST(PackedScenarios, CostsLittleMoreThanItsNumbers) {
    std::mt19937_64 random(1);
    std::vector<Scenario> quaternions;
    std::vector<Scenario> matrices;
    std::vector<Scenario> scattered;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        quaternions.push_back(make_scenario({Pose{}, make_pose(random, 1)}, 5000 + i));
        matrices.push_back(make_scenario({Pose{}, make_matrix_pose(random, 1)}, 5000 + i));
        scattered.push_back(make_scenario({Pose{}, make_pose(random, 1)}, random() % 1'000'000));
    }
    EXPECT_LE(packed_size(quaternions), 60u * 1000 + 16);
    EXPECT_LE(packed_size(matrices), 100u * 1000 + 16);
    EXPECT_LE(packed_size(scattered), 60u * 1000 + 16);
    EXPECT_EQ(packed_bytes(quaternions[0]), 60u);
    EXPECT_EQ(packed_bytes(matrices[0]), 100u);
}

TEST(PackedScenarios, GiveEachScenarioByItsPlaceInTheList) {
    for (SeededRandom random : seeds(50)) {
        const auto scenarios = mixed_scenarios(random, 1 + random.seed % 40);
        const auto packed = PackedScenarios::open(pack_scenarios(scenarios), 1000).value();
        ASSERT_EQ(packed.count(), scenarios.size());
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            ASSERT_EQ(packed.index_at(i), scenarios[i].index);
            ASSERT_EQ(
                packed.bodies_at(i),
                (ScenarioBodies{scenarios[i].body_a, scenarios[i].body_b, scenarios[i].step}));
            ASSERT_EQ(packed.at(i).value(), scenarios[i]);
        }
    }
}

TEST(PackedScenarios, PartsOfListsMakeAList) {
    for (SeededRandom random : seeds(100)) {
        std::vector<Scenario> expected;
        std::vector<PackedScenarios> lists;
        std::vector<PackedScenarios::Slice> slices;
        lists.reserve(3);
        for (int list = 0; list < 3; ++list) {
            const auto scenarios = mixed_scenarios(random, 1 + random() % 20);
            lists.push_back(PackedScenarios::open(pack_scenarios(scenarios), 1000).value());
            const std::size_t first = random() % scenarios.size();
            const std::size_t count = random() % (scenarios.size() - first + 1);
            slices.push_back({&lists.back(), first, count});
            const auto part = std::span(scenarios).subspan(first, count);
            expected.insert(expected.end(), part.begin(), part.end());
        }
        ASSERT_EQ(unpack(PackedScenarios::join(slices)).value(), expected);
    }
}

TEST(PackedScenarios, NamesTheScenarioWhosePoseIsNoPose) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Bytes bytes = pack_scenarios(std::vector<Scenario>{
        make_scenario({Pose{}, translation_pose(1, 2, 3)}, 41),
        make_scenario({Pose{}, translation_pose(1, 2, 3)}, 42),
    });
    std::memcpy(bytes.data() + bytes.size() - sizeof nan, &nan, sizeof nan);
    const auto unpacked = unpack(bytes);
    ASSERT_FALSE(unpacked);
    EXPECT_EQ(unpacked.error().code, ErrorCode::BadInput);
    EXPECT_NE(unpacked.error().detail.find("scenario 42"), std::string::npos);

    Bytes zero = pack_scenarios(std::vector<Scenario>{
        make_scenario({Pose{}, Pose::from_quaternion({1, 0, 0, 0}, Vec3::Zero())}, 7)});
    std::fill(zero.end() - 56, zero.end(), std::byte{0});
    const auto unpacked_zero = unpack(zero);
    ASSERT_FALSE(unpacked_zero);
    EXPECT_EQ(unpacked_zero.error().code, ErrorCode::BadInput);
}

TEST(PackedScenarios, RefusesEveryTruncation) {
    std::mt19937_64 random(3);
    expect_no_other_length(pack_scenarios(mixed_scenarios(random, 12)), unpack);
}

TEST(PackedScenarios, UnpackingRefusesMoreThanTheMaximumCount) {
    const Bytes bytes = pack_scenarios(std::vector<Scenario>(10, make_scenario({}, 3)));
    EXPECT_TRUE(unpack_scenarios(bytes, 10));
    // The count is checked first: the bytes after it are neither read nor kept.
    for (const auto& many : {std::span(bytes), std::span(bytes).first(2)}) {
        const auto unpacked = unpack_scenarios(many, 9);
        ASSERT_FALSE(unpacked);
        EXPECT_EQ(unpacked.error().code, ErrorCode::TooLarge);
    }
}

TEST(PackedScenarios, RefusesCountsThatTheBytesDoNotJustify) {
    // Version, count 2^35, one run of identities that claims as many, and one of their indices.
    const std::array<std::uint8_t, 21> claim{2, 0x80, 0x80, 0x80, 0x80, 0x80, 1,
                                             0, 0x80, 0x80, 0x80, 0x80, 0x80, 1,
                                             0, 1,    0,    0,    0,    0,    0};
    EXPECT_FALSE(unpack_scenarios(std::as_bytes(std::span(claim)), 1ull << 40));
}

TEST(PackedScenarios, SurvivesDamage) {
    std::mt19937_64 random(5);
    const Bytes bytes = pack_scenarios(mixed_scenarios(random, 6));
    for (int round = 0; round < 20'000; ++round) {
        Bytes damaged = bytes;
        flip_bits(random, damaged, 0, damaged.size());
        if (const auto unpacked = unpack(damaged)) {
            for (const Scenario& scenario : unpacked.value()) {
                ASSERT_TRUE(scenario.poses.a.is_finite());
                ASSERT_TRUE(scenario.poses.b.is_finite());
            }
        }
    }
}

} // namespace cd::tests
