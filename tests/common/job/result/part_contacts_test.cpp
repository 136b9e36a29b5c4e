// Proves that sums of contacts by part are those of a slow count in any order and grouping, survive
// packing unchanged, and are given up where parts in contact are too many; and that arbitrary bytes
// end in an error or in sums that do not contradict themselves.
#include "common/job/result/part_contacts.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/varint.hpp"
#include "common/job/result/packed_map.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

constexpr std::uint32_t triangles = 400;

struct OneScenario {
    std::uint64_t index = 0;
    std::vector<ContactPair> pairs;
};

/// Makes parts of up to `count` numbers, each in many runs.
BodyPartRuns some_parts(SeededRandom& random, std::uint32_t count) {
    BodyPartRuns parts;
    for (PartRuns& body : parts) {
        std::vector<PartRun> runs;
        for (std::uint32_t begin = 0; begin < triangles;
             begin += 1 + static_cast<std::uint32_t>(random() % 20)) {
            runs.push_back({begin, static_cast<std::uint32_t>(random() % count)});
        }
        body = PartRuns::create(std::move(runs)).value();
    }
    return parts;
}

std::vector<OneScenario> some_scenarios(SeededRandom& random) {
    std::vector<OneScenario> scenarios;
    std::uint64_t index = random() % 5;
    for (std::uint64_t count = random() % 60; count > 0; --count) {
        OneScenario& scenario = scenarios.emplace_back();
        scenario.index = index;
        index += 1 + random() % 3;
        std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::uint64_t i = random() % 3 == 0 ? 0 : random() % 50; i > 0; --i) {
            pairs.emplace(random() % triangles, random() % triangles);
        }
        const std::uint64_t near_of_10 = random() % 2 == 0 ? 0 : random() % 11;
        for (const auto& [a, b] : pairs) {
            const bool is_near = random() % 10 < near_of_10;
            const PairClass meeting = random() % 30 == 0 ? PairClass::Proper : PairClass::Touch;
            scenario.pairs.push_back({a, b, is_near ? PairClass::Near : meeting});
        }
    }
    return scenarios;
}

/// The numbers of pairs in contact and of near pairs.
struct PairNumbers {
    std::uint64_t contact = 0;
    std::uint64_t near = 0;

    friend auto operator<=>(const PairNumbers&, const PairNumbers&) = default;
};

/// Counts straight from the definitions.
PartContacts slow_sums(const BodyPartRuns& parts, const std::vector<OneScenario>& scenarios) {
    std::array<std::map<std::uint32_t, std::set<std::uint64_t>>, 2> of_parts;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::map<std::uint64_t, PairNumbers>> pairs;
    std::set<std::pair<std::uint32_t, std::uint32_t>> proper;
    for (const OneScenario& scenario : scenarios) {
        for (const ContactPair& pair : scenario.pairs) {
            const std::uint32_t a = parts[0].runs()[parts[0].run_of(pair.a)].part;
            const std::uint32_t b = parts[1].runs()[parts[1].run_of(pair.b)].part;
            of_parts[0][a].insert(scenario.index);
            of_parts[1][b].insert(scenario.index);
            PairNumbers& numbers = pairs[{a, b}][scenario.index];
            ++(pair.kind == PairClass::Near ? numbers.near : numbers.contact);
            if (pair.kind == PairClass::Proper) {
                proper.emplace(a, b);
            }
        }
    }
    PartContacts sums;
    for (std::size_t side = 0; side < 2; ++side) {
        for (const auto& [part, in] : of_parts[side]) {
            sums.parts[side].push_back({part, in.size()});
        }
    }
    for (const auto& [key, in] : pairs) {
        PartPairContacts sum{key.first, key.second, in.size()};
        PairNumbers most;
        for (const auto& [scenario, numbers] : in) {
            sum.pairs += numbers.contact;
            sum.near += numbers.near;
            if (numbers > most) {
                most = numbers;
                sum.worst = scenario;
            }
        }
        sum.worst_pairs = most.contact;
        sum.worst_near = most.near;
        sum.first = in.begin()->first;
        sum.last = in.rbegin()->first;
        sum.has_proper = proper.contains(key);
        sums.pairs.push_back(sum);
    }
    return sums;
}

PartContacts packed_and_unpacked(const PartContacts& sums, std::uint64_t scenarios) {
    const auto map = unpack_map(pack_map({{}, sums}), {triangles, triangles, scenarios});
    EXPECT_TRUE(map) << map.error().detail;
    return map ? map.value().parts : PartContacts();
}

/// The numbers of a packed map without triangles.
Bytes packed(std::vector<std::uint64_t> numbers) {
    numbers.insert(numbers.begin(), {0, 0});
    ByteWriter out;
    for (const std::uint64_t number : numbers) {
        put_varint(out, number);
    }
    return compress(out.bytes(), 1);
}

void expect_sound(const PartContacts& sums, std::uint64_t scenarios) {
    for (const PartPairContacts& pair : sums.pairs) {
        EXPECT_TRUE(pair.scenarios > 0 && pair.scenarios <= scenarios);
        const std::uint64_t all = pair.pairs + pair.near;
        EXPECT_GE(all, pair.scenarios);
        EXPECT_LE(pair.worst_pairs + pair.worst_near, all - (pair.scenarios - 1));
        EXPECT_LE(pair.worst_pairs, pair.pairs);
        EXPECT_LE(pair.worst_near, pair.near);
        const std::uint64_t most = pair.pairs > 0 ? pair.worst_pairs : pair.worst_near;
        EXPECT_GE(most, ((pair.pairs > 0 ? pair.pairs : pair.near) - 1) / pair.scenarios + 1);
        EXPECT_TRUE(pair.pairs > 0 || !pair.has_proper);
        EXPECT_TRUE(pair.first <= pair.worst && pair.worst <= pair.last);
        EXPECT_LT(pair.last, limits::scenarios_max);
    }
    const auto key = [](const PartPairContacts& pair) { return std::pair(pair.a, pair.b); };
    EXPECT_EQ(std::ranges::adjacent_find(sums.pairs, std::ranges::greater_equal(), key),
              sums.pairs.end());
    EXPECT_TRUE(sums.left_out == 0 || sums.pairs.empty());
}

} // namespace

TEST(PartContacts, NearPairsCountApartAndWeighLessThanContacts) {
    const PartRuns one = PartRuns::create({{0, 0}}).value();
    const auto parts = std::make_shared<const BodyPartRuns>(BodyPartRuns{one, one});
    PartContactSum sum(parts);
    sum.add(3, std::vector<ContactPair>{{0, 0, PairClass::Near}, {0, 1, PairClass::Near}});
    EXPECT_EQ(sum.sums().pairs.at(0), (PartPairContacts{0, 0, 1, 0, 3, 0, 3, 3, false, 2, 2}));
    sum.add(5, std::vector<ContactPair>{{0, 0, PairClass::Touch}});
    EXPECT_EQ(sum.sums().pairs.at(0), (PartPairContacts{0, 0, 2, 1, 5, 1, 3, 5, false, 2, 0}));
    sum.add(4, std::vector<ContactPair>{{0, 0, PairClass::Proper}, {7, 1, PairClass::Near}});
    EXPECT_EQ(sum.sums().pairs.at(0), (PartPairContacts{0, 0, 3, 2, 4, 1, 3, 5, true, 3, 1}));
    EXPECT_EQ(sum.sums().parts[0].at(0), (PartScenarios{0, 3}));
    EXPECT_EQ(packed_and_unpacked(sum.sums(), 3), sum.sums());
}

TEST(PartContacts, WithoutNearPairsArePackedAsBeforeTheyWereKnown) {
    const PartRuns one = PartRuns::create({{0, 0}}).value();
    PartContactSum sum(std::make_shared<const BodyPartRuns>(BodyPartRuns{one, one}));
    sum.add(3, std::vector<ContactPair>{{0, 0, PairClass::Touch}, {0, 1, PairClass::Proper}});
    const Bytes bytes = pack_map({{}, sum.sums()});
    EXPECT_EQ(decompress(bytes, 100).value(),
              decompress(packed({1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 3, 0, 0, 1, 0}), 100).value());
}

TEST(PartContacts, AreThoseOfASlowCountInAnyOrderAndGrouping) {
    for (SeededRandom random : seeds(300)) {
        const auto parts = std::make_shared<const BodyPartRuns>(
            some_parts(random, 1 + static_cast<std::uint32_t>(random() % 8)));
        auto scenarios = some_scenarios(random);
        const PartContacts expected = slow_sums(*parts, scenarios);
        std::ranges::shuffle(scenarios, random);
        PartContactSum total;
        PartContactSum task;
        PartContactSum thread(parts);
        for (OneScenario& scenario : scenarios) {
            std::ranges::shuffle(scenario.pairs, random);
            thread.add(scenario.index, scenario.pairs);
            if (random() % 4 == 0) {
                task.add(thread.sums());
                thread = PartContactSum(parts);
            }
            if (random() % 9 == 0) {
                total.add(packed_and_unpacked(task.sums(), scenarios.size()));
                task = PartContactSum();
            }
        }
        task.add(thread.sums());
        total.add(task.sums());
        EXPECT_EQ(total.sums(), expected);
        EXPECT_EQ(packed_and_unpacked(expected, scenarios.size()), expected);
        EXPECT_EQ(expected.empty(), expected.pairs.empty());
    }
}

TEST(PartContacts, TooManyPairsOfPartsAreLeftOutHoweverTheyAreGrouped) {
    constexpr std::uint32_t side = 400; // Squared, more than may be.
    static_assert(std::uint64_t{side} * side > limits::groups_max);
    std::vector<PartRun> runs;
    for (std::uint32_t i = 0; i < side; ++i) {
        runs.push_back({i, i});
    }
    const PartRuns body = PartRuns::create(runs).value();
    const auto parts = std::make_shared<const BodyPartRuns>(BodyPartRuns{body, body});
    std::vector<OneScenario> scenarios(20);
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        for (std::uint32_t a = 0; a < side; ++a) {
            for (std::uint32_t b = static_cast<std::uint32_t>(i); b < side; b += 20) {
                scenarios[i].pairs.push_back({a, b});
                ++count;
            }
        }
    }
    for (const std::size_t grouped : {std::size_t{1}, std::size_t{3}, scenarios.size()}) {
        PartContactSum total;
        PartContactSum some(parts);
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            some.add(i, scenarios[i].pairs);
            if ((i + 1) % grouped == 0) {
                total.add(some.sums());
                some = PartContactSum(parts);
            }
        }
        total.add(some.sums());
        const PartContacts sums = total.sums();
        EXPECT_TRUE(sums.pairs.empty());
        EXPECT_EQ(sums.left_out, count);
        ASSERT_EQ(sums.parts[0].size(), side) << "parts by themselves are still counted";
        EXPECT_EQ(sums.parts[0][7], (PartScenarios{7, 20}));
        EXPECT_EQ(sums.parts[1][7], (PartScenarios{7, 1}));
        EXPECT_EQ(packed_and_unpacked(sums, 20), sums);
    }
}

TEST(PartContacts, RefuseNumbersThatContradictEachOther) {
    const auto are_sums = [](const std::vector<std::uint64_t>& numbers) {
        const auto map = unpack_map(packed(numbers), {9, 9, 3});
        EXPECT_TRUE(map || map.error().code == ErrorCode::BadFrame);
        return static_cast<bool>(map);
    };
    // Two bodies of one part in two scenarios; one pair of parts: a, b, scenarios - 1, pairs -
    // scenarios, worst pairs - 1, first, worst - first, last - first, proper; none left out.
    EXPECT_TRUE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 4, 10, 0, 1, 1, 0}));
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 4, 10, 0, 1, 1, 5})) << "left out, too";
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 3, 4, 4, 10, 0, 3, 1, 0})) << "scenarios";
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 5, 10, 0, 1, 1, 0})) << "worst: many";
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 1, 10, 0, 1, 1, 0})) << "worst: few";
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 4, 10, 2, 1, 1, 0})) << "worst: late";
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 4, 10, 0, 0, 1, 0})) << "last";
    EXPECT_FALSE(are_sums({1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 4, 10, 0, 1, 4, 0})) << "flags";
    EXPECT_FALSE(are_sums({1, limits::parts_max + 1, 1, 1, 0, 1, 0, 0})) << "a part";
    EXPECT_FALSE(are_sums({0, 0, limits::groups_max + 1, 0})) << "pairs of parts";
}

TEST(PartContacts, RefuseNearPairsThatContradictTheOthers) {
    // One pair of parts in two scenarios with six pairs, at most five in one scenario, and then
    // flags, near pairs - 1 and near pairs of the worst scenario.
    const auto are_sums = [](std::uint64_t flags, std::uint64_t near, std::uint64_t worst_near) {
        const std::vector<std::uint64_t> numbers{
            1, 0, 1, 1, 0, 1, 1, 0, 0, 1, 4, 4, 10, 0, 1, flags, near, worst_near, 0};
        const auto map = unpack_map(packed(numbers), {9, 9, 3});
        EXPECT_TRUE(map || map.error().code == ErrorCode::BadFrame);
        return static_cast<bool>(map);
    };
    EXPECT_TRUE(are_sums(3, 1, 1)) << "four in contact, all of them in the worst";
    EXPECT_TRUE(are_sums(2, 5, 5)) << "all are near";
    EXPECT_FALSE(are_sums(3, 5, 5)) << "proper without a contact";
    EXPECT_FALSE(are_sums(2, 6, 5)) << "more near pairs than pairs";
    EXPECT_FALSE(are_sums(2, 1, 3)) << "more of them in one scenario than in all";
    EXPECT_FALSE(are_sums(2, 4, 5)) << "a worst without the only contact";
    EXPECT_FALSE(are_sums(2, 1, 0)) << "more contacts in one scenario than in all";
    EXPECT_FALSE(are_sums(0, 0, 0)) << "numbers behind the last one";
}

TEST(PartContacts, ArbitraryBytesDoNoHarm) {
    for (SeededRandom random : seeds(1)) {
        const BodyPartRuns parts = some_parts(random, 5);
        const Bytes bytes = pack_map({{}, slow_sums(parts, some_scenarios(random))});
        const Bytes plain = decompress(bytes, 1u << 20).value();
        for (int round = 0; round < 20000; ++round) {
            Bytes changed = plain;
            for (std::uint64_t changes = 1 + random() % 3; changes > 0; --changes) {
                changed[random() % changed.size()] = static_cast<std::byte>(random());
            }
            const auto map = unpack_map(compress(changed, 1), {triangles, triangles, 60});
            if (map) {
                expect_sound(map.value().parts, 60);
            }
        }
    }
}

} // namespace cd::tests
