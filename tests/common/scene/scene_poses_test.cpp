// Proves that a scene's scenarios are those of all pairs of bodies whose boxes come within reach,
// by brute force; that none of the pairs in contact is lost; and that the coverage counts each pair
// of bodies once.

#include "common/scene/scene_poses.hpp"

#include "common/search/brute_force.hpp"
#include "tests/common/scene/box_pairs.hpp"
#include "tests/common/scene/listed_steps.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace cd::tests {

namespace {

/// A scene whose rules, meshes and poses are at hand.
struct RandomScene {
    std::vector<Mesh> meshes;
    std::vector<bool> is_fixed;
    std::vector<PosesOfStep> steps;
    std::vector<BodyPair> ignored;
    double reach = 0;

    [[nodiscard]] Scene scene() const {
        Scene made{{}, PairSet(meshes.size()), reach};
        for (std::size_t body = 0; body < meshes.size(); ++body) {
            made.bodies.push_back({bounding_box(meshes[body].vertices()), is_fixed[body]});
        }
        for (const BodyPair& pair : ignored) {
            made.ignored.add(std::array{pair.b}, std::array{pair.a});
        }
        return made;
    }
    [[nodiscard]] bool is_ignored(BodyPair pair) const {
        return std::ranges::find(ignored, pair) != ignored.end();
    }
};

RandomScene random_scene(std::mt19937_64& random, double reach) {
    RandomScene made;
    made.reach = reach;
    const std::size_t bodies = 2 + random() % 12;
    PosesOfStep first;
    for (std::uint32_t body = 0; body < bodies; ++body) {
        made.meshes.push_back(make_triangle_soup(random, 8, 1.2));
        made.is_fixed.push_back(random() % 3 == 0);
        first.emplace_back(make_pose(random, 2.0));
        for (std::uint32_t other = 0; other < body; ++other) {
            if (random() % 4 == 0) {
                made.ignored.push_back({other, body});
            }
        }
    }
    for (int step = 0; step < 4; ++step) {
        PosesOfStep poses = first;
        for (std::size_t body = 0; body < bodies; ++body) {
            if (!made.is_fixed[body]) {
                poses[body] =
                    random() % 5 == 0 ? std::nullopt : std::optional(make_pose(random, 2.0));
            }
        }
        made.steps.push_back(std::move(poses));
    }
    return made;
}

std::unique_ptr<ScenePoses> open(const RandomScene& scene) {
    auto made = ScenePoses::create(scene.scene(), std::make_unique<ListedSteps>(scene.steps));
    EXPECT_TRUE(made);
    return std::move(made.value());
}

/// What becomes of a pair at a step.
enum class Fate : std::uint8_t { Tested, Apart, Ignored, Fixed, Absent };

Fate fate_of(const RandomScene& scene, std::uint64_t step, BodyPair pair) {
    const PosesOfStep& poses = scene.steps[step];
    if (!poses[pair.a] || !poses[pair.b]) {
        return Fate::Absent;
    }
    if (scene.is_ignored(pair)) {
        return Fate::Ignored;
    }
    if (step > 0 && scene.is_fixed[pair.a] && scene.is_fixed[pair.b]) {
        return Fate::Fixed;
    }
    const auto box = [&](std::uint32_t body) {
        return world_box(
            bounding_box(scene.meshes[body].vertices()), *poses[body], scene.reach / 2);
    };
    return overlap(box(pair.a), box(pair.b)) ? Fate::Tested : Fate::Apart;
}

std::vector<BodyPair> all_pairs(std::size_t bodies) {
    std::vector<BodyPair> pairs;
    for (std::uint32_t a = 0; a < bodies; ++a) {
        for (std::uint32_t b = a + 1; b < bodies; ++b) {
            pairs.push_back({a, b});
        }
    }
    return pairs;
}

/// The scenarios of a scene by brute force, and the coverage of its steps.
struct Expected {
    std::vector<Scenario> scenarios;
    std::vector<std::uint64_t> steps; ///< The step of each scenario.
    std::vector<StepCoverage> coverage;
};

Expected by_brute_force(const RandomScene& scene) {
    Expected expected;
    for (std::uint64_t step = 0; step < scene.steps.size(); ++step) {
        std::map<Fate, std::uint64_t> fates;
        for (const BodyPair& pair : all_pairs(scene.meshes.size())) {
            const Fate fate = fate_of(scene, step, pair);
            ++fates[fate];
            if (fate == Fate::Tested) {
                expected.steps.push_back(step);
                expected.scenarios.push_back(
                    {expected.scenarios.size(),
                     pair.a,
                     pair.b,
                     {*scene.steps[step][pair.a], *scene.steps[step][pair.b]},
                     step});
            }
        }
        expected.coverage.push_back({fates[Fate::Tested],
                                     fates[Fate::Apart],
                                     fates[Fate::Ignored],
                                     fates[Fate::Fixed],
                                     fates[Fate::Absent]});
    }
    return expected;
}

} // namespace

TEST(ScenePoses, AreThoseOfAllPairsByBruteForce) {
    StepCoverage all;
    for (SeededRandom random : seeds(raised(60))) {
        const RandomScene scene = random_scene(random, random() % 2 == 0 ? 0 : 0.3);
        const Expected expected = by_brute_force(scene);
        const auto poses = open(scene);
        ASSERT_EQ(poses->count(), expected.scenarios.size());
        const auto read = poses->read(0, poses->count());
        ASSERT_TRUE(read);
        EXPECT_EQ(read.value(), expected.scenarios);
        for (std::uint64_t i = 0; i < poses->count(); ++i) {
            EXPECT_EQ(poses->steps()->step_of(i), expected.steps[i]);
        }
        ASSERT_EQ(poses->steps()->coverage().size(), expected.coverage.size());
        for (std::size_t step = 0; step < expected.coverage.size(); ++step) {
            EXPECT_EQ(poses->steps()->coverage()[step], expected.coverage[step]) << step;
            all += expected.coverage[step];
        }
    }
    // Each fate was met; otherwise agreement would mean little.
    for (const std::uint64_t count : {all.tested, all.apart, all.ignored, all.fixed, all.absent}) {
        EXPECT_GT(count, 50u);
    }
}

TEST(ScenePoses, HaveEachPairInContact) {
    std::uint64_t contacts = 0;
    for (SeededRandom random : seeds(raised(40))) {
        const RandomScene scene = random_scene(random, 0);
        const auto poses = open(scene);
        const auto scenarios = poses->read(0, poses->count());
        ASSERT_TRUE(scenarios);
        for (std::uint64_t step = 0; step < scene.steps.size(); ++step) {
            for (const BodyPair& pair : all_pairs(scene.meshes.size())) {
                const Fate fate = fate_of(scene, step, pair);
                if (fate != Fate::Tested && fate != Fate::Apart) {
                    continue;
                }
                const PosePair posed{*scene.steps[step][pair.a], *scene.steps[step][pair.b]};
                if (contact_pairs_brute_force(scene.meshes[pair.a], scene.meshes[pair.b], posed)
                        .empty()) {
                    continue;
                }
                ++contacts;
                EXPECT_TRUE(std::ranges::any_of(scenarios.value(), [&](const Scenario& scenario) {
                    return poses->steps()->step_of(scenario.index) == step &&
                           scenario.body_a == pair.a && scenario.body_b == pair.b;
                }));
            }
        }
    }
    EXPECT_GT(contacts, 50u);
}

TEST(ScenePoses, AreReadInAnyOrderAndInParts) {
    for (SeededRandom random : seeds(20)) {
        const auto poses = open(random_scene(random, 0.5));
        const auto all = poses->read(0, poses->count());
        ASSERT_TRUE(all);
        for (int round = 0; round < 20; ++round) {
            const std::uint64_t first = random() % (poses->count() + 1);
            const std::uint64_t count = random() % (poses->count() - first + 1);
            const auto part = poses->read(first, count);
            ASSERT_TRUE(part);
            const auto begin = all.value().begin() + static_cast<std::ptrdiff_t>(first);
            EXPECT_EQ(part.value(),
                      std::vector<Scenario>(begin, begin + static_cast<std::ptrdiff_t>(count)));
        }
    }
}

TEST(ScenePoses, TestFixedBodiesAtTheFirstStepAlone) {
    const Mesh box = make_box(Vec3(1, 1, 1));
    RandomScene scene{{box, box, box}, {true, true, false}, {}, {}, 0};
    const std::optional<Pose> here(Pose{});
    scene.steps = {{here, here, here}, {here, here, here}};
    const auto poses = open(scene);
    EXPECT_EQ(poses->steps()->coverage()[0], (StepCoverage{3, 0, 0, 0, 0}));
    EXPECT_EQ(poses->steps()->coverage()[1], (StepCoverage{2, 0, 0, 1, 0}));
    EXPECT_EQ(poses->count(), 5u);
}

TEST(ScenePoses, CountTheStepsAtWhichABodyIsAbsent) {
    const Mesh box = make_box(Vec3(1, 1, 1));
    RandomScene scene{{box, box}, {true, false}, {}, {}, 0};
    const std::optional<Pose> here(Pose{});
    scene.steps = {{here, std::nullopt}, {here, here}, {here, std::nullopt}};
    const auto poses = open(scene);
    EXPECT_EQ(poses->absences()[0], 0u);
    EXPECT_EQ(poses->absences()[1], 2u);
    EXPECT_EQ(poses->count(), 1u);
    EXPECT_EQ(poses->steps()->step_of(0), 1u);
}

TEST(ScenePoses, ReachFindsBoxesThatAreJustSoFarApart) {
    const Mesh box = make_box(Vec3(1, 1, 1));
    const auto tested_at = [&](double reach, double gap) {
        RandomScene scene{{box, box}, {true, true}, {}, {}, reach};
        scene.steps = {{Pose{}, translation_pose(1 + gap, 0, 0)}};
        return open(scene)->count();
    };
    EXPECT_EQ(tested_at(0.25, 0.25), 1u);
    EXPECT_EQ(tested_at(0.25, 0.2500005), 0u);
    EXPECT_EQ(tested_at(0, 0), 1u);
}

TEST(ScenePoses, StopWhenAsked) {
    const Mesh box = make_box(Vec3(1, 1, 1));
    const RandomScene scene{{box}, {true}, {{Pose{}}}, {}, 0};
    const auto made = ScenePoses::create(
        scene.scene(), std::make_unique<ListedSteps>(scene.steps), [] { return true; });
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::Interrupted);
}

} // namespace cd::tests
