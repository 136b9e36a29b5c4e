// Proves that every scenario becomes ready exactly once, when its last subtree has arrived; that a
// missing subtree is requested once; that no subtree a ready scenario needs is evicted; and that no
// order of events deadlocks, however small the cache.
#include "worker/peers/fetcher.hpp"

#include "tests/worker/cut_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace cd::tests {
namespace {

constexpr TreeId tree_a{1};
constexpr TreeId tree_b{2};
constexpr std::uint64_t unlimited = std::uint64_t{1} << 40;

using Tokens = std::vector<Fetcher::Token>;
using Keys = std::vector<SubtreeKey>;

struct Bodies {
    CutBody a = cut_body(make_sphere(3), 4);
    CutBody b = cut_body(make_sphere(2), 3);

    [[nodiscard]] OpenedBlock open(const SubtreeKey& key) const {
        const SubtreeBlock& block = (key.tree == tree_a ? a : b).block(key.root);
        return open_block(block).value();
    }
};

const Bodies& bodies() {
    static const Bodies made;
    return made;
}

/// A cache with both trees, its fetcher, and the master's messages.
struct Bench {
    explicit Bench(std::uint64_t bytes) : cache(bytes), fetcher(cache) {
        EXPECT_TRUE(cache.add_tree(bodies().a.add(tree_a)));
        EXPECT_TRUE(cache.add_tree(bodies().b.add(tree_b)));
    }
    void deliver(const SubtreeKey& key) {
        EXPECT_TRUE(cache.insert(key, bodies().open(key)));
        if (cache.has(key)) {
            fetcher.arrived(key);
        }
    }

    SubtreeCache cache;
    Fetcher fetcher;
};

TEST(Fetcher, AScenarioIsReadyWhenItsLastSubtreeIsHere) {
    Bench bench(unlimited);
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}, {tree_a, 3}, {tree_b, 2}});
    const Fetcher::Step first = bench.fetcher.advance();
    EXPECT_EQ(first.want, (Keys{{tree_a, 0}, {tree_a, 3}, {tree_b, 2}}));
    EXPECT_TRUE(first.ready.empty());
    bench.deliver({tree_b, 2});
    bench.deliver({tree_a, 0});
    EXPECT_TRUE(bench.fetcher.advance().ready.empty());
    bench.deliver({tree_a, 3});
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{1});
    EXPECT_TRUE(bench.fetcher.advance().ready.empty());
}

TEST(Fetcher, AScenarioMayNeedUpperTrees) {
    Bench bench(1);
    const Keys tops{{tree_a, top_root}, {tree_b, top_root}};
    bench.fetcher.add(1, JobId{1}, tops);
    EXPECT_EQ(bench.fetcher.advance().want, tops);
    bench.deliver(tops[0]);
    EXPECT_TRUE(bench.fetcher.advance().ready.empty());
    bench.deliver(tops[1]);
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{1});
    bench.fetcher.finished(1);
    bench.fetcher.add(2, JobId{1}, tops);
    const Fetcher::Step again = bench.fetcher.advance();
    EXPECT_TRUE(again.want.empty());
    EXPECT_EQ(again.ready, Tokens{2});
}

TEST(Fetcher, ScenariosDoNotWaitForEachOther) {
    Bench bench(unlimited);
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}});
    bench.fetcher.add(2, JobId{1}, {{tree_a, 1}});
    bench.fetcher.add(3, JobId{1}, {});
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{3});
    bench.deliver({tree_a, 1});
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{2});
}

TEST(Fetcher, WhatIsHintedIsAskedForOnceAndWhenNothingIsNeeded) {
    Bench bench(unlimited);
    bench.deliver({tree_a, 2});
    bench.fetcher.hint({JobId{1}, {tree_a, 2}}); // Already present.
    bench.fetcher.hint({JobId{1}, {tree_a, 0}}); // Already requested by a scenario.
    bench.fetcher.hint({JobId{7}, {tree_a, 1}});
    bench.fetcher.hint({JobId{1}, {tree_a, 1}});
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}});
    const Fetcher::Step needed = bench.fetcher.advance();
    EXPECT_EQ(needed.want, (Keys{{tree_a, 0}}));
    EXPECT_TRUE(needed.hinted.empty());
    bench.deliver({tree_a, 0});
    const Fetcher::Step step = bench.fetcher.advance();
    EXPECT_EQ(step.ready, Tokens{1});
    EXPECT_EQ(step.want, (Keys{{tree_a, 1}}));
    ASSERT_EQ(step.hinted.size(), 1u);
    EXPECT_EQ(step.hinted[0].key, (SubtreeKey{tree_a, 1}));
    EXPECT_EQ(step.hinted[0].job, JobId{7});

    // A scenario that needs a hinted block waits for it and does not request it again.
    bench.fetcher.add(2, JobId{1}, {{tree_a, 1}});
    EXPECT_TRUE(bench.fetcher.advance().want.empty());
    bench.deliver({tree_a, 1});
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{2});
    EXPECT_TRUE(bench.fetcher.advance().hinted.empty());
}

TEST(Fetcher, AHintIsForgottenWhereSomethingWouldHaveToLeave) {
    Bench large(unlimited);
    large.deliver({tree_a, 0});
    Bench bench(large.cache.bytes() + large.cache.bytes_expected({tree_a, 1}));
    bench.deliver({tree_a, 0});
    bench.fetcher.hint({JobId{1}, {tree_a, 1}});
    bench.fetcher.hint({JobId{1}, {tree_a, 2}}); // The earlier block will take the room.
    EXPECT_EQ(bench.fetcher.advance().want, (Keys{{tree_a, 1}}));
    bench.fetcher.add(1, JobId{1}, {{tree_a, 2}}); // Only the hint needs room.
    EXPECT_EQ(bench.fetcher.advance().want, (Keys{{tree_a, 2}}));
}

TEST(Fetcher, AHintTakesTheRoomOfParkedTrees) {
    Bench bench(unlimited);
    bench.deliver({tree_a, 0});
    Bench full(bench.cache.bytes());
    full.deliver({tree_a, 0});
    full.cache.park(tree_a);
    full.fetcher.hint({JobId{1}, {tree_b, 1}});
    EXPECT_EQ(full.fetcher.advance().want, (Keys{{tree_b, 1}}));
}

TEST(Fetcher, AHintOfAParkedTreeIsForgotten) {
    Bench bench(unlimited);
    bench.fetcher.hint({JobId{1}, {tree_a, 0}});
    bench.fetcher.forget_requests(tree_a);
    bench.cache.park(tree_a);
    EXPECT_TRUE(bench.fetcher.advance().want.empty());
}

TEST(Fetcher, WhatIsUnderWayIsNotAskedForAgain) {
    Bench bench(unlimited);
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}, {tree_b, 0}});
    EXPECT_EQ(bench.fetcher.advance().want.size(), 2u);
    bench.fetcher.add(2, JobId{1}, {{tree_a, 0}, {tree_b, 1}});
    EXPECT_EQ(bench.fetcher.advance().want, (Keys{{tree_b, 1}}));
    bench.fetcher.finished(1); // The scenario is cancelled; its requests are in flight.
    bench.fetcher.add(3, JobId{1}, {{tree_b, 0}});
    EXPECT_TRUE(bench.fetcher.advance().want.empty());
    bench.deliver({tree_b, 0});
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{3});
}

TEST(Fetcher, AnAdmittedScenarioTellsWhatItFoundAndWhatIsAskedForBecauseOfIt) {
    Bench bench(unlimited);
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}, {tree_b, 0}});
    Fetcher::Step step = bench.fetcher.advance();
    ASSERT_EQ(step.admitted.size(), 1u);
    EXPECT_EQ(step.admitted[0].job, JobId{1});
    EXPECT_EQ(step.admitted[0].found, 0u);
    EXPECT_EQ(step.admitted[0].asked, (Keys{{tree_a, 0}, {tree_b, 0}}));
    bench.deliver({tree_a, 0});
    bench.fetcher.add(2, JobId{1}, {{tree_a, 0}, {tree_b, 0}, {tree_b, 1}});
    step = bench.fetcher.advance();
    ASSERT_EQ(step.admitted.size(), 1u);
    EXPECT_EQ(step.admitted[0].found, 1u);
    EXPECT_EQ(step.admitted[0].asked, (Keys{{tree_b, 1}})) << "the other is under way";
}

TEST(Fetcher, ATooSmallCacheStillRunsOneScenarioAfterTheOther) {
    Bench bench(1);
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}, {tree_a, 1}, {tree_b, 0}});
    bench.fetcher.add(2, JobId{1}, {{tree_a, 1}, {tree_b, 1}});
    const Fetcher::Step first = bench.fetcher.advance();
    EXPECT_EQ(first.want.size(), 3u) << "the second is not admitted yet";
    for (const SubtreeKey& key : first.want) {
        bench.deliver(key);
    }
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{1});
    EXPECT_NE(bench.cache.at({tree_a, 0}), nullptr);
    bench.fetcher.finished(1);
    EXPECT_EQ(bench.cache.take_evicted().size(), 3u);
    EXPECT_EQ(bench.fetcher.advance().want, (Keys{{tree_a, 1}, {tree_b, 1}}));
}

TEST(Fetcher, AParkedTreeLeavesTheOthersAlone) {
    Bench bench(unlimited);
    bench.fetcher.add(1, JobId{1}, {{tree_a, 0}, {tree_b, 0}});
    bench.fetcher.add(2, JobId{1}, {{tree_b, 1}});
    EXPECT_EQ(bench.fetcher.advance().want.size(), 3u);
    bench.fetcher.finished(1);
    bench.fetcher.forget_requests(tree_a);
    bench.cache.park(tree_a);
    bench.deliver({tree_a, 0}); // It was in flight.
    bench.deliver({tree_b, 1});
    EXPECT_EQ(bench.fetcher.advance().ready, Tokens{2});
    bench.fetcher.finished(2);
    EXPECT_EQ(bench.fetcher.size(), 0u);
}

/// Plays scenarios and random events, with a master that answers late and in any order.
class Random {
  public:
    explicit Random(std::uint64_t seed)
        : random_(seed), bench_(seed % 2 == 0 ? unlimited : 1 + random_() % 40'000) {}

    void run() {
        while (added_ < scenarios || bench_.fetcher.size() > 0) {
            ASSERT_TRUE(added_ < scenarios || !asked_.empty() || !running_.empty()) << "stuck";
            happen();
            settle();
        }
        EXPECT_EQ(was_ready_.size(), scenarios);
    }

  private:
    static constexpr std::uint64_t scenarios = 60;

    void happen() {
        const std::uint64_t what = random_() % 3;
        if (what == 0 && added_ < scenarios) {
            Keys keys;
            for (std::uint64_t i = random_() % 6; i > 0; --i) {
                keys.push_back({tree_a, root_of(bodies().a)});
                keys.push_back({tree_b, root_of(bodies().b)});
            }
            std::sort(keys.begin(), keys.end());
            keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
            roots_[++added_] = keys;
            bench_.fetcher.add(added_, JobId{1}, keys);
        } else if (what == 1 && !asked_.empty()) {
            bench_.deliver(take(asked_));
        } else if (what == 2 && !running_.empty()) {
            bench_.fetcher.finished(take(running_));
        }
    }

    void settle() {
        const Fetcher::Step step = bench_.fetcher.advance();
        for (const SubtreeKey& key : step.want) {
            ASSERT_EQ(bench_.cache.at(key), nullptr) << "asked for, though here";
            ASSERT_EQ(std::count(asked_.begin(), asked_.end(), key), 0) << "asked for twice";
            asked_.push_back(key);
        }
        for (const Fetcher::Token token : step.ready) {
            ASSERT_TRUE(was_ready_.insert(token).second) << "ready twice";
            running_.push_back(token);
        }
        for (const Fetcher::Token token : running_) {
            for (const SubtreeKey& key : roots_[token]) {
                ASSERT_NE(bench_.cache.at(key), nullptr) << "gone while in use";
            }
        }
    }

    RootIndex root_of(const CutBody& body) {
        return static_cast<RootIndex>(random_() % body.top.root_count());
    }
    template <class T>
    T take(std::vector<T>& values) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(random_() % values.size());
        const T value = *place;
        values.erase(place);
        return value;
    }

    std::mt19937_64 random_;
    Bench bench_;
    std::uint64_t added_ = 0;
    std::map<Fetcher::Token, Keys> roots_;
    Keys asked_;
    Tokens running_;
    std::set<Fetcher::Token> was_ready_;
};

TEST(Fetcher, EveryScenarioBecomesReadyOnceInAnyOrderOfEvents) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random(seed).run();
        if (HasFatalFailure()) {
            return;
        }
    }
}

TEST(Fetcher, ATopIsAskedForOnceAndStays) {
    Bench bench(1);
    EXPECT_TRUE(bench.fetcher.want_top(tree_b));
    EXPECT_FALSE(bench.fetcher.want_top(tree_b)) << "it is under way";
    bench.fetcher.add(1, JobId{1}, {{tree_a, 2}});
    EXPECT_EQ(bench.fetcher.advance().want, (Keys{{tree_a, 2}, {tree_b, top_root}}));
    EXPECT_TRUE(bench.fetcher.advance().want.empty());
    EXPECT_EQ(bench.fetcher.awaited(), (Keys{{tree_a, 2}, {tree_b, top_root}}));
    bench.deliver({tree_b, top_root});
    bench.deliver({tree_a, 2});
    bench.fetcher.finished(1);
    EXPECT_TRUE(bench.cache.has({tree_b, top_root})) << "whatever the limit";
    EXPECT_FALSE(bench.fetcher.want_top(tree_b));
    EXPECT_TRUE(bench.fetcher.awaited().empty());
    // A removed tree's request is forgotten, and repeated for the next tree of that id.
    EXPECT_TRUE(bench.fetcher.want_top(tree_a));
    bench.fetcher.forget_requests(tree_a);
    EXPECT_TRUE(bench.fetcher.advance().want.empty());
    EXPECT_TRUE(bench.fetcher.want_top(tree_a));
}

} // namespace
} // namespace cd::tests
