#include "common/scene/scene_poses.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Returns the number of pairs of so many bodies.
std::uint64_t pairs_among(std::uint64_t bodies) {
    return bodies < 2 ? 0 : bodies * (bodies - 1) / 2;
}

std::vector<std::uint32_t> fixed_bodies(const Scene& scene) {
    std::vector<std::uint32_t> fixed;
    for (std::uint32_t body = 0; body < scene.bodies.size(); ++body) {
        if (scene.bodies[body].is_fixed) {
            fixed.push_back(body);
        }
    }
    return fixed;
}

std::vector<std::uint32_t> present_bodies(const PosesOfStep& poses) {
    std::vector<std::uint32_t> present;
    for (std::uint32_t body = 0; body < poses.size(); ++body) {
        if (poses[body]) {
            present.push_back(body);
        }
    }
    return present;
}

} // namespace

ScenePoses::ScenePoses(Scene scene, std::unique_ptr<StepPoses> poses)
    : scene_(std::move(scene)), poses_(std::move(poses)), absences_(scene_.bodies.size(), 0) {
    CD_CHECK(scene_.ignored.bodies() == scene_.bodies.size());
    CD_CHECK(scene_.reach >= 0);
    const std::vector<std::uint32_t> fixed = fixed_bodies(scene_);
    ignored_pairs_ = scene_.ignored.count();
    fixed_pairs_ = pairs_among(fixed.size()) - scene_.ignored.count_among(fixed);
}

Result<std::unique_ptr<ScenePoses>>
ScenePoses::create(Scene scene, std::unique_ptr<StepPoses> poses, const StopCheck& stop) {
    std::unique_ptr<ScenePoses> made(new ScenePoses(std::move(scene), std::move(poses)));
    const Status counted = made->count_steps(stop);
    return counted ? Result(std::move(made)) : counted.error();
}

Status ScenePoses::count_steps(const StopCheck& stop) {
    StepIndex index;
    for (std::uint64_t number = 0; number < poses_->steps(); ++number) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto step = read_step(number);
        if (!step) {
            return step.error();
        }
        index.add_step(covered_by(step.value()));
        if (index.count() > limits::scenarios_max) {
            return Error{ErrorCode::TooLarge,
                         "the steps up to " + std::to_string(number) + " have " +
                             grouped(index.count()) + " pairs to test; a job has at most " +
                             grouped(limits::scenarios_max) +
                             ": test fewer steps, or ignore pairs by [rules]"};
        }
        for (std::size_t body = 0; body < absences_.size(); ++body) {
            absences_[body] += step.value().poses[body] ? 0 : 1;
        }
    }
    index.set_times(poses_->times());
    index_ = std::make_shared<const StepIndex>(std::move(index));
    return Done{};
}

StepCoverage ScenePoses::covered_by(const Step& step) const {
    const std::vector<std::uint32_t> present = present_bodies(step.poses);
    const std::uint64_t pairs = pairs_among(present.size());
    StepCoverage coverage;
    coverage.tested = step.pairs.size();
    coverage.absent = pairs_among(step.poses.size()) - pairs;
    coverage.ignored =
        present.size() == step.poses.size() ? ignored_pairs_ : scene_.ignored.count_among(present);
    coverage.fixed = step.number == 0 ? 0 : fixed_pairs_;
    coverage.apart = pairs - coverage.tested - coverage.ignored - coverage.fixed;
    return coverage;
}

Result<ScenePoses::Step> ScenePoses::read_step(std::uint64_t number) {
    auto poses = poses_->read(number);
    if (!poses) {
        return poses.error();
    }
    CD_CHECK(poses.value().size() == scene_.bodies.size());
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
        CD_CHECK(poses.value()[body] || !scene_.bodies[body].is_fixed);
    }
    std::vector<BodyPair> pairs = pairs_of(number, poses.value());
    return Step{number, std::move(poses.value()), std::move(pairs)};
}

std::vector<BodyPair> ScenePoses::pairs_of(std::uint64_t step, const PosesOfStep& poses) const {
    const std::vector<std::uint32_t> present = present_bodies(poses);
    std::vector<WorldBox> boxes;
    boxes.reserve(present.size());
    for (const std::uint32_t body : present) {
        // Of two points within reach, the middle is at most half the reach away from both. Halving
        // rounds only numbers far below the bounds of rounding errors in the box.
        boxes.push_back(world_box(scene_.bodies[body].box, *poses[body], 0.5 * scene_.reach));
    }
    std::vector<BodyPair> pairs;
    for (const BodyPair found : overlapping_pairs(boxes)) {
        const BodyPair pair{present[found.a], present[found.b]};
        if (is_tested(step, pair)) {
            pairs.push_back(pair);
        }
    }
    return pairs;
}

bool ScenePoses::is_tested(std::uint64_t step, BodyPair pair) const {
    const bool is_settled =
        step > 0 && scene_.bodies[pair.a].is_fixed && scene_.bodies[pair.b].is_fixed;
    return !is_settled && !scene_.ignored.has(pair);
}

Result<std::vector<Scenario>> ScenePoses::read(std::uint64_t first, std::uint64_t count) {
    CD_CHECK(first <= index_->count());
    CD_CHECK(count <= index_->count() - first);
    const std::lock_guard lock(mutex_);
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    while (scenarios.size() < count) {
        const std::uint64_t next = first + scenarios.size();
        const std::uint64_t number = index_->step_of(next);
        if (!kept_ || kept_->number != number) {
            auto step = read_step(number);
            if (!step) {
                return step.error();
            }
            kept_ = std::move(step.value());
        }
        if (kept_->pairs.size() != index_->end_of(number) - index_->first_of(number)) {
            return Error{ErrorCode::Io, "the poses have changed since they were first read"};
        }
        const std::uint64_t end = std::min(index_->end_of(number), first + count);
        for (std::uint64_t index = next; index < end; ++index) {
            const BodyPair pair = kept_->pairs[index - index_->first_of(number)];
            scenarios.push_back(
                {index, pair.a, pair.b, {*kept_->poses[pair.a], *kept_->poses[pair.b]}, number});
        }
    }
    return scenarios;
}

} // namespace cd
