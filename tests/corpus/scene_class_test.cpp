// Proves that each hard scene has the class of the definition, even if two solids penetrate each
// other and no two triangles cross.
#include "common/job/run_scenario.hpp"
#include "tests/corpus/categories.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/scene_oracle.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

class SceneClass : public testing::TestWithParam<std::string> {};

TEST_P(SceneClass, IsThatOfTheDefinition) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const bool closed = scene->a.closed && scene->b.closed;
        const SceneOracle oracle(*scene->a.mesh, *scene->b.mesh, scene->poses);
        const ScenarioClass expected = oracle.scenario_class(closed);
        const ObbTree a = make_tree(*scene->a.mesh);
        const ObbTree b = make_tree(*scene->b.mesh);
        const Scenario scenario = make_scenario(scene->poses);
        for (const Level level : {Level::Count, Level::Pairs, Level::Contacts}) {
            const ScenarioResult result = run_scenario(a, b, scenario, query_of(level)).result;
            EXPECT_EQ(to_text(result.kind), to_text(expected));
            EXPECT_EQ(result.surfaces_only, !closed);
            EXPECT_EQ(result.pair_count, oracle.contact_pairs().size());
        }
        const ScenarioClass at_any =
            oracle.contact_pairs().empty() ? expected : ScenarioClass::Contact;
        const ScenarioResult any = run_scenario(a, b, scenario, query_of(Level::Any)).result;
        EXPECT_EQ(to_text(any.kind), to_text(at_any));
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, SceneClass, testing::ValuesIn(scene_categories()), test_name);

} // namespace cd::tests
