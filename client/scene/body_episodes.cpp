#include "client/scene/body_episodes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cd {

namespace {

void sort_by_end(std::vector<BodyEpisode>& episodes) {
    std::ranges::sort(episodes, [](const BodyEpisode& left, const BodyEpisode& right) {
        return std::tie(left.last_step, left.bodies) < std::tie(right.last_step, right.bodies);
    });
}

} // namespace

EpisodeSum::EpisodeSum(std::shared_ptr<const StepIndex> steps, std::vector<bool> are_fixed)
    : steps_(std::move(steps)), are_fixed_(std::move(are_fixed)) {}

std::vector<BodyEpisode> EpisodeSum::add(const ScenarioResult& result) {
    const std::uint64_t step = steps_->step_of(result.index);
    std::vector<BodyEpisode> ended;
    if (step != step_) {
        ended = take_ended(step);
        step_ = step;
    }
    if (is_hit(result.kind)) {
        add_hit(result, step);
    }
    return ended;
}

std::vector<BodyEpisode> EpisodeSum::finish() {
    return take_ended(UINT64_MAX);
}

/// Takes the episodes that cannot go on at `step`.
std::vector<BodyEpisode> EpisodeSum::take_ended(std::uint64_t step) {
    std::vector<BodyEpisode> ended;
    std::erase_if(open_, [&](const auto& entry) {
        const bool has_ended = entry.second.last_step + 1 < step;
        if (has_ended) {
            ended.push_back(entry.second);
        }
        return has_ended;
    });
    sort_by_end(ended);
    return ended;
}

void EpisodeSum::add_hit(const ScenarioResult& result, std::uint64_t step) {
    const BodyPair bodies{result.body_a, result.body_b};
    const bool are_fixed = are_fixed_[bodies.a] && are_fixed_[bodies.b];
    BodyEpisode& episode =
        open_.try_emplace(bodies, BodyEpisode{bodies, step, step, {}, result.kind, result.index})
            .first->second;
    episode.last_step = are_fixed ? steps_->steps() - 1 : step;
    if (const Badness badness = badness_of(result); badness > episode.badness) {
        episode.badness = badness;
        episode.worst = result.kind;
        episode.worst_scenario = result.index;
    }
}

} // namespace cd
