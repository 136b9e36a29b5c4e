// Proves how two runs are compared: scenarios, groups and triangles, also where results are
// missing.
#include "client/compare/group_diff.hpp"

#include "client/compare/diff_report.hpp"
#include "client/compare/scenario_diff.hpp"
#include "client/compare/triangle_diff.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/contact_map.hpp"
#include "tests/client/compare/record_runs.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

/// Makes a mesh of `parts.size()` parts, each a triangle.
std::shared_ptr<const Mesh> mesh_of_parts(const std::vector<std::string>& parts) {
    MeshArrays arrays;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        const double x = 3.0 * i;
        arrays.vertices.insert(arrays.vertices.end(),
                               {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 1, 0)});
        arrays.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        arrays.parts.push_back({parts[i], i, i + 1});
    }
    auto mesh = Mesh::create(std::move(arrays));
    EXPECT_TRUE(mesh) << mesh.error().detail;
    return share(std::move(mesh.value()));
}

/// Two runs of the same scenarios.
class Diff : public testing::Test {
  protected:
    /// Compares two runs of `scenarios` poses.
    void compare(const std::vector<ScenarioResult>& was,
                 const std::vector<ScenarioResult>& is,
                 std::uint64_t scenarios) {
        RecordFile earlier = write_records(folder_ / "earlier", was);
        RecordFile later = write_records(folder_ / "later", is);
        groups_.emplace(GroupDiff({a_, b_}, {a_, later_b_}, kind_));
        scenarios_.emplace(std::nullopt, ScenarioDiffOptions{true, {"a", "b"}});
        const ScenarioMatch match = ScenarioMatch::by_index(scenarios);
        const Status done = for_each_pair(
            {earlier, scenarios}, {later, scenarios}, match, {}, [&](const PairedResult& pair) {
                groups_->add(pair);
                triangles_.add(pair);
                return scenarios_->add(pair);
            });
        EXPECT_TRUE(done) << done.error().detail;
    }

    /// Compares two runs at level count, which have sums by part.
    void compare_counts(std::vector<ScenarioResult> was,
                        std::vector<ScenarioResult> is,
                        std::uint64_t scenarios) {
        kind_ = PartKind::Named;
        const PartContacts earlier = sums_of(was, *b_);
        const PartContacts later = sums_of(is, *later_b_);
        compare(was, is, scenarios);
        EXPECT_TRUE(groups_->add_sums(&earlier, &later));
    }
    /// Sums the listed pairs of results, which then are of level count.
    [[nodiscard]] PartContacts sums_of(std::vector<ScenarioResult>& results, const Mesh& b) const {
        ContactMapSum sum(body_part_runs(*a_, b));
        for (ScenarioResult& result : results) {
            result.level = Level::Count;
            sum.add(result, result.pairs);
            result.pairs.clear();
        }
        return sum.take().parts;
    }

    /// Returns the state of each group, by the names of its parts.
    [[nodiscard]] std::map<std::string, std::string> states() const {
        std::map<std::string, std::string> states;
        for (const ChangedGroup& group : groups_->groups()) {
            states[group.part_a + " x " + group.part_b] = to_text(group.state);
        }
        return states;
    }

    const TemporaryFolder folder_;
    std::shared_ptr<const Mesh> a_ = mesh_of_parts({"hood", "sill"});
    std::shared_ptr<const Mesh> b_ = mesh_of_parts({"post", "lamp", "base"});
    std::shared_ptr<const Mesh> later_b_ = b_;
    PartKind kind_ = PartKind::Any;
    std::optional<GroupDiff> groups_;
    std::optional<ScenarioDiff> scenarios_;
    TriangleDiff triangles_;
};

using States = std::map<std::string, std::string>;

} // namespace

TEST_F(Diff, OfARunWithItselfIsEmpty) {
    const std::vector<ScenarioResult> results{
        result_with(0, {{0, 0}, {1, 2}}), result_with(1, {}), failed(2), result_with(4, {{0, 1}})};
    compare(results, results, 6);
    EXPECT_EQ(scenarios_->counts().in_both, 6u);
    EXPECT_EQ(scenarios_->counts().changed, 0u);
    EXPECT_EQ(scenarios_->counts().comparable, 3u);
    EXPECT_EQ(scenarios_->counts().outcomes.back().back(), 2u) << "without a result";
    for (const ChangedGroup& group : groups_->groups()) {
        EXPECT_EQ(group.state, GroupState::Unchanged);
    }
    EXPECT_EQ(groups_->groups().size(), 3u);
    EXPECT_TRUE(triangles_.changes(0).empty());
    EXPECT_EQ(triangles_.counts(0).in_both, 2u);
}

TEST_F(Diff, RemovingOnePartResolvesExactlyItsGroups) {
    later_b_ = mesh_of_parts({"post", "base"});
    compare({result_with(0, {{0, 0}, {0, 1}, {1, 2}}), result_with(1, {{1, 1}})},
            {result_with(0, {{0, 0}, {1, 1}}), result_with(1, {})},
            2);
    EXPECT_EQ(states(),
              (States{{"hood x post", "unchanged"},
                      {"hood x lamp", "resolved"},
                      {"sill x lamp", "resolved"},
                      {"sill x base", "unchanged"}}));
    EXPECT_EQ(scenarios_->counts().outcomes[1][0], 1u);
    EXPECT_EQ(scenarios_->counts().changed, 2u);
}

TEST_F(Diff, AScenarioThatFailedMakesItsGroupsNotComparable) {
    const std::vector<ScenarioResult> was{result_with(0, {{0, 0}}),
                                          result_with(1, {{0, 0}, {0, 1}}),
                                          result_with(2, {{1, 1}}),
                                          result_with(3, {{1, 2}})};
    for (const bool is_missing : {false, true}) {
        std::vector<ScenarioResult> is{
            result_with(0, {{0, 0}}), failed(1), failed(2), result_with(3, {})};
        if (is_missing) {
            is.erase(is.begin() + 1, is.begin() + 3);
        }
        compare(was, is, 4);
        EXPECT_EQ(states(),
                  (States{{"hood x post", "unchanged"},
                          {"hood x lamp", "not comparable"},
                          {"sill x lamp", "not comparable"},
                          {"sill x base", "resolved"}}));
    }
}

TEST_F(Diff, SumsOfEqualScenariosAreComparedAsListsAre) {
    const std::vector<ScenarioResult> was{result_with(0, {{0, 0}}),
                                          result_with(1, {{0, 1}}),
                                          result_with(2, {{1, 1}, {1, 2}}),
                                          result_with(3, {})};
    const std::vector<ScenarioResult> is{result_with(0, {{0, 0}, {1, 0}}),
                                         result_with(1, {{0, 0}}),
                                         result_with(2, {{1, 2}}),
                                         failed(3)}; // It was in no contact, so it is in no sum.
    compare(was, is, 4);
    const auto of_lists = groups_->groups();
    compare_counts(was, is, 4);
    EXPECT_EQ(groups_->groups(), of_lists);
    EXPECT_TRUE(groups_->are_sums_comparable());
    EXPECT_EQ(states(),
              (States{{"hood x post", "grown"},
                      {"hood x lamp", "resolved"},
                      {"sill x lamp", "resolved"},
                      {"sill x base", "unchanged"},
                      {"sill x post", "new"}}));
}

TEST_F(Diff, SumsThatCoverOtherScenariosAreNotComparable) {
    const std::vector<ScenarioResult> some{result_with(0, {{0, 0}}), result_with(1, {{0, 1}})};
    const std::vector<ScenarioResult> more{result_with(0, {{0, 0}}),
                                           result_with(1, {{1, 1}}),
                                           result_with(2, {{0, 0}}),
                                           result_with(3, {{1, 2}})};
    compare_counts(some, more, 4);
    EXPECT_FALSE(groups_->are_sums_comparable());
    EXPECT_EQ(states(),
              (States{{"hood x post", "not comparable"},
                      {"hood x lamp", "resolved"},
                      {"sill x lamp", "new"},
                      {"sill x base", "new"}}))
        << "all of the earlier scenarios were tested again";
    compare_counts(more, some, 4);
    EXPECT_FALSE(groups_->are_sums_comparable());
    EXPECT_EQ(states(),
              (States{{"hood x post", "not comparable"},
                      {"sill x lamp", "not comparable"},
                      {"sill x base", "not comparable"},
                      {"hood x lamp", "new"}}));
}

TEST_F(Diff, GroupsGrowAndShrinkByScenariosThenByPairs) {
    compare(
        {result_with(0, {{0, 0}}), result_with(1, {{0, 1}}), result_with(2, {{1, 2}}), failed(3)},
        {result_with(0, {{0, 0}}),
         result_with(1, {{0, 0}}),
         result_with(2, {{1, 0}}),
         result_with(3, {{1, 1}})},
        4);
    EXPECT_EQ(states(),
              (States{{"hood x post", "grown"},
                      {"hood x lamp", "resolved"},
                      {"sill x base", "resolved"},
                      {"sill x post", "new"},
                      {"sill x lamp", "new"}}));
    const auto groups = groups_->groups();
    EXPECT_EQ(groups.front().state, GroupState::New);
    const auto grown = std::ranges::find(groups, GroupState::Grown, &ChangedGroup::state);
    EXPECT_EQ(grown->earlier, (GroupCounts{1, 1}));
    EXPECT_EQ(grown->later, (GroupCounts{2, 2}));
}

TEST_F(Diff, TrianglesAgreeWithASlowTwin) {
    std::mt19937_64 random(3);
    std::vector<ScenarioResult> was;
    std::vector<ScenarioResult> is;
    std::map<std::uint32_t, TriangleChange> expected;
    for (std::uint64_t i = 0; i < 200; ++i) {
        for (auto* run : {&was, &is}) {
            std::vector<ContactPair> pairs;
            for (std::uint32_t a = 0; a < 2; ++a) {
                for (std::uint32_t b = 0; b < 3; ++b) {
                    if (random() % 9 == 0) {
                        pairs.push_back({a, b});
                    }
                }
            }
            run->push_back(result_with(i, pairs));
        }
        if (i % 10 == 0) {
            is.pop_back(); // Not compared.
            continue;
        }
        for (std::uint32_t b = 0; b < 3; ++b) {
            const auto has = [b](const ScenarioResult& result) {
                return std::ranges::count(result.pairs, b, &ContactPair::b) != 0 ? 1u : 0u;
            };
            expected[b].triangle = b;
            expected[b].earlier += has(was.back());
            expected[b].later += has(is.back());
        }
    }
    compare(was, is, 200);
    std::vector<TriangleChange> changes;
    for (const auto& [b, change] : expected) {
        if (change.earlier != change.later) {
            changes.push_back(change);
        }
    }
    EXPECT_FALSE(changes.empty());
    EXPECT_EQ(triangles_.changes(1), changes);
}

TEST_F(Diff, RowsTellWhatChangedFirst) {
    RecordFile earlier = write_records(folder_ / "earlier",
                                       {result_with(0, {{0, 0}}),
                                        result_with(1, {{0, 0}}),
                                        result_with(2, {{0, 0}}),
                                        result_with(3, {{0, 0}})});
    RecordFile later = write_records(folder_ / "later",
                                     {result_with(0, {{0, 0, PairClass::Proper}}),
                                      result_with(1, {{0, 0}, {0, 1}}),
                                      result_with(2, {{0, 2}})});
    auto file = OutputFile::create(folder_ / "diff.csv");
    ASSERT_TRUE(file);
    ScenarioDiff diff(std::move(file.value()), {true, {"a, or A", "b"}});
    ASSERT_TRUE(for_each_pair(
        {earlier, 4}, {later, 4}, ScenarioMatch::by_index(4), {}, [&](const PairedResult& pair) {
            return diff.add(pair);
        }));
    ASSERT_TRUE(diff.finish());
    EXPECT_EQ(read_text(folder_ / "diff.csv"),
              "scenario,scenario_old,body_a,body_b,class_old,class,count_old,count,change\n"
              "0,0,\"a, or A\",b,touch,cross,1,1,class\n"
              "1,1,\"a, or A\",b,touch,touch,1,2,count\n"
              "2,2,\"a, or A\",b,touch,touch,1,1,pairs\n"
              "3,3,\"a, or A\",b,touch,none,1,,class\n");
}

TEST_F(Diff, LevelAnyEqualsTheClassesThatItStandsFor) {
    ScenarioResult any;
    any.level = Level::Any;
    any.kind = ScenarioClass::Contact;
    ScenarioResult apart = any;
    apart.index = 1;
    apart.kind = ScenarioClass::Separate;
    compare({any, apart}, {result_with(0, {{0, 0}}), result_with(1, {{0, 0}})}, 2);
    EXPECT_EQ(scenarios_->counts().changed, 1u);
}

TEST_F(Diff, NearPairsAreComparedIfBothRunsHaveAClearance) {
    compare({near_with(0, {{0, 0}}), near_with(1, {{0, 0}}), near_with(2, {})},
            {near_with(0, {{0, 0}, {1, 0}}), near_with(1, {{0, 0}}), near_with(2, {{0, 1}})},
            3);
    EXPECT_EQ(scenarios_->counts().changed, 2u);
    EXPECT_EQ(scenarios_->counts().outcomes[0][7], 1u) << "separate was, near is";
    EXPECT_EQ(outcome_name(7), "near");
    EXPECT_EQ(outcome_name(8), "none");
    EXPECT_EQ(
        states(),
        (States{{"hood x post", "unchanged"}, {"sill x post", "new"}, {"hood x lamp", "new"}}));

    compare({result_with(0, {}), result_with(1, {}), result_with(2, {})},
            {near_with(0, {{0, 0}}), near_with(1, {}), near_with(2, {})},
            3);
    EXPECT_EQ(scenarios_->counts().changed, 0u) << "only one run can tell near from separate";
}

TEST_F(Diff, RowsCountNearPairsOfAClearance) {
    RecordFile earlier = write_records(folder_ / "earlier", {near_with(0, {{0, 0}})});
    RecordFile later = write_records(folder_ / "later", {near_with(0, {{0, 0}, {0, 1}})});
    auto file = OutputFile::create(folder_ / "diff.csv");
    ASSERT_TRUE(file);
    ScenarioDiff diff(std::move(file.value()), {true, {"a", "b"}, true});
    ASSERT_TRUE(for_each_pair(
        {earlier, 1}, {later, 1}, ScenarioMatch::by_index(1), {}, [&](const PairedResult& pair) {
            return diff.add(pair);
        }));
    ASSERT_TRUE(diff.finish());
    EXPECT_EQ(read_text(folder_ / "diff.csv"),
              "scenario,scenario_old,body_a,body_b,class_old,class,count_old,count,near_old,near,"
              "change\n"
              "0,0,a,b,near,near,0,0,1,2,near\n");
}

TEST_F(Diff, DistancesAreComparedByTheirBits) {
    const double next = std::nextafter(0.25, 1);
    RecordFile earlier = write_records(
        folder_ / "earlier", {apart(0, 0.25), apart(1, 0.25), apart(2, 0.25), apart(3, {})});
    RecordFile later = write_records(folder_ / "later",
                                     {apart(0, 0.25), apart(1, next), apart(2, {}), apart(3, {})});
    auto file = OutputFile::create(folder_ / "diff.csv");
    ASSERT_TRUE(file);
    ScenarioDiff diff(std::move(file.value()), {true, {"a", "b"}, false, true});
    ASSERT_TRUE(for_each_pair(
        {earlier, 4}, {later, 4}, ScenarioMatch::by_index(4), {}, [&](const PairedResult& pair) {
            return diff.add(pair);
        }));
    ASSERT_TRUE(diff.finish());
    EXPECT_EQ(diff.counts().changed, 2u);
    EXPECT_EQ(read_text(folder_ / "diff.csv"),
              "scenario,scenario_old,body_a,body_b,class_old,class,count_old,count,distance_old,"
              "distance,change\n"
              "1,1,a,b,separate,separate,,,0.25,0.25000000000000006,distance\n"
              "2,2,a,b,separate,separate,,,0.25,,distance\n");
}

TEST_F(Diff, HitsAreComparedByLineAndDepth) {
    const auto changed = [&](const ScenarioResult& was, const ScenarioResult& is) {
        RecordFile earlier = write_records(folder_ / "earlier", {was});
        RecordFile later = write_records(folder_ / "later", {is});
        ScenarioDiff diff(std::nullopt, {false, {"a", "lines"}});
        const auto add = [&](const PairedResult& pair) { return diff.add(pair); };
        EXPECT_TRUE(for_each_pair({earlier, 1}, {later, 1}, ScenarioMatch::by_index(1), {}, add));
        return diff.counts().changed;
    };
    const ScenarioResult was = hits_at({{3, 0, 0.5}, {5, 1, 0.75}});
    EXPECT_EQ(changed(was, hits_at({{2, 1, 0.75}, {9, 0, 0.5}})), 0u) << "other triangles";
    EXPECT_EQ(changed(was, hits_at({{3, 0, 0.5}, {5, 1, std::nextafter(0.75, 1)}})), 1u);
    EXPECT_EQ(changed(was, hits_at({{3, 0, 0.5}, {5, 2, 0.75}})), 1u) << "another line";
    EXPECT_EQ(changed(was, hits_at({{3, 0, 0.5}})), 1u);
}

TEST_F(Diff, ADistanceIsNotComparedWithAnotherQuestion) {
    compare({result_with(0, {})}, {apart(0, 0.25)}, 1);
    EXPECT_EQ(scenarios_->counts().changed, 0u);
}

TEST_F(Diff, ARecordBeyondTheScenariosIsAnError) {
    RecordFile records = write_records(folder_ / "records", {result_with(5, {})});
    const Status read = for_each_pair(
        {records, 3}, {records, 3}, ScenarioMatch::by_index(3), {}, [](const PairedResult&) {
            return Status(Done{});
        });
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().detail, "the run has a record of scenario 5, but only 3 scenarios");
}

TEST_F(Diff, TheTextShowsTwentyGroupsOfAState) {
    DiffReport report;
    report.inputs.bodies.resize(2);
    report.inputs.bodies[1] = {"B", true, 7, 2, 1};
    report.inputs.are_poses_equal = true;
    report.bodies = {"a", "b"};
    report.has_groups = true;
    report.scenarios.in_both = 1'234;
    report.scenarios.comparable = 1'234;
    report.scenarios.outcomes[0][2] = 17;
    for (int i = 0; i < 23; ++i) {
        ChangedGroup& group = report.groups.emplace_back();
        group.state = GroupState::New;
        group.part_a = "p\x1b" + std::to_string(i);
        group.later = {3, 40};
        group.worst = 9;
    }
    const std::string text = diff_text(report);
    EXPECT_TRUE(text.starts_with(
        "B changed (7 parts, 2 new, 1 gone), poses equal, query equal\n  scenarios     1 234 in "
        "both, matched by index\n"))
        << text;
    EXPECT_THAT(text, HasSubstr("cross\n"));
    EXPECT_THAT(text, HasSubstr("  groups        23 new\n"));
    EXPECT_THAT(text, HasSubstr("19 x : 3 scenarios, 40 pairs, most in #9\n"));
    EXPECT_THAT(text, HasSubstr("    and 3 more; see -o json\n"));
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
    EXPECT_TRUE(report.has_changes());
}

} // namespace cd::tests
