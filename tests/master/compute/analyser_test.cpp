// Proves that the pre-analysis loses nothing: the contacts of its root pairs and the results it
// finishes itself are those of the whole trees; that results come in order and only as many as
// requested; and that one bad scenario fails alone.

#include "master/compute/analyser.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/distance_looks.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/packed_poses.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <set>

namespace cd::tests {
namespace {

/// Collects blocks and lets a test wait for them.
class Collected {
  public:
    std::function<void(AnalysedBlock)> taker() {
        return [this](AnalysedBlock block) {
            const std::lock_guard lock(mutex_);
            blocks_.push_back(std::move(block));
            changed_.notify_all();
        };
    }
    std::vector<AnalysedBlock> wait_for(std::size_t count) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return blocks_.size() >= count; });
        return blocks_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<AnalysedBlock> blocks_;
};

class AnalyserTest : public testing::Test {
  protected:
    AnalysisInput make_input(const Mesh& a, const Mesh& b, std::uint32_t depth) {
        AnalysisInput input;
        for (const Mesh& mesh : {a, b}) {
            input.trees.push_back(
                std::make_shared<const ObbTree>(build_tree(share(mesh), BuildOptions{}, pool_)));
            input.tops.push_back(
                std::make_shared<const TreeTop>(cut_tree(*input.trees.back(), depth)));
        }
        input.settler =
            std::make_shared<const Settler>(TreesByBody(input.trees), input.query.ignored);
        return input;
    }
    static std::vector<Scenario> make_scenarios(std::uint64_t count, double reach) {
        std::mt19937_64 random(11);
        std::vector<Scenario> scenarios(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            scenarios[i].index = i;
            scenarios[i].poses.a = make_pose(random, 0.5);
            scenarios[i].poses.b = make_pose(random, reach);
        }
        return scenarios;
    }
    ThreadPool pool_{3};
};

Losses two_losses() {
    Losses losses;
    losses.add(70);
    losses.add(71);
    return losses;
}

void start_blocks(Analyser& analyser, std::uint64_t first, std::uint64_t end) {
    for (; first < end; first += limits::analysis_block_scenarios) {
        analyser.start({first, std::min(limits::analysis_block_scenarios, end - first)},
                       two_losses());
    }
}

ScenarioResult finish(const AnalysisInput& input, const Analysis& analysis, std::uint32_t depth) {
    if (analysis.finished) {
        return *analysis.finished;
    }
    const auto nodes_a = cut_nodes(*input.trees[0], depth);
    const auto nodes_b = cut_nodes(*input.trees[1], depth);
    std::vector<Subtree> kept;
    kept.reserve(2 * analysis.pairs.size());
    std::vector<SubtreePair> pairs;
    for (const RootPair& pair : analysis.pairs) {
        kept.push_back(extract_subtree(*input.trees[0], nodes_a[pair.a]));
        kept.push_back(extract_subtree(*input.trees[1], nodes_b[pair.b]));
        pairs.push_back({kept[kept.size() - 2].view(), kept.back().view()});
    }
    ScenarioResult result = run_on_subtrees(pairs, analysis.scenario, input.query).result;
    input.settler->settle(analysis.scenario, result);
    return result;
}

TEST_F(AnalyserTest, AnalysisAndSubtreesTogetherAreTheWholeAnswer) {
    constexpr std::uint32_t depth = 3;
    // The small sphere is inside the large one in some poses and far away in others.
    AnalysisInput input = make_input(join({make_sphere(3), translated(make_sphere(1), {4, 0, 0})}),
                                     make_box({0.2, 0.3, 0.4}),
                                     depth);
    std::array<int, 7> classes{};
    for (const Scenario& scenario : make_scenarios(500, 1.5)) {
        const Analysis analysis = analyse(input, scenario);
        const ScenarioResult result = finish(input, analysis, depth);
        const ScenarioResult expected =
            run_scenario(*input.trees[0], *input.trees[1], scenario, input.query).result;
        ASSERT_EQ(encode_result(result), encode_result(expected)) << scenario.index;
        ASSERT_EQ(analysis.finished.has_value(), analysis.pairs.empty());
        EXPECT_GT(analysis.bytes, 0u);
        ++classes[static_cast<std::size_t>(result.kind)];
    }
    EXPECT_GT(classes[static_cast<std::size_t>(ScenarioClass::Separate)], 10);
    EXPECT_GT(classes[static_cast<std::size_t>(ScenarioClass::Cross)], 10);
    EXPECT_GT(classes[static_cast<std::size_t>(ScenarioClass::Inside)], 10);
}

TEST_F(AnalyserTest, ADistancePlansTheBlocksOfItsFirstLook) {
    AnalysisInput input = make_input(make_sphere(4), make_box({0.2, 0.3, 0.4}), 5);
    input.query.level = Level::Any;
    input.query.question = Question::Distance;
    Scenario scenario;
    scenario.poses.b = translation_pose(3, 0.1, 0.2);
    const Analysis analysis = analyse(input, scenario);
    EXPECT_GT(analysis.pairs.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(analysis.pairs));
    const auto first = first_look(*input.tops[0], *input.tops[1], scenario.poses, analysis.pairs);
    EXPECT_EQ(analysis.roots_a, roots_of_a(first));
    EXPECT_EQ(analysis.roots_b, roots_of_b(first));
    EXPECT_LT(analysis.roots_a.size(), roots_of_a(analysis.pairs).size());
}

TEST_F(AnalyserTest, BlocksComeInOrderAndOnlyThoseAskedFor) {
    AnalysisInput input = make_input(make_sphere(2), make_sphere(2), 2);
    const std::uint64_t count = 10 * limits::analysis_block_scenarios + 17;
    input.poses = ordered(make_scenarios(count, 3.0));
    const auto scenarios = input.poses->read(0, count).value();
    Collected collected;
    Analyser analyser(pool_, input, collected.taker());

    start_blocks(analyser, 0, 4 * limits::analysis_block_scenarios);
    collected.wait_for(4);
    start_blocks(analyser, 4 * limits::analysis_block_scenarios, count);
    const auto blocks = collected.wait_for(11);

    std::uint64_t next = 0;
    for (const AnalysedBlock& block : blocks) {
        EXPECT_FALSE(block.error);
        EXPECT_EQ(block.positions.first, next);
        EXPECT_EQ(block.losses, two_losses());
        for (const Analysis& analysis : block.scenarios) {
            ASSERT_EQ(analysis.scenario, scenarios[next]);
            const Analysis expected = analyse(input, scenarios[next]);
            ASSERT_EQ(analysis.pairs, expected.pairs);
            ASSERT_EQ(analysis.roots_a, expected.roots_a);
            ASSERT_EQ(analysis.roots_b, expected.roots_b);
            ++next;
        }
    }
    EXPECT_EQ(next, count);
}

TEST_F(AnalyserTest, PosesThatCannotBeReadAreToldInOrder) {
    AnalysisInput input = make_input(make_sphere(1), make_sphere(1), 2);
    constexpr std::uint64_t blocks_of = limits::analysis_block_scenarios;
    const std::uint64_t window = limits::order_window_scenarios;
    std::vector<Scenario> scenarios(window + 2 * blocks_of);
    for (std::uint64_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
    }
    const auto poses = std::make_shared<PackedPoses>(scenarios);
    poses->broken_from = window / limits::pose_run_scenarios;
    input.poses = std::make_shared<OrderedPoses>(poses);
    constexpr std::size_t before = 4; ///< Blocks. Reading fails from the third on.
    Collected collected;
    Analyser analyser(pool_, input, collected.taker());
    start_blocks(analyser, window - 2 * blocks_of, window + 2 * blocks_of);
    analyser.start({0, 1});
    const auto blocks = collected.wait_for(before + 1);
    EXPECT_FALSE(blocks[1].error);
    EXPECT_EQ(blocks[1].scenarios.size(), limits::analysis_block_scenarios);
    for (std::size_t block = 2; block < before; ++block) {
        ASSERT_TRUE(blocks[block].error);
        EXPECT_TRUE(blocks[block].scenarios.empty());
    }
    EXPECT_FALSE(blocks.back().error);
    EXPECT_EQ(blocks.back().scenarios.size(), 1u) << "what can be read goes on";
}

TEST_F(AnalyserTest, NothingIsDeliveredAfterTheEnd) {
    AnalysisInput input = make_input(make_sphere(2), make_sphere(2), 2);
    input.poses = ordered(make_scenarios(20 * limits::analysis_block_scenarios, 2.0));
    for (int round = 0; round < 20; ++round) {
        auto alive = std::make_unique<bool>(true);
        auto analyser = std::make_unique<Analyser>(
            pool_, input, [&alive](AnalysedBlock) { EXPECT_TRUE(*alive); });
        start_blocks(*analyser, 0, 20 * limits::analysis_block_scenarios);
        analyser.reset();
        alive.reset();
    }
}

TEST_F(AnalyserTest, SkipsScenariosThatHaveAResultWhenABlockStarts) {
    AnalysisInput input = make_input(make_sphere(1), make_sphere(1), 2);
    input.poses = ordered(make_scenarios(6, 0.1));
    const auto done =
        std::make_shared<const std::vector<bool>>(std::vector<bool>{true, false, true});
    Collected collected;
    Analyser analyser(pool_, input, collected.taker());
    analyser.start({0, 6}, {}, done);
    analyser.start({0, 6}, two_losses(), done);
    analyser.start({0, 6});
    const auto blocks = collected.wait_for(3);
    const auto in_order = input.poses->read(0, 6).value();
    for (std::size_t block = 0; block < 2; ++block) {
        std::set<std::uint64_t> indices;
        for (const Analysis& analysis : blocks[block].scenarios) {
            indices.insert(analysis.scenario.index);
            EXPECT_EQ(analysis.scenario, in_order.at(analysis.position));
        }
        EXPECT_EQ(indices, (std::set<std::uint64_t>{1, 3, 4, 5}));
    }
    EXPECT_EQ(blocks[2].scenarios.size(), 6u);
}

} // namespace
} // namespace cd::tests
