// Proves that descents receive joined trees once a thread has made them, if the cache leaves room,
// and that a later job with the same body receives them at once.
#include "worker/session/tree_joiner.hpp"

#include "common/core/limits/worker.hpp"
#include "tests/worker/session/parts.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace cd::tests {
namespace {

class TreeJoinerTest : public HubStage {
  protected:
    /// Fills a cache with all blocks of a body.
    static void fill(SubtreeCache& cache) {
        const CutBody& body = bodies().a;
        EXPECT_TRUE(cache.add_tree(body.add(tree_a)));
        EXPECT_TRUE(cache.insert({tree_a, top_root}, open_block(body.top_block).value()));
        for (RootIndex root = 0; root < body.top.root_count(); ++root) {
            EXPECT_TRUE(cache.insert({tree_a, root}, open_block(body.block(root)).value()));
        }
    }
    /// Prepares descents until a step is due, and then one when the step has ended.
    Walk after_descents(TreeJoiner& joiner, SubtreeCache& cache) {
        Walk walk{nullptr,
                  TaskScenarios(std::vector<Scenario>{}),
                  0,
                  0,
                  {{tree_a, cache.snapshot(tree_a)}},
                  nullptr};
        for (std::uint32_t i = 0; i < limits::join_descents_min; ++i) {
            EXPECT_TRUE(walk.joined.empty());
            joiner.prepare(walk);
        }
        bool has_ended = false; // The executor has one thread, so this follows the step.
        hub->run_on_thread([&] { return [&] { has_ended = true; }; });
        run_until([&] { return has_ended; });
        joiner.prepare(walk);
        return walk;
    }
};

TEST_F(TreeJoinerTest, ADescentGetsTheJoinedTree) {
    SubtreeCache cache(std::uint64_t{1} << 40);
    fill(cache);
    TreeJoiner joiner(*hub, cache);
    const Walk walk = after_descents(joiner, cache);
    ASSERT_TRUE(walk.joined.contains(tree_a));
    EXPECT_FALSE(walk.joined.at(tree_a)->view().nodes.empty());

    const TreeId again{9};
    cache.park(tree_a);
    ASSERT_TRUE(cache.add_tree(bodies().a.add(again)));
    Walk later = walk;
    later.trees = {{again, cache.snapshot(again)}};
    later.joined.clear();
    joiner.prepare(later);
    EXPECT_EQ(later.joined.at(again), walk.joined.at(tree_a));
}

TEST_F(TreeJoinerTest, AFullCacheLeavesNoRoom) {
    SubtreeCache unlimited(std::uint64_t{1} << 40);
    fill(unlimited);
    SubtreeCache cache(unlimited.bytes());
    fill(cache);
    TreeJoiner joiner(*hub, cache);
    EXPECT_TRUE(after_descents(joiner, cache).joined.empty());
}

} // namespace
} // namespace cd::tests
