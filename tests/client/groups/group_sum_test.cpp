// Proves that groups of contacts are those that a slow sum over all pairs finds.
#include "client/groups/group_sum.hpp"

#include "common/core/limits/client.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/contact_map.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Makes two parts of six triangles each.
Mesh two_parts() {
    const Mesh box = make_box({1, 1, 1});
    return Mesh::create({box.vertices(),
                         box.triangles(),
                         {{"left", 0, 6}, {"right", 6, 12}},
                         box.precision()})
        .value();
}

ScenarioResult result_of(std::uint64_t index, std::vector<ContactPair> pairs, ScenarioClass kind) {
    ScenarioResult result;
    result.index = index;
    result.kind = kind;
    result.pair_count = pairs.size();
    result.pairs = std::move(pairs);
    return result;
}

bool share_a_vertex(const Mesh& mesh, std::uint32_t left, std::uint32_t right) {
    for (const Vec3& l : mesh.corners(left)) {
        for (const Vec3& r : mesh.corners(right)) {
            if (l == r) {
                return true;
            }
        }
    }
    return false;
}

/// Counts connected sets of triangles by spreading from each.
std::uint64_t slow_regions(const Mesh& mesh, std::set<std::uint32_t> triangles) {
    std::uint64_t regions = 0;
    for (; !triangles.empty(); ++regions) {
        std::vector<std::uint32_t> waiting{*triangles.begin()};
        triangles.erase(triangles.begin());
        while (!waiting.empty()) {
            const std::uint32_t from = waiting.back();
            waiting.pop_back();
            for (auto it = triangles.begin(); it != triangles.end();) {
                if (share_a_vertex(mesh, from, *it)) {
                    waiting.push_back(*it);
                    it = triangles.erase(it);
                } else {
                    ++it;
                }
            }
        }
    }
    return regions;
}

/// Sums one group in the slowest way: over all results again.
Group slow_group(const std::vector<ScenarioResult>& results,
                 const Mesh& a,
                 const Mesh& b,
                 const std::pair<std::string, std::string>& parts) {
    const BodyParts of_a(a);
    const BodyParts of_b(b);
    Group group;
    group.part_a = parts.first;
    group.part_b = parts.second;
    group.kind = ScenarioClass::Near;
    std::array<std::set<std::uint32_t>, 2> touched;
    std::vector<Episode> episodes;
    for (const ScenarioResult& result : results) {
        std::uint64_t pairs = 0;
        std::uint64_t near = 0;
        for (const ContactPair& pair : result.pairs) {
            if (of_a.name(of_a.part_of(pair.a)) != parts.first ||
                of_b.name(of_b.part_of(pair.b)) != parts.second) {
                continue;
            }
            ++(pair.kind == PairClass::Near ? near : pairs);
            touched[0].insert(pair.a);
            touched[1].insert(pair.b);
            if (pair.kind == PairClass::Proper) {
                group.kind = ScenarioClass::Cross;
            }
        }
        if (pairs + near == 0) {
            continue;
        }
        ++group.scenarios;
        group.pairs += pairs;
        group.near.pairs += near;
        if (pairs != 0 && group.kind == ScenarioClass::Near) {
            group.kind = ScenarioClass::Touch;
        }
        group.episodes.last = result.index;
        if (pairs > group.worst_pairs ||
            (pairs == group.worst_pairs && near > group.near.worst_pairs)) {
            group.worst_pairs = pairs;
            group.near.worst_pairs = near;
            group.worst = result.index;
        }
        if (!episodes.empty() && episodes.back().last + 1 == result.index) {
            episodes.back().last = result.index;
        } else {
            episodes.push_back({result.index, result.index});
        }
    }
    group.regions = {slow_regions(a, touched[0]), slow_regions(b, touched[1])};
    group.episodes.count = episodes.size();
    episodes.resize(std::min(episodes.size(), limits::group_episodes_max));
    group.episodes.first = episodes;
    return group;
}

/// Makes a mesh of small triangles on a lattice, so that some share vertices; with parts or not.
Mesh random_mesh(SeededRandom& random) {
    std::vector<Vec3> corners;
    const std::uint32_t triangles = 1 + static_cast<std::uint32_t>(random() % 60);
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const Vec3 at(static_cast<double>(random() % 6), static_cast<double>(random() % 6), 0);
        corners.insert(corners.end(), {at, at + Vec3(1, 0, 0), at + Vec3(0, 0, 1)});
    }
    const Mesh soup = make_soup(std::move(corners));
    std::vector<Part> parts;
    for (std::uint32_t begin = 0; random() % 4 != 0 && begin < triangles;) {
        const std::uint32_t end =
            std::min(triangles, begin + 1 + static_cast<std::uint32_t>(random() % 20));
        parts.push_back({std::string("part ") + "abcdef"[random() % 6], begin, end});
        begin = end + static_cast<std::uint32_t>(random() % 2);
    }
    return Mesh::create({soup.vertices(), soup.triangles(), parts, soup.precision()}).value();
}

std::vector<ScenarioResult> random_results(SeededRandom& random, const Mesh& a, const Mesh& b) {
    std::vector<ScenarioResult> results;
    std::uint64_t index = 0;
    for (int i = 0; i < 40; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, PairClass> pairs;
        const std::uint64_t count = random() % 3 == 0 ? 0 : random() % 40;
        for (std::uint64_t k = 0; k < count; ++k) {
            pairs[{static_cast<std::uint32_t>(random() % a.triangles().size()),
                   static_cast<std::uint32_t>(random() % b.triangles().size())}] =
                random() % 20 == 0  ? PairClass::Proper
                : random() % 2 == 0 ? PairClass::Near
                                    : PairClass::Touch;
        }
        ScenarioResult result = result_of(index, {}, ScenarioClass::Touch);
        for (const auto& [key, kind] : pairs) {
            result.pairs.push_back({key.first, key.second, kind});
        }
        results.push_back(std::move(result));
        index += random() % 10 == 0 ? 3 : 1; // Some scenarios have no result.
    }
    return results;
}

} // namespace

TEST(GroupSum, AgreesWithASlowSum) {
    for (SeededRandom random : seeds(60)) {
        const auto a = share(random_mesh(random));
        const auto b = share(random_mesh(random));
        const std::vector<ScenarioResult> results = random_results(random, *a, *b);
        GroupSum sum({a, b});
        std::uint64_t pairs = 0;
        for (const ScenarioResult& result : results) {
            sum.add(result);
            pairs += result.pairs.size();
        }
        const std::vector<Group> groups = sum.groups();
        std::set<std::pair<std::string, std::string>> keys;
        for (const Group& group : groups) {
            EXPECT_TRUE(keys.emplace(group.part_a, group.part_b).second) << "a group appears once";
            EXPECT_EQ(group, slow_group(results, *a, *b, {group.part_a, group.part_b}))
                << group.part_a << " and " << group.part_b;
            pairs -= group.pairs + group.near.pairs;
        }
        EXPECT_EQ(pairs, 0u) << "each pair is in a group";
        EXPECT_TRUE(std::ranges::is_sorted(
            groups, [](const Group& l, const Group& r) { return l.scenarios > r.scenarios; }));
        EXPECT_EQ(sum.left_out(), 0u);
    }
}

TEST(GroupSum, SumsByPartGiveTheGroupsThatListsGive) {
    for (SeededRandom random : seeds(60)) {
        const auto a = share(random_mesh(random));
        const auto b = share(random_mesh(random));
        GroupSum of_lists({a, b}, PartKind::Named);
        GroupSum of_sums({a, b}, PartKind::Named);
        ContactMapSum map(body_part_runs(*a, *b));
        for (const ScenarioResult& result : random_results(random, *a, *b)) {
            of_lists.add(result);
            ScenarioResult counted = result;
            counted.level = Level::Count;
            counted.pairs.clear();
            of_sums.add(counted);
            map.add(counted, result.pairs);
        }
        ASSERT_TRUE(of_sums.add(map.take().parts));
        std::vector<Group> expected = of_lists.groups();
        for (Group& group : expected) { // What sums do not know.
            group.kind = group.kind == ScenarioClass::Touch ? ScenarioClass::Contact : group.kind;
            group.regions = {};
            const std::uint64_t last = group.episodes.last;
            group.episodes = {0, last, {{group.episodes.first.front().first, last}}};
        }
        EXPECT_THAT(of_sums.groups(), testing::UnorderedElementsAreArray(expected));
        EXPECT_EQ(of_sums.left_out(), 0u);
        std::map<std::string, std::uint64_t> touched;
        for (const TouchedPart& part : of_lists.most_touched(100)) {
            touched[part.part] += part.scenarios;
        }
        for (const TouchedPart& part : of_sums.most_touched(100)) {
            touched[part.part] -= part.scenarios;
        }
        for (const auto& [part, scenarios] : touched) {
            EXPECT_EQ(scenarios, 0u) << part;
        }
    }
}

TEST(GroupSum, SumsOfOtherPartsAreRefused) {
    PartContacts contacts;
    contacts.parts = {{{{0, 1}}, {{0, 1}}}};
    contacts.pairs = {{0, 2, 1, 1, 0, 1, 0, 0, false}};
    const auto box = share(make_box({1, 1, 1}));
    EXPECT_FALSE(GroupSum({box, box}, PartKind::Named).add(contacts));
    contacts.pairs.clear();
    contacts.parts[1][0].part = 1;
    EXPECT_FALSE(GroupSum({box, box}, PartKind::Named).add(contacts));
}

TEST(GroupSum, TooManySumsAreLeftOut) {
    const auto box = share(make_box({1, 1, 1}));
    GroupSum sum({box, box}, PartKind::Named);
    PartContacts contacts;
    contacts.parts = {{{{0, 2}}, {{0, 2}}}};
    contacts.left_out = 17;
    ASSERT_TRUE(sum.add(contacts));
    EXPECT_THAT(sum.groups(), IsEmpty());
    EXPECT_EQ(sum.left_out(), 17u);
}

TEST(GroupSum, ManyEpisodesAreCountedAndTheFirstKept) {
    GroupSum sum({share(make_box({1, 1, 1})), share(make_box({1, 1, 1}))});
    const std::uint64_t episodes = limits::group_episodes_max + 7;
    for (std::uint64_t i = 0; i < episodes; ++i) {
        sum.add(result_of(3 * i, {{0, 0, PairClass::Touch}}, ScenarioClass::Touch));
        sum.add(result_of(3 * i + 1, {{0, 1, PairClass::Touch}}, ScenarioClass::Touch));
        sum.add(result_of(3 * i + 2, {}, ScenarioClass::Separate));
    }
    const std::vector<Group> groups = sum.groups();
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].episodes.count, episodes);
    ASSERT_EQ(groups[0].episodes.first.size(), limits::group_episodes_max);
    EXPECT_EQ(groups[0].episodes.first.back(), (Episode{297, 298}));
}

TEST(GroupSum, ACrossingWithoutAProperPairCrosses) {
    GroupSum sum({share(make_box({1, 1, 1})), share(make_box({1, 1, 1}))});
    sum.add(result_of(0, {{0, 0, PairClass::Coplanar}}, ScenarioClass::Touch));
    EXPECT_EQ(sum.groups()[0].kind, ScenarioClass::Touch);
    sum.add(result_of(1, {{0, 0, PairClass::Coplanar}}, ScenarioClass::Cross));
    EXPECT_EQ(sum.groups()[0].kind, ScenarioClass::Cross);
}

TEST(GroupSum, AGroupBesideACrossingOneMayTouch) {
    GroupSum sum({share(two_parts()), share(make_box({1, 1, 1}))});
    sum.add(
        result_of(0, {{0, 0, PairClass::Touch}, {7, 0, PairClass::Proper}}, ScenarioClass::Cross));
    const std::vector<Group> groups = sum.groups();
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].kind, ScenarioClass::Touch);
    EXPECT_EQ(groups[1].kind, ScenarioClass::Cross);
}

TEST(GroupSum, NearPairsBesideACrossingStayNear) {
    const auto mesh = share(two_parts());
    GroupSum sum({mesh, mesh});
    sum.add(
        result_of(0, {{0, 0, PairClass::Touch}, {6, 6, PairClass::Near}}, ScenarioClass::Cross));
    const auto groups = sum.groups();
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].kind, ScenarioClass::Cross);
    EXPECT_EQ(groups[1].kind, ScenarioClass::Near);
    EXPECT_EQ(groups[1].pairs, 0u);
    EXPECT_EQ(groups[1].near.pairs, 1u);
}

TEST(GroupSum, ARunWithoutContactHasNoGroups) {
    GroupSum sum({share(two_parts()), share(two_parts())});
    sum.add(result_of(0, {}, ScenarioClass::Inside));
    EXPECT_THAT(sum.groups(), IsEmpty());
    EXPECT_EQ(sum.inside(), 1u);
    EXPECT_THAT(sum.most_touched(), IsEmpty());
    EXPECT_EQ(sum.parts(1).count(), 2u);
}

TEST(GroupSum, MostTouchedCountsScenariosNotPairs) {
    GroupSum sum({share(two_parts()), share(make_box({1, 1, 1}))});
    sum.add(
        result_of(0,
                  {{0, 0, PairClass::Proper}, {1, 0, PairClass::Proper}, {7, 3, PairClass::Touch}},
                  ScenarioClass::Cross));
    sum.add(result_of(1, {{11, 0, PairClass::Proper}}, ScenarioClass::Cross));
    const auto touched = sum.most_touched(5);
    ASSERT_EQ(touched.size(), 2u) << "the box is a single part";
    EXPECT_EQ(touched[0].part, "right");
    EXPECT_EQ(touched[0].scenarios, 2u);
    EXPECT_EQ(touched[1].scenarios, 1u);
}

TEST(GroupSum, PiecesAreNotAmongTheMostTouched) {
    const auto pieces =
        share(join({make_box({1, 1, 1}), translated(make_box({1, 1, 1}), {5, 0, 0})}));
    GroupSum sum({pieces, pieces});
    sum.add(result_of(0, {{0, 13, PairClass::Proper}}, ScenarioClass::Cross));
    EXPECT_THAT(sum.most_touched(5), IsEmpty());
    const std::vector<Group> groups = sum.groups();
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].part_a, "piece 1");
    EXPECT_EQ(groups[0].part_b, "piece 2");
    EXPECT_THAT(groups[0].regions, ElementsAre(1, 1));
}

} // namespace cd::tests
