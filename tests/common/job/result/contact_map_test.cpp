// Proves that contact maps are the sums of their scenarios in any grouping, survive packing
// unchanged, and that arbitrary bytes end in an error or a map within its bounds.
#include "common/job/result/contact_map.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/varint.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/run_scenario.hpp"
#include "common/shots/line_hit.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace cd::tests {
namespace {

constexpr std::uint32_t triangles = 5000;

std::vector<ContactPair> some_pairs(std::mt19937_64& random) {
    std::vector<ContactPair> pairs(random() % 300);
    const std::uint64_t reach = 1 + random() % triangles;
    for (ContactPair& pair : pairs) {
        pair.a = static_cast<std::uint32_t>(random() % reach);
        pair.b = static_cast<std::uint32_t>(random() % triangles);
    }
    return pairs;
}

/// Counts a map straight from its definition.
ContactMap counted(const std::vector<std::vector<ContactPair>>& scenarios) {
    std::array<std::map<std::uint32_t, std::uint64_t>, 2> counts;
    for (const auto& pairs : scenarios) {
        std::array<std::set<std::uint32_t>, 2> touched;
        for (const ContactPair& pair : pairs) {
            touched[0].insert(pair.a);
            touched[1].insert(pair.b);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            for (const std::uint32_t triangle : touched[i]) {
                ++counts[i][triangle];
            }
        }
    }
    ContactMap map;
    for (std::size_t i = 0; i < 2; ++i) {
        for (const auto& [triangle, scenarios_of_it] : counts[i]) {
            map.bodies[i].push_back({triangle, scenarios_of_it});
        }
    }
    return map;
}

ContactMapBounds bounds_of(std::uint64_t scenarios) {
    return {triangles, triangles, scenarios};
}

/// Packs the numbers of triangles; behind them come no sums by part.
Bytes packed_numbers(std::vector<std::uint64_t> numbers) {
    numbers.insert(numbers.end(), {0, 0, 0, 0});
    ByteWriter out;
    for (const std::uint64_t number : numbers) {
        put_varint(out, number);
    }
    return compress(out.bytes(), 1);
}

} // namespace

TEST(ContactMap, IsTheSumOfItsScenariosHoweverTheyAreGrouped) {
    std::mt19937_64 random(1);
    for (int round = 0; round < 20; ++round) {
        std::vector<std::vector<ContactPair>> scenarios(1 + random() % 800);
        ContactMapTotal total;
        ContactMapSum task;
        ContactMapSum thread;
        for (auto& pairs : scenarios) {
            pairs = some_pairs(random);
            thread.add(pairs);
            if (random() % 7 == 0) {
                task.add(thread.take());
            }
            if (random() % 50 == 0) {
                total.add(task.take());
            }
        }
        task.add(thread.take());
        total.add(task.take());
        EXPECT_EQ(total.map(), counted(scenarios));
        EXPECT_TRUE(task.empty());
    }
}

TEST(ContactMap, ComesBackFromItsPackedForm) {
    std::mt19937_64 random(2);
    for (int round = 0; round < 100; ++round) {
        std::vector<std::vector<ContactPair>> scenarios(random() % 20);
        for (auto& pairs : scenarios) {
            pairs = some_pairs(random);
        }
        const ContactMap map = counted(scenarios);
        const auto again = unpack_map(pack_map(map), bounds_of(scenarios.size()));
        ASSERT_TRUE(again) << again.error().detail;
        EXPECT_EQ(again.value(), map);
        EXPECT_EQ(digest_of(again.value()), digest_of(map));
    }
    ContactMap most;
    most.bodies[0] = {{0, 1}, {triangles - 1, std::uint64_t{1} << 40}};
    EXPECT_EQ(unpack_map(pack_map(most), bounds_of(std::uint64_t{1} << 40)).value(), most);
}

TEST(ContactMap, RefusesInvalidMaps) {
    const auto is_map = [](const std::vector<std::uint64_t>& numbers) {
        const auto map = unpack_map(packed_numbers(numbers), bounds_of(3));
        EXPECT_TRUE(map || map.error().code == ErrorCode::BadFrame);
        return static_cast<bool>(map);
    };
    EXPECT_TRUE(is_map({0, 0}));
    EXPECT_TRUE(is_map({1, 0, 0, 1, triangles - 1, 2}));
    EXPECT_FALSE(is_map({1, 0, 0, 1, triangles, 2})) << "a triangle too many";
    EXPECT_FALSE(is_map({2, triangles - 1, 0, 0, 0, 0})) << "a step beyond the last";
    EXPECT_FALSE(is_map({1, 0, 3, 0})) << "more scenarios than there are";
    EXPECT_FALSE(is_map({0})) << "one body";
    EXPECT_FALSE(is_map({0, 0, 0})) << "three bodies";
    EXPECT_FALSE(is_map({std::uint64_t{1} << 60, 0})) << "more triangles than bytes";
    EXPECT_FALSE(unpack_map(packed_numbers({1, 0, 0, 0}), bounds_of(0))) << "of no scenario";
}

TEST(ContactMap, ArbitraryBytesDoNoHarm) {
    std::mt19937_64 random(3);
    ContactMap map = counted({some_pairs(random), some_pairs(random), some_pairs(random)});
    const Bytes packed = pack_map(map);
    for (int round = 0; round < 20000; ++round) {
        Bytes bytes = packed;
        for (std::uint64_t changes = 1 + random() % 3; changes > 0; --changes) {
            bytes[random() % bytes.size()] = static_cast<std::byte>(random());
        }
        bytes.resize(random() % 4 == 0 ? random() % bytes.size() : bytes.size());
        (void)unpack_map(bytes, bounds_of(3));
    }
    for (int round = 0; round < 20000; ++round) {
        std::vector<std::uint64_t> numbers(random() % 12);
        for (std::uint64_t& number : numbers) {
            number = random() % 3 == 0 ? random() % 4 : random() >> random() % 64;
        }
        const auto any = unpack_map(packed_numbers(numbers), bounds_of(3));
        if (any) {
            for (const auto& body : any.value().bodies) {
                for (std::size_t i = 0; i < body.size(); ++i) {
                    EXPECT_LT(body[i].triangle, triangles);
                    EXPECT_LE(body[i].scenarios, 3u);
                    EXPECT_TRUE(i == 0 || body[i - 1].triangle < body[i].triangle);
                }
            }
        }
    }
}

TEST(ContactMap, ACountWithMapsFindsThePairsAndCountsTheSame) {
    ThreadPool pool(1);
    const ObbTree a = build_tree(share(make_torus(1, 0.4, 30, 20)), {}, pool);
    const ObbTree b = build_tree(share(make_sphere(2)), {}, pool);
    Query count;
    count.level = Level::Count;
    Query maps = count;
    maps.maps = true;
    const ScenarioRunner counting(a, b, count);
    const ScenarioRunner mapping(a, b, maps);
    const Query pairs;
    const ScenarioRunner listing(a, b, pairs);
    std::mt19937_64 random(4);
    std::size_t in_contact = 0;
    for (std::uint64_t index = 0; index < 200; ++index) {
        Scenario scenario;
        scenario.index = index;
        scenario.poses.b = make_pose(random, 1.5);
        const ScenarioRun run = mapping.run(scenario);
        EXPECT_EQ(encode_result(run.result), encode_result(counting.run(scenario).result));
        EXPECT_EQ(run.found, listing.run(scenario).result.pairs);
        in_contact += run.found.empty() ? 0 : 1;
    }
    EXPECT_GT(in_contact, 50u);
    EXPECT_LT(in_contact, 200u);
}

TEST(ContactMap, AListThatIsCutHasAMapOfAllItsPairs) {
    ThreadPool pool(1);
    const ObbTree a = build_tree(share(make_torus(1, 0.4, 30, 20)), {}, pool);
    const ObbTree b = build_tree(share(make_sphere(2)), {}, pool);
    std::mt19937_64 random(4);
    std::size_t cut = 0;
    for (const Level level : {Level::Pairs, Level::Contacts}) {
        Query plain;
        plain.level = level;
        plain.limit_pairs = 5;
        Query maps = plain;
        maps.maps = true;
        const Query all;
        const ScenarioRunner listing(a, b, all);
        const ScenarioRunner cutting(a, b, plain);
        const ScenarioRunner mapping(a, b, maps);
        for (std::uint64_t index = 0; index < 100; ++index) {
            Scenario scenario;
            scenario.index = index;
            scenario.poses.b = make_pose(random, 1.5);
            const ScenarioRun run = mapping.run(scenario);
            EXPECT_EQ(encode_result(run.result), encode_result(cutting.run(scenario).result));
            EXPECT_EQ(run.found, listing.run(scenario).result.pairs);
            cut += run.found.size() > 5 ? 1 : 0;
        }
    }
    EXPECT_GT(cut, 50u);
}

TEST(ContactMap, SumsByPartCountListedHitsThatCross) {
    ScenarioResult result;
    result.question = Question::Shots;
    result.kind = ScenarioClass::Contact;
    result.pair_count = 3;
    result.pairs = {{0, 0, PairClass::Touch}, {1, 0, PairClass::Touch}, {1, 1, PairClass::Touch}};
    result.hits = {{1, hit_flag::crosses | hit_flag::front, 0},
                   {1, hit_flag::front | hit_flag::edge, 0},
                   {2, hit_flag::crosses | hit_flag::back, 0}};
    EXPECT_EQ(crossings_of(result).size(), 2u);
    ContactMapSum sum(std::make_shared<const BodyPartRuns>());
    sum.add(result, {});
    const ContactMap map = sum.take();
    EXPECT_TRUE(map.bodies[0].empty()) << "the query has no maps";
    ASSERT_EQ(map.parts.pairs.size(), 1u);
    EXPECT_EQ(map.parts.pairs[0].pairs, 2u);
    EXPECT_EQ(map.parts.pairs[0].scenarios, 1u);
    result.hits[0].flags = result.hits[2].flags = 0;
    sum.add(result, {});
    EXPECT_TRUE(sum.take().empty()) << "lines that only graze";
}

TEST(PackedMap, ATriangleMayHaveMoreCrossingsThanScenarios) {
    ContactMap map;
    map.bodies[0] = {{2, 9}};
    map.bodies[1] = {{0, 4}, {3, 5}};
    ContactMapBounds bounds{3, 4, 1};
    EXPECT_FALSE(unpack_map(pack_map(map), bounds));
    bounds.crossings = 8;
    EXPECT_FALSE(unpack_map(pack_map(map), bounds));
    bounds.crossings = 9;
    EXPECT_EQ(unpack_map(pack_map(map), bounds).value(), map);
}

} // namespace cd::tests
