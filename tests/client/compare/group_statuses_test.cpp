// Proves the statuses of groups: computed against a baseline, said by people, and fallen back.
#include "client/compare/group_statuses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> bodies{"van", "b"};

Group group_of(const std::string& a, const std::string& b, std::uint64_t worst_pairs = 10) {
    Group group;
    group.part_a = a;
    group.part_b = b;
    group.scenarios = 1;
    group.worst_pairs = worst_pairs;
    group.episodes = {1, 0, {{0, 0}}};
    return group;
}

StatusRule rule_of(const std::string& a,
                   const std::string& b,
                   bool is_approved,
                   std::optional<std::uint64_t> pairs_max = std::nullopt) {
    return {PartPattern::from_text(a),
            PartPattern::from_text(b),
            is_approved,
            "wanted",
            pairs_max,
            "s.toml:1: clash"};
}

Baseline baseline_of(std::vector<Group> groups, bool is_resolved = true) {
    return {std::move(groups), [is_resolved](const Group&) { return is_resolved; }};
}

std::vector<GroupStatus> statuses_of(const GroupStatuses& judged) {
    std::vector<GroupStatus> statuses;
    for (const JudgedGroup& group : judged.groups()) {
        statuses.push_back(group.status);
    }
    return statuses;
}

} // namespace

TEST(GroupStatuses, AreComputedAgainstTheBaseline) {
    const Baseline baseline = baseline_of({group_of("door", "post"), group_of("roof", "post")});
    const GroupStatuses judged(
        {group_of("door", "post"), group_of("sill", "post")}, &baseline, {}, bodies);
    EXPECT_THAT(statuses_of(judged),
                ElementsAre(GroupStatus::Active, GroupStatus::New, GroupStatus::Resolved));
    EXPECT_EQ(judged.groups()[2].group.part_a, "roof");
    EXPECT_TRUE(judged.has_news());
    const Baseline untested = baseline_of({group_of("roof", "post")}, false);
    EXPECT_THAT(statuses_of(GroupStatuses({}, &untested, {}, bodies)),
                ElementsAre(GroupStatus::NotComparable));
}

TEST(GroupStatuses, TheSameRunHasNoNews) {
    const std::vector<Group> groups{group_of("door", "post"), group_of("post", "door")};
    const Baseline baseline = baseline_of(groups);
    const GroupStatuses judged(groups, &baseline, {}, bodies);
    EXPECT_THAT(statuses_of(judged), ElementsAre(GroupStatus::Active, GroupStatus::Active));
    EXPECT_FALSE(judged.has_news());
}

TEST(GroupStatuses, ANewGroupIsNoNewsOnlyIfApproved) {
    const Baseline none = baseline_of({});
    const std::vector<Group> groups{group_of("door", "post")};
    EXPECT_TRUE(GroupStatuses(groups, &none, {rule_of("door", "post", false)}, bodies).has_news());
    EXPECT_FALSE(GroupStatuses(groups, &none, {rule_of("door", "post", true)}, bodies).has_news());
}

TEST(GroupStatuses, ADecisionHoldsUpToItsPairs) {
    const std::vector<Group> groups{group_of("door", "post", 10)};
    const Baseline baseline = baseline_of(groups);
    const auto status = [&](const Baseline* against, std::optional<std::uint64_t> pairs_max) {
        return GroupStatuses(groups, against, {rule_of("*", "p*", true, pairs_max)}, bodies)
            .groups()[0]
            .status;
    };
    EXPECT_EQ(status(&baseline, 10), GroupStatus::Approved);
    EXPECT_EQ(status(&baseline, 9), GroupStatus::Active);
    EXPECT_EQ(status(nullptr, 10), GroupStatus::Approved);
    EXPECT_EQ(status(nullptr, 9), GroupStatus::Unjudged);
    const Baseline none = baseline_of({});
    EXPECT_EQ(status(&none, 9), GroupStatus::New);
}

TEST(GroupStatuses, WithoutPairsADecisionHoldsUpToTwiceTheBaseline) {
    const Baseline baseline = baseline_of({group_of("door", "post", 10)});
    const auto judged = [&](std::uint64_t worst_pairs) {
        return GroupStatuses({group_of("door", "post", worst_pairs)},
                             &baseline,
                             {rule_of("door", "post", false)},
                             bodies);
    };
    EXPECT_EQ(judged(20).groups()[0].status, GroupStatus::Reviewed);
    EXPECT_EQ(judged(20).groups()[0].note, "wanted");
    EXPECT_EQ(judged(21).groups()[0].status, GroupStatus::Active);
    EXPECT_EQ(judged(21).groups()[0].note, "wanted; reviewed up to 20 pairs, now 21 in scenario 0");
}

TEST(GroupStatuses, TheLastRuleThatMatchesCounts) {
    const GroupStatuses judged({group_of("door", "post"), group_of("sill", "post")},
                               nullptr,
                               {rule_of("*", "*", false), rule_of("van/door", "b/post", true)},
                               bodies);
    EXPECT_THAT(statuses_of(judged), ElementsAre(GroupStatus::Approved, GroupStatus::Reviewed));
    EXPECT_THAT(judged.warnings(), IsEmpty());
}

TEST(GroupStatuses, ARuleThatMatchesNothingIsNamed) {
    const Baseline baseline = baseline_of({group_of("roof", "post")});
    const GroupStatuses judged(
        {}, &baseline, {rule_of("roof", "post", true), rule_of("car/roof", "post", true)}, bodies);
    EXPECT_THAT(judged.warnings(), ElementsAre(HasSubstr("s.toml:1: clash matches no group")))
        << "the baseline's groups count as matched";
    EXPECT_THAT(statuses_of(judged), ElementsAre(GroupStatus::Resolved));
}

TEST(GroupStatuses, RowsHaveStatusAndNote) {
    const Baseline baseline = baseline_of({group_of("roof", "post")}, false);
    const GroupStatuses judged(
        {group_of("door", "post")}, &baseline, {rule_of("door", "post", true)}, bodies);
    const auto rows = rows_of(judged);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].status, "approved");
    EXPECT_EQ(rows[0].note, "wanted");
    EXPECT_EQ(rows[1].status, "not comparable");
    EXPECT_EQ(judged.count(GroupStatus::NotComparable), 1u);
}

} // namespace cd::tests
