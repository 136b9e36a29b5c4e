// Proves that of the rules that name a pair of triangles the last decides, against a loop over all
// rules and all pairs; that a rule which names nothing is refused by its line; and the questions on
// which users of other collision checkers stumble.
#include "client/scene/body_rules.hpp"

#include "client/scene/rule_pattern.hpp"
#include "tests/client/scene/scene_of.hpp"
#include "tests/support/rounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Bodies robot.0 to robot.2 with two arms and a link of no part, a car with wheels, and the
/// ground.
SceneBodies workshop() {
    SceneSpec spec;
    spec.bodies = {
        body_entry("robot", "moving"), body_entry("car", "moving"), body_entry("ground")};
    spec.bodies[0].count = 3;
    const auto made =
        expand_bodies(spec,
                      std::vector{mesh_of_parts({{"arm_1", 1}, {"", 1}, {"arm_2", 2}}),
                                  mesh_of_parts({{"wheel_1", 1}, {"wheel_2", 1}, {"hull", 1}}),
                                  mesh_of_parts({{"", 2}})},
                      "job.toml");
    return made.value();
}

std::string part_of(const Mesh& mesh, std::uint32_t triangle) {
    for (const Part& part : mesh.parts()) {
        if (part.triangles_begin <= triangle && triangle < part.triangles_end) {
            return part.name;
        }
    }
    return "";
}

/// What a pattern names, said again in words of its own.
struct Meaning {
    const char* pattern;
    bool (*names)(const std::string& body, const std::string& group, const std::string& part);
};

const std::vector<Meaning>& meanings() {
    using Text = const std::string&;
    static const std::vector<Meaning> all{
        {"*", [](Text, Text, Text) { return true; }},
        {"robot.*", [](Text body, Text, Text) { return body.starts_with("robot."); }},
        {"robot.1", [](Text body, Text, Text) { return body == "robot.1"; }},
        {"ground", [](Text body, Text, Text) { return body == "ground"; }},
        {"group:moving", [](Text, Text group, Text) { return group == "moving"; }},
        {"car/wheel_*",
         [](Text body, Text, Text part) { return body == "car" && part.starts_with("wheel_"); }},
        {"*/arm_2", [](Text, Text, Text part) { return part == "arm_2"; }},
        {"group:mov*/*_1",
         [](Text, Text group, Text part) { return group == "moving" && part.ends_with("_1"); }},
        {"robot.[02]/arm_?", [](Text body, Text, Text part) {
             return (body == "robot.0" || body == "robot.2") && part.starts_with("arm_");
         }}};
    return all;
}

SceneRule make_rule(bool ignores, const std::string& one, const std::string& other) {
    return {ignores, one, other, 7};
}

bool is_named(const Meaning& meaning,
              const NamedBody& body,
              const Mesh& mesh,
              std::uint32_t triangle) {
    return meaning.names(body.name, body.group, part_of(mesh, triangle));
}

/// Whether the rules ignore a pair of triangles, by the definition.
bool is_ignored_by(const std::vector<std::pair<bool, std::array<const Meaning*, 2>>>& rules,
                   const SceneBodies& scene,
                   BodyPair pair,
                   std::uint32_t a,
                   std::uint32_t b) {
    const NamedBody& body_a = scene.bodies[pair.a];
    const NamedBody& body_b = scene.bodies[pair.b];
    bool ignored = false;
    for (const auto& [ignores, sides] : rules) {
        for (const std::size_t first : {0, 1}) {
            if (is_named(*sides.at(first), body_a, scene.mesh_of(body_a), a) &&
                is_named(*sides.at(1 - first), body_b, scene.mesh_of(body_b), b)) {
                ignored = ignores;
            }
        }
    }
    return ignored;
}

BodyRules applied(const SceneBodies& scene, const std::vector<SceneRule>& order) {
    const auto rules = apply_rules({order}, scene, "job.toml");
    EXPECT_TRUE(rules) << rules.error().detail;
    return rules ? rules.value() : BodyRules{PairSet(scene.bodies.size()), {}, {}};
}

std::string problem_of(const SceneRule& rule) {
    const auto rules = apply_rules({{rule}}, workshop(), "job.toml");
    return rules ? "none" : rules.error().detail;
}

bool ignores(const BodyRules& rules, BodyPair pair, std::uint32_t a, std::uint32_t b) {
    return rules.ignored.has(pair) ||
           std::ranges::any_of(rules.ranges, [&](const IgnoredRange& range) {
               return range.body_a == pair.a && range.body_b == pair.b &&
                      is_ignored({&range, 1}, a, b);
           });
}

} // namespace

TEST(BodyRules, TheLastRuleThatNamesAPairDecides) {
    const SceneBodies scene = workshop();
    std::uint64_t ignored = 0;
    std::uint64_t all = 0;
    for (SeededRandom random : seeds(raised(300))) {
        std::vector<SceneRule> order;
        std::vector<std::pair<bool, std::array<const Meaning*, 2>>> expected;
        const std::uint64_t rules = 1 + random() % 6;
        for (std::uint64_t i = 0; i < rules; ++i) {
            const Meaning& one = meanings()[random() % meanings().size()];
            const Meaning& other = meanings()[random() % meanings().size()];
            const bool is_ignore = random() % 2 == 0;
            const SceneRule rule = make_rule(is_ignore, one.pattern, other.pattern);
            if (apply_rules({{rule}}, scene, "job.toml")) {
                order.push_back(rule);
                expected.push_back({is_ignore, {&one, &other}});
            }
        }
        const BodyRules made = applied(scene, order);
        for (std::uint32_t a = 0; a < scene.bodies.size(); ++a) {
            for (std::uint32_t b = a + 1; b < scene.bodies.size(); ++b) {
                for (std::uint32_t i = 0; i < scene.mesh_of(scene.bodies[a]).triangles().size();
                     ++i) {
                    for (std::uint32_t j = 0; j < scene.mesh_of(scene.bodies[b]).triangles().size();
                         ++j) {
                        const bool is = is_ignored_by(expected, scene, {a, b}, i, j);
                        ASSERT_EQ(ignores(made, {a, b}, i, j), is) << a << " " << b;
                        ignored += is ? 1 : 0;
                        ++all;
                    }
                }
            }
        }
    }
    // Both outcomes were exercised; otherwise agreement would mean little.
    EXPECT_GT(ignored, all / 10);
    EXPECT_LT(ignored, all * 9 / 10);
}

TEST(BodyRules, APairNamedAgainIsTestedThoughAllWereIgnored) {
    const SceneBodies scene = workshop();
    const BodyRules rules = applied(
        scene, {make_rule(true, "robot.*", "robot.*"), make_rule(false, "robot.0", "robot.2")});
    EXPECT_EQ(rules.ignored.count(), 2u);
    EXPECT_TRUE(rules.ignored.has({0, 1}));
    EXPECT_TRUE(rules.ignored.has({1, 2}));
    EXPECT_FALSE(rules.ignored.has({0, 2}));
    EXPECT_TRUE(rules.ranges.empty());
}

TEST(BodyRules, ARuleThatComesLaterWinsWhateverItNames) {
    const SceneBodies scene = workshop();
    const BodyRules rules =
        applied(scene, {make_rule(false, "robot.0", "ground"), make_rule(true, "*", "*")});
    EXPECT_EQ(rules.ignored.count(), 10u);
    const BodyRules parts =
        applied(scene, {make_rule(true, "car/hull", "ground"), make_rule(false, "car", "ground")});
    EXPECT_EQ(parts.ignored.count(), 0u);
    EXPECT_TRUE(parts.ranges.empty());
}

TEST(BodyRules, WheelsMayStandOnTheGround) {
    const SceneBodies scene = workshop();
    const BodyRules rules = applied(scene, {make_rule(true, "car*/wheel_*", "ground")});
    EXPECT_EQ(rules.ignored.count(), 0u);
    EXPECT_EQ(rules.ranges, (IgnoredAreas{{0, 2, 0, 2, 3, 4}}));
}

TEST(BodyRules, PartsOfAllTrianglesAreTheWholeBodies) {
    const SceneBodies scene = workshop();
    const BodyRules rules = applied(scene, {make_rule(true, "car/*", "ground")});
    EXPECT_TRUE(rules.ignored.has({3, 4}));
    EXPECT_TRUE(rules.ranges.empty());
}

TEST(BodyRules, OnlyPartsOfAnIgnoredPairMayBeTested) {
    const SceneBodies scene = workshop();
    const BodyRules rules =
        applied(scene, {make_rule(true, "*", "*"), make_rule(false, "car/hull", "ground")});
    EXPECT_EQ(rules.ignored.count(), 9u);
    EXPECT_EQ(rules.ranges, (IgnoredAreas{{0, 2, 0, 2, 3, 4}}));
}

TEST(BodyRules, EffectsCountPairsOfBodies) {
    const SceneBodies scene = workshop();
    const BodyRules rules = applied(scene,
                                    {make_rule(true, "robot.*", "*"),
                                     make_rule(true, "car/wheel_*", "group:moving"),
                                     make_rule(false, "car", "robot.1")});
    ASSERT_EQ(rules.effects.size(), 3u);
    EXPECT_EQ(rules.effects[0].named, 9u);
    EXPECT_EQ(rules.effects[0].decided, 8u) << "all but car and robot.1";
    EXPECT_EQ(rules.effects[1].named, 3u);
    EXPECT_EQ(rules.effects[1].decided, 2u);
    EXPECT_EQ(rules.effects[2].named, 1u);
    EXPECT_EQ(rules.effects[2].decided, 1u);
}

TEST(BodyRules, ARuleThatNamesNothingIsRefusedByItsLine) {
    EXPECT_EQ(problem_of(make_rule(true, "robots.*", "ground")),
              "job.toml:7: [rules] { ignore = [\"robots.*\", \"ground\"] }: \"robots.*\" names no "
              "body; did you mean \"robot.0\"?");
    EXPECT_THAT(
        problem_of(make_rule(false, "group:movin", "ground")),
        AllOf(HasSubstr("\"group:movin\" names no group"), HasSubstr("did you mean \"moving\"?")));
    EXPECT_THAT(
        problem_of(make_rule(true, "car/whell_1", "ground")),
        AllOf(HasSubstr("names no part of these bodies"), HasSubstr("did you mean \"wheel_1\"?")));
    EXPECT_THAT(problem_of(make_rule(true, "ground/top", "car")),
                HasSubstr("names a part, but the meshes of these bodies have none"));
    EXPECT_THAT(problem_of(make_rule(true, "car", "car")),
                HasSubstr("both names are those of the body \"car\" alone"));
    EXPECT_THAT(problem_of(make_rule(true, "car/wheel_1", "car/wheel_2")),
                HasSubstr("no body is tested against itself"));
}

TEST(BodyRules, TooManyPairsWithPartsAreRefused) {
    SceneSpec spec;
    spec.bodies = {body_entry("car")};
    spec.bodies[0].count = 400;
    const auto scene =
        expand_bodies(spec, std::vector{mesh_of_parts({{"wheel", 1}, {"hull", 1}})}, "j");
    ASSERT_TRUE(scene);
    const auto rules =
        apply_rules({{make_rule(true, "*/wheel", "*/wheel")}}, scene.value(), "job.toml");
    ASSERT_FALSE(rules);
    EXPECT_THAT(rules.error().detail,
                AllOf(HasSubstr("job.toml:7: [rules] { ignore = [\"*/wheel\", \"*/wheel\"] }"),
                      HasSubstr("more than 65 536 pairs of parts have rules")));
    EXPECT_TRUE(apply_rules({{make_rule(true, "*", "*")}}, scene.value(), "job.toml"));
}

TEST(RulePattern, ABackslashMakesACharacterOrdinary) {
    SceneSpec spec;
    spec.bodies = {body_entry("a/b"), body_entry("a*")};
    const auto mesh = mesh_of_parts({{"x", 1}});
    const auto scene = expand_bodies(spec, std::vector{mesh, mesh}, "j");
    ASSERT_TRUE(scene);
    const auto named = [&](const char* text) {
        return RulePattern::from_text(text).bodies_of(scene.value()).value();
    };
    EXPECT_EQ(named("a\\/b"), std::vector<std::uint32_t>{0});
    EXPECT_EQ(named("a\\*"), std::vector<std::uint32_t>{1});
    EXPECT_EQ(named("a*"), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(named("a\\/b/x"), std::vector<std::uint32_t>{0});
}

} // namespace cd::tests
