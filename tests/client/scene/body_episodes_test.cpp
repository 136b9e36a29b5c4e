// Proves that episodes are the runs of steps at which a pair is in contact, against a table of all
// pairs and steps.
#include "client/scene/body_episodes.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace cd::tests {

namespace {

constexpr std::uint32_t bodies = 4;
constexpr std::uint64_t steps = 12;

/// What happens to a pair at a step; nothing: it is not tested.
using Fate = std::optional<ScenarioResult>;

ScenarioResult random_result(std::mt19937_64& random) {
    ScenarioResult result;
    constexpr std::array kinds{ScenarioClass::Separate,
                               ScenarioClass::Touch,
                               ScenarioClass::Cross,
                               ScenarioClass::Near,
                               ScenarioClass::Failed};
    result.kind = kinds.at(random() % kinds.size());
    result.pair_count = is_contact(result.kind) ? 1 + random() % 3 : 0;
    return result;
}

struct RandomEpisodes {
    std::shared_ptr<StepIndex> index = std::make_shared<StepIndex>();
    std::vector<ScenarioResult> results;
    std::map<BodyPair, std::vector<Fate>> fates; ///< By step.
    std::vector<bool> are_fixed{true, true, false, false};
};

RandomEpisodes random_episodes(std::mt19937_64& random) {
    RandomEpisodes made;
    for (std::uint64_t step = 0; step < steps; ++step) {
        const std::size_t before = made.results.size();
        for (std::uint32_t a = 0; a < bodies; ++a) {
            for (std::uint32_t b = a + 1; b < bodies; ++b) {
                std::vector<Fate>& fates = made.fates[{a, b}];
                const bool are_fixed = made.are_fixed[a] && made.are_fixed[b];
                fates.emplace_back();
                if ((are_fixed && step > 0) || random() % 3 == 0) {
                    continue;
                }
                ScenarioResult result = random_result(random);
                result.index = made.results.size();
                result.body_a = a;
                result.body_b = b;
                made.results.push_back(result);
                fates.back() = result;
            }
        }
        made.index->add_step({made.results.size() - before});
    }
    return made;
}

/// The episodes of a pair, by the definition.
std::vector<BodyEpisode>
episodes_of(const std::vector<Fate>& fates, BodyPair pair, bool are_fixed) {
    std::vector<BodyEpisode> episodes;
    bool is_open = false;
    for (std::uint64_t step = 0; step < fates.size(); ++step) {
        const bool is_hit_here = fates[step] && is_hit(fates[step]->kind);
        if (is_hit_here && !is_open) {
            episodes.push_back({pair, step, step, {}, {}, 0});
        }
        is_open = is_hit_here;
        if (is_hit_here) {
            BodyEpisode& episode = episodes.back();
            episode.last_step = are_fixed ? steps - 1 : step;
            if (badness_of(*fates[step]) > episode.badness) {
                episode.badness = badness_of(*fates[step]);
                episode.worst = fates[step]->kind;
                episode.worst_scenario = fates[step]->index;
            }
        }
    }
    return episodes;
}

std::vector<BodyEpisode> expected_of(const RandomEpisodes& made) {
    std::vector<BodyEpisode> expected;
    for (const auto& [pair, fates] : made.fates) {
        const auto episodes =
            episodes_of(fates, pair, made.are_fixed[pair.a] && made.are_fixed[pair.b]);
        expected.insert(expected.end(), episodes.begin(), episodes.end());
    }
    std::ranges::sort(expected, [](const BodyEpisode& left, const BodyEpisode& right) {
        return std::tie(left.last_step, left.bodies) < std::tie(right.last_step, right.bodies);
    });
    return expected;
}

} // namespace

TEST(EpisodeSum, HasTheRunsOfStepsInContactInTheOrderOfTheirEnds) {
    std::size_t count = 0;
    for (SeededRandom random : seeds(raised(100))) {
        const RandomEpisodes made = random_episodes(random);
        EpisodeSum sum(made.index, made.are_fixed);
        std::vector<BodyEpisode> found;
        for (const ScenarioResult& result : made.results) {
            const auto ended = sum.add(result);
            found.insert(found.end(), ended.begin(), ended.end());
        }
        const auto rest = sum.finish();
        found.insert(found.end(), rest.begin(), rest.end());
        EXPECT_EQ(found, expected_of(made));
        count += found.size();
    }
    EXPECT_GT(count, 500u);
}

TEST(EpisodeSum, GivesAnEpisodeOnceItHasEnded) {
    const auto index = std::make_shared<StepIndex>();
    for (int step = 0; step < 3; ++step) {
        index->add_step({1});
    }
    EpisodeSum sum(index, {false, false, false});
    ScenarioResult result;
    result.kind = ScenarioClass::Touch;
    EXPECT_TRUE(sum.add(result).empty());
    result.index = 1;
    result.body_b = 2;
    EXPECT_TRUE(sum.add(result).empty()) << "the first pair may touch at step 1, too";
    result.index = 2;
    const auto ended = sum.add(result);
    ASSERT_EQ(ended.size(), 1u);
    EXPECT_EQ(ended[0].bodies, (BodyPair{0, 1}));
    const auto rest = sum.finish();
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].first_step, 1u);
    EXPECT_EQ(rest[0].last_step, 2u);
}

} // namespace cd::tests
