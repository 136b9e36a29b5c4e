// Proves that the rules learned at a step name exactly the pairs of bodies in contact there.
#include "client/scene/learned_rules.hpp"

#include "client/scene/rule_pattern.hpp"
#include "client/spec/job_file.hpp"
#include "tests/client/scene/scene_of.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

ScenarioResult result_of(std::uint64_t index, std::uint32_t b, ScenarioClass kind) {
    ScenarioResult result;
    result.index = index;
    result.body_b = b;
    result.kind = kind;
    return result;
}

} // namespace

TEST(LearnedRules, AreThePairsInContactAtTheirStep) {
    const auto steps = std::make_shared<StepIndex>();
    steps->add_step({1});
    steps->add_step({3});
    LearnedRules rules(steps, 1, {"car", "wall", "g\"ate/*", "post"});
    rules.add(result_of(0, 1, ScenarioClass::Cross));
    EXPECT_EQ(rules.text(), "");
    rules.add(result_of(1, 1, ScenarioClass::Near));
    rules.add(result_of(2, 2, ScenarioClass::Touch));
    rules.add(result_of(3, 3, ScenarioClass::Contact));
    EXPECT_EQ(
        rules.text(),
        "{ ignore = [\"car\", \"g\\\"ate\\\\/\\\\*\"] },\n{ ignore = [\"car\", \"post\"] },\n");
    const auto job =
        parse_job("[bodies]\ncar = { mesh = \"m\" }\n[rules]\norder = [\n" + rules.text() + "]\n",
                  "job.toml");
    ASSERT_TRUE(job) << job.error().detail;
    EXPECT_EQ(job.value().scene->rules.order.size(), 2u);
}

TEST(LearnedRules, APatternNamesOneBody) {
    SceneSpec spec;
    for (const char* name : {"a", "a*", "a?", "a[b]", "a/b", "a\\b", "ab", "axb"}) {
        spec.bodies.push_back(body_entry(name));
    }
    const std::vector meshes(spec.bodies.size(), mesh_of_parts({{"x", 1}}));
    const auto scene = expand_bodies(spec, meshes, "job.toml");
    ASSERT_TRUE(scene);
    for (std::uint32_t body = 0; body < spec.bodies.size(); ++body) {
        const auto named =
            RulePattern::from_text(pattern_of(spec.bodies[body].name)).bodies_of(scene.value());
        ASSERT_TRUE(named) << spec.bodies[body].name;
        EXPECT_EQ(named.value(), std::vector<std::uint32_t>{body}) << spec.bodies[body].name;
    }
}

} // namespace cd::tests
