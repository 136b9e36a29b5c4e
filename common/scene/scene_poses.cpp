#include "common/scene/scene_poses.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"
#include "common/motion/motion.hpp"
#include "common/scene/scene_keys.hpp"
#include "common/scene/swept_box.hpp"
#include "common/scene/world_boxes.hpp"

#include <algorithm>
#include <string>
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

/// Takes the poses of bodies away that are absent at one of two steps.
void keep_common(PosesOfStep& from, PosesOfStep& to) {
    for (std::size_t body = 0; body < from.size(); ++body) {
        if (!from[body] || !to[body]) {
            from[body].reset();
            to[body].reset();
        }
    }
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
    CD_TRY(made->take_keys(stop));
    CD_TRY(made->count_steps(stop));
    return made;
}

/// With motions, replaces the poses by keys.
Status ScenePoses::take_keys(const StopCheck& stop) {
    if (!scene_.resolution) {
        return Done{};
    }
    if (poses_->steps() < 2) {
        return bad_input("there is one step alone; a motion leads from one step to the next, so "
                         "give poses for two or more");
    }
    auto keys =
        CD_TRY(SceneKeys::create(std::move(poses_), scene_.bodies, *scene_.resolution, stop));
    moved_ = keys->moved();
    moved_between_ = keys->moved_between();
    poses_ = std::move(keys);
    return Done{};
}

Status ScenePoses::count_steps(const StopCheck& stop) {
    StepIndex index;
    const std::uint64_t steps = poses_->steps() - (scene_.resolution ? 1 : 0);
    for (std::uint64_t number = 0; number < steps; ++number) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto step = read_step(number);
        if (!step) {
            return step.error();
        }
        CD_TRY(check_motions(step.value()));
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

/// Refuses motions that would need more halvings than any may have.
Status ScenePoses::check_motions(const Step& step) const {
    if (!scene_.resolution) {
        return Done{};
    }
    for (const BodyPair pair : step.pairs) {
        const PlacedBody& a = scene_.bodies[pair.a];
        const PlacedBody& b = scene_.bodies[pair.b];
        const auto depth = motion_depth({*step.poses[pair.a], *step.poses[pair.b]},
                                        {*step.to[pair.a], *step.to[pair.b]},
                                        {a.radius, b.radius},
                                        *scene_.resolution);
        if (!depth) {
            return Error{depth.error().code,
                         "step " + std::to_string(step.number) + ": " + a.name + " and " + b.name +
                             ": " + depth.error().detail};
        }
    }
    return Done{};
}

Result<ScenePoses::Step> ScenePoses::read_step(std::uint64_t number) {
    Step step;
    step.number = number;
    step.poses = CD_TRY(poses_->read(number));
    CD_CHECK(step.poses.size() == scene_.bodies.size());
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
        CD_CHECK(step.poses[body] || !scene_.bodies[body].is_fixed);
    }
    if (scene_.resolution) {
        step.to = CD_TRY(poses_->read(number + 1));
        keep_common(step.poses, step.to);
    }
    step.pairs = CD_TRY(pairs_of(step));
    return step;
}

Result<std::vector<WorldBox>> ScenePoses::boxes_of(const Step& step,
                                                   std::span<const std::uint32_t> bodies) const {
    // Of two points within reach, the middle is at most half the reach away from both. Halving
    // rounds only numbers far below the bounds of rounding errors in the box.
    const double margin = 0.5 * scene_.reach;
    if (step.to.empty()) {
        WorldBoxes boxes(bodies.size());
        for (const std::uint32_t body : bodies) {
            boxes.add(scene_.bodies[body].box, *step.poses[body], margin);
        }
        return boxes.take();
    }
    std::vector<WorldBox> boxes;
    boxes.reserve(bodies.size());
    for (const std::uint32_t body : bodies) {
        const PlacedBody& placed = scene_.bodies[body];
        const BodyPath path = CD_TRY(path_between(*step.poses[body], *step.to[body]));
        boxes.push_back(swept_box({placed.box, placed.radius, path}, margin));
    }
    return boxes;
}

Result<std::vector<BodyPair>> ScenePoses::pairs_of(const Step& step) const {
    const std::vector<std::uint32_t> present = present_bodies(step.poses);
    const std::vector<WorldBox> boxes = CD_TRY(boxes_of(step, present));
    std::vector<std::uint8_t> is_settled; // Step 0 tests the pairs of fixed bodies for all steps.
    for (std::size_t i = 0; i < present.size() && step.number > 0; ++i) {
        is_settled.push_back(scene_.bodies[present[i]].is_fixed ? 1 : 0);
    }
    std::vector<BodyPair> pairs;
    for (const BodyPair found : overlapping_pairs(boxes, is_settled)) {
        const BodyPair pair{present[found.a], present[found.b]};
        if (!scene_.ignored.has(pair)) {
            pairs.push_back(pair);
        }
    }
    return pairs;
}

Scenario ScenePoses::scenario_of(const Step& step, std::uint64_t index) const {
    const BodyPair pair = step.pairs[index - index_->first_of(step.number)];
    Scenario scenario{
        index, pair.a, pair.b, {*step.poses[pair.a], *step.poses[pair.b]}, step.number};
    if (!step.to.empty()) {
        scenario.to = PosePair{*step.to[pair.a], *step.to[pair.b]};
    }
    return scenario;
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
            scenarios.push_back(scenario_of(*kept_, index));
        }
    }
    return scenarios;
}

} // namespace cd
