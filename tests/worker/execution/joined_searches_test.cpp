// Proves that descents reuse the search of two joined trees, that the stop of the current run ends
// it, and that searches of released trees are dropped.
#include "worker/execution/joined_searches.hpp"

#include "common/core/limits/worker.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace cd::tests {

namespace {

/// Returns the wide tree of a mesh, which stands for a joined one.
JoinedSearch::Tree joined(Mesh mesh) {
    return std::make_shared<const WideTree>(make_tree(std::move(mesh)).view());
}

Scenario overlapping() {
    return make_scenario({Pose{}, translation_pose(0.5, 0.1, 0)});
}

} // namespace

TEST(JoinedSearches, TheOneGivenBackLastIsUsedAgain) {
    JoinedSearches searches;
    const auto sphere = joined(make_sphere(2));
    const auto torus = joined(make_torus(1, 0.3, 20, 10));
    auto one = searches.take(sphere, torus);
    auto other = searches.take(sphere, torus);
    EXPECT_NE(one, other);
    const JoinedSearch* const last = other.get();
    searches.give_back(std::move(one));
    searches.give_back(std::move(other));
    EXPECT_NE(searches.take(torus, sphere).get(), last);
    EXPECT_EQ(searches.take(sphere, torus).get(), last);
}

TEST(JoinedSearches, ASearchOfATreeThatIsGoneIsDropped) {
    JoinedSearches searches;
    auto sphere = joined(make_sphere(2));
    const auto torus = joined(make_torus(1, 0.3, 20, 10));
    auto search = searches.take(sphere, torus);
    EXPECT_TRUE(search->is_of(sphere, torus));
    sphere = joined(make_sphere(2));
    EXPECT_TRUE(search->has_lost_a_tree());
    EXPECT_FALSE(search->is_of(sphere, torus));
    searches.give_back(std::move(search));
    EXPECT_FALSE(searches.take(sphere, torus)->has_lost_a_tree());
}

TEST(JoinedSearches, TheStopIsThatOfTheRun) {
    const auto sphere = joined(make_sphere(3));
    JoinedSearch search(sphere, sphere);
    const Query query = query_of(Level::Pairs);
    {
        const bool is_over = false;
        RunOptions options;
        options.stop = [&is_over] { return is_over; };
        const ScenarioRun run = search.run(overlapping(), query, options);
        EXPECT_FALSE(run.is_stopped);
        EXPECT_GT(run.result.pair_count, 0u);
    }
    EXPECT_FALSE(search.run(overlapping(), query, {}).is_stopped);
    RunOptions stopped;
    stopped.stop = [] { return true; };
    EXPECT_TRUE(search.run(overlapping(), query, stopped).is_stopped);
    EXPECT_FALSE(search.run(overlapping(), query, {}).is_stopped);
}

} // namespace cd::tests
