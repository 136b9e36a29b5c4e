// Proves that each hard scene has the class of the definition, even if two solids penetrate each
// other and no two triangles cross.
#include "common/core/host/thread_pool.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "tests/corpus/categories.hpp"
#include "tests/support/scene_oracle.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

class SceneClass : public testing::TestWithParam<std::string> {};

TEST_P(SceneClass, IsThatOfTheDefinition) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const bool closed = scene->a.closed && scene->b.closed;
        const SceneOracle oracle(*scene->a.mesh, *scene->b.mesh, scene->poses);
        const ScenarioClass expected = oracle.scenario_class(closed);
        ThreadPool pool(1);
        const ObbTree a = build_tree(scene->a.mesh, {}, pool);
        const ObbTree b = build_tree(scene->b.mesh, {}, pool);
        Scenario scenario;
        scenario.poses = scene->poses;
        for (const Level level : {Level::Count, Level::Pairs, Level::Contacts}) {
            Query query;
            query.level = level;
            const ScenarioResult result = run_scenario(a, b, scenario, query).result;
            EXPECT_EQ(to_text(result.kind), to_text(expected));
            EXPECT_EQ(result.surfaces_only, !closed);
            EXPECT_EQ(result.pair_count, oracle.contact_pairs().size());
        }
        Query any;
        any.level = Level::Any;
        const ScenarioClass at_any =
            oracle.contact_pairs().empty() ? expected : ScenarioClass::Contact;
        EXPECT_EQ(to_text(run_scenario(a, b, scenario, any).result.kind), to_text(at_any));
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, SceneClass, testing::ValuesIn(scene_categories()), test_name);

} // namespace cd::tests
