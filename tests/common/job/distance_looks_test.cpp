// Proves that two looks give the record of the whole bodies, that the second look loses no pair
// that ties, and that it spares pairs of roots.

#include "common/job/distance_looks.hpp"

#include "common/job/query_roots.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/common/job/in_parts.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

/// Two bodies whose trees are cut.
class CutPair {
  public:
    CutPair(const ObbTree& a, const ObbTree& b, std::array<std::uint32_t, 2> depths)
        : a_(a),
          b_(b),
          top_a_(cut_tree(a, depths[0])),
          top_b_(cut_tree(b, depths[1])),
          parts_a_(decoded_parts(a, depths[0], SubtreeForm::Binary)),
          parts_b_(decoded_parts(b, depths[1], SubtreeForm::Binary)) {}

    [[nodiscard]] std::vector<RootPair> pairs(const Scenario& scenario, const Query& query) const {
        return query_roots(top_a_, top_b_, scenario, query).value().pairs;
    }
    [[nodiscard]] std::vector<RootPair> first(const Scenario& scenario,
                                              const std::vector<RootPair>& pairs) const {
        return first_look(top_a_, top_b_, scenario.poses, pairs);
    }
    [[nodiscard]] std::vector<RootPair> second(const Scenario& scenario,
                                               const std::vector<RootPair>& pairs,
                                               const ScenarioResult& found) const {
        const auto distance = found.nearest ? std::optional(found.nearest->distance) : std::nullopt;
        return second_look(top_a_, top_b_, scenario.poses, pairs, distance);
    }
    [[nodiscard]] ScenarioResult
    run(const std::vector<RootPair>& roots, const Scenario& scenario, const Query& query) const {
        std::vector<SubtreePair> parts;
        for (const RootPair& pair : roots) {
            parts.push_back({parts_a_[pair.a].view(), parts_b_[pair.b].view()});
        }
        return run_on_subtrees(parts, scenario, query).result;
    }
    [[nodiscard]] ScenarioResult run_whole(const Scenario& scenario, const Query& query) const {
        const SubtreePair whole{a_.view(), b_.view()};
        return run_on_subtrees({&whole, 1}, scenario, query).result;
    }

  private:
    const ObbTree& a_;
    const ObbTree& b_;
    TreeTop top_a_;
    TreeTop top_b_;
    std::vector<Subtree> parts_a_;
    std::vector<Subtree> parts_b_;
};

bool contains(const std::vector<RootPair>& pairs, const RootPair& pair) {
    return std::ranges::find(pairs, pair) != pairs.end();
}

Query to_look(std::optional<double> up_to = std::nullopt) {
    Query query = query_of(Level::Any);
    query.question = Question::Distance;
    query.up_to = up_to;
    return query;
}

} // namespace

TEST(DistanceLooks, TwoLooksHaveTheRecordOfTheWhole) {
    std::mt19937_64 soups(3);
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_sphere(3)));
    trees.push_back(make_tree(make_gridded_box(Vec3(1.5, 1, 1), 6)));
    trees.push_back(make_tree(make_torus(1, 0.3, 30, 15)));
    trees.push_back(make_tree(make_triangle_soup(soups, 80)));
    trees.push_back(make_tree(make_degenerate_soup(soups, 60)));
    std::size_t named = 0;
    std::size_t needed = 0;
    std::size_t contacts = 0;
    std::size_t looked = 0;
    for (SeededRandom random : seeds(150)) {
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const CutPair cut(a,
                          b,
                          {static_cast<std::uint32_t>(2 + random() % 7),
                           static_cast<std::uint32_t>(2 + random() % 7)});
        const Pose pose_a = make_pose(random, 0.2);
        const Scenario scenario = make_scenario(
            {pose_a, random() % 2 == 0 ? make_pose(random, 3) : make_matrix_pose(random, 3)}, 3);
        Query query = random() % 4 == 0 ? to_look(0.5) : to_look();
        if (random() % 4 == 0) {
            query.ignored = {{0, 40, 0, 40}};
        }
        const std::vector<RootPair> pairs = cut.pairs(scenario, query);
        if (!looks_twice(query, pairs)) {
            EXPECT_LE(pairs.size(), 4u);
            continue;
        }
        ++looked;
        const std::vector<RootPair> first = cut.first(scenario, pairs);
        ASSERT_EQ(first.size(), 4u);
        EXPECT_TRUE(std::ranges::all_of(first, [&](RootPair one) { return contains(pairs, one); }));
        const Bytes record = encode_result(cut.run_whole(scenario, query));
        const ScenarioResult found = cut.run(first, scenario, query);
        if (found.kind == ScenarioClass::Contact) {
            ++contacts;
            EXPECT_EQ(encode_result(found), record);
            continue;
        }
        const std::vector<RootPair> second = cut.second(scenario, pairs, found);
        ASSERT_EQ(encode_result(cut.run(second, scenario, query)), record);
        named += pairs.size();
        needed += second.size();
    }
    EXPECT_GT(looked, 100u);
    EXPECT_GT(contacts, 5u);
    EXPECT_LT(needed, named / 2);
}

TEST(DistanceLooks, PairsThatTieAreKept) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 8));
    const CutPair cut(box, box, {6, 6});
    const Scenario scenario = make_scenario({Pose{}, translation_pose(2.5, 0, 0)});
    const Query query = to_look();
    const std::vector<RootPair> pairs = cut.pairs(scenario, query);
    const ScenarioResult found = cut.run(cut.first(scenario, pairs), scenario, query);
    const ScenarioResult whole = cut.run_whole(scenario, query);
    ASSERT_TRUE(found.nearest && whole.nearest);
    ASSERT_EQ(found.nearest->distance, 1.5);
    ASSERT_NE(found.nearest, whole.nearest) << "the first look has the first of all that tie";
    const std::vector<RootPair> second = cut.second(scenario, pairs, found);
    std::size_t ties = 0;
    for (const RootPair& pair : pairs) {
        const ScenarioResult one = cut.run({pair}, scenario, query);
        ASSERT_TRUE(one.nearest);
        const bool is_tie = one.nearest->distance == 1.5;
        ties += is_tie ? 1 : 0;
        EXPECT_TRUE(!is_tie || contains(second, pair)) << pair.a << " " << pair.b;
    }
    EXPECT_GT(ties, 10u);
    EXPECT_LT(second.size(), pairs.size());
    EXPECT_EQ(encode_result(cut.run(second, scenario, query)), encode_result(whole));
}

TEST(DistanceLooks, IgnoredTrianglesNoLongerNameAllRoots) {
    const ObbTree sphere = make_tree(make_sphere(4));
    const CutPair cut(sphere, sphere, {6, 6});
    const Scenario scenario = make_scenario({Pose{}, translation_pose(5, 0, 0)});
    Query query = to_look();
    query.ignored = {{0, 100, 0, 100}};
    const std::vector<RootPair> pairs = cut.pairs(scenario, query);
    EXPECT_EQ(pairs.size(), 64u * 64u);
    const ScenarioResult found = cut.run(cut.first(scenario, pairs), scenario, query);
    const std::vector<RootPair> second = cut.second(scenario, pairs, found);
    EXPECT_LT(second.size(), pairs.size() / 10);
    EXPECT_EQ(encode_result(cut.run(second, scenario, query)),
              encode_result(cut.run_whole(scenario, query)));
    EXPECT_EQ(cut.second(scenario, pairs, {}), pairs) << "nothing was found";
}

} // namespace cd::tests
