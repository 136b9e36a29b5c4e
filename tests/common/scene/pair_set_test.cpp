// Proves that a set of pairs has the pairs that were added, against a set of the standard library.

#include "common/scene/pair_set.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cd::tests {

namespace {

using Bodies = std::vector<std::uint32_t>;

BodyPair ordered(std::uint32_t one, std::uint32_t other) {
    return {std::min(one, other), std::max(one, other)};
}

std::set<BodyPair> pairs_between(const Bodies& left, const Bodies& right) {
    std::set<BodyPair> pairs;
    for (const std::uint32_t one : left) {
        for (const std::uint32_t other : right) {
            if (one != other) {
                pairs.insert(ordered(one, other));
            }
        }
    }
    return pairs;
}

Bodies some_of(std::mt19937_64& random, std::size_t bodies) {
    Bodies some;
    const std::uint64_t part = 1 + random() % 4;
    for (std::uint32_t body = 0; body < bodies; ++body) {
        if (random() % part == 0) {
            some.push_back(body);
        }
    }
    return some;
}

void expect_equal(const PairSet& set, const std::set<BodyPair>& expected) {
    EXPECT_EQ(set.count(), expected.size());
    for (std::uint32_t a = 0; a < set.bodies(); ++a) {
        for (std::uint32_t b = 0; b < set.bodies(); ++b) {
            EXPECT_EQ(set.has({a, b}), expected.contains(ordered(a, b))) << a << " " << b;
        }
    }
}

} // namespace

TEST(PairSet, HasThePairsThatWereAdded) {
    for (SeededRandom random : seeds(15)) {
        const std::size_t bodies = 1 + random() % 100;
        PairSet set(bodies);
        std::set<BodyPair> expected;
        for (int round = 0; round < 3; ++round) {
            const Bodies left = some_of(random, bodies);
            const Bodies right = some_of(random, bodies);
            const std::size_t before = expected.size();
            expected.merge(pairs_between(left, right));
            EXPECT_EQ(set.add(left, right), expected.size() - before);
        }
        expect_equal(set, expected);
    }
}

TEST(PairSet, LosesThePairsThatAreRemoved) {
    for (SeededRandom random : seeds(15)) {
        const std::size_t bodies = 2 + random() % 100;
        const Bodies left = some_of(random, bodies);
        const Bodies right = some_of(random, bodies);
        PairSet set(bodies);
        set.add(left, right);
        std::set<BodyPair> expected = pairs_between(left, right);
        for (int round = 0; round < 30; ++round) {
            const auto one = static_cast<std::uint32_t>(random() % bodies);
            const auto other = static_cast<std::uint32_t>(random() % bodies);
            set.remove({one, other});
            expected.erase(ordered(one, other));
        }
        expect_equal(set, expected);
    }
}

TEST(PairSet, AddsNoPairThatIsExcepted) {
    for (SeededRandom random : seeds(15)) {
        const std::size_t bodies = 1 + random() % 100;
        PairSet except(bodies);
        const Bodies first = some_of(random, bodies);
        const Bodies second = some_of(random, bodies);
        except.add(first, second);
        const std::set<BodyPair> excepted = pairs_between(first, second);
        const Bodies left = some_of(random, bodies);
        const Bodies right = some_of(random, bodies);
        std::set<BodyPair> expected = pairs_between(left, right);
        std::erase_if(expected, [&](BodyPair pair) { return excepted.contains(pair); });
        PairSet set(bodies);
        EXPECT_EQ(set.add_except(left, right, except), expected.size());
        expect_equal(set, expected);
    }
}

TEST(PairSet, CountsThePairsAmongFewAndAmongMostBodies) {
    for (SeededRandom random : seeds(raised(40))) {
        const std::size_t bodies = 1 + random() % 100;
        const Bodies left = some_of(random, bodies);
        const Bodies right = some_of(random, bodies);
        PairSet set(bodies);
        set.add(left, right);
        std::set<BodyPair> expected = pairs_between(left, right);
        if (!expected.empty()) {
            set.remove(*expected.begin());
            expected.erase(expected.begin());
        }
        for (const std::uint32_t part : {2u, 10u}) {
            Bodies few;
            Bodies most;
            for (std::uint32_t body = 0; body < bodies; ++body) {
                (random() % part == 0 ? few : most).push_back(body);
            }
            for (const Bodies& among : {few, most}) {
                const auto count = std::ranges::count_if(expected, [&](BodyPair pair) {
                    return std::ranges::binary_search(among, pair.a) &&
                           std::ranges::binary_search(among, pair.b);
                });
                EXPECT_EQ(set.count_among(among), static_cast<std::uint64_t>(count));
            }
        }
    }
}

} // namespace cd::tests
