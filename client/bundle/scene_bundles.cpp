#include "client/bundle/scene_bundles.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t steps_kept = 2;

/// A box by its middle and its half size.
struct MiddleBox {
    Vec3 middle;
    Vec3 half;
};

/// Returns a box, in the axes to which `to_axes` turns the world, that holds a posed one. It grows
/// by far more than all roundings of poses, turns and sums of such numbers, which are below 2^-45
/// of them.
MiddleBox box_in_axes(const Aabb& box, const Pose& pose, const Mat3& to_axes, double magnitude) {
    constexpr double slack = 1.0 / (1 << 30);
    const Mat3 turn = pose.rotation();
    const Mat3 whole = to_axes * turn;
    const Vec3 middle = turn * box.center();
    const Vec3 half = whole.cwiseAbs() * (0.5 * box.size());
    const double largest = turn.cwiseAbs().sum() * box.center().cwiseAbs().maxCoeff() +
                           pose.translation().cwiseAbs().maxCoeff() + half.maxCoeff() + magnitude;
    return {to_axes * (middle + pose.translation()), half + Vec3::Constant(slack * largest)};
}

/// A number that is no number keeps no boxes apart.
bool are_apart(const MiddleBox& a, const MiddleBox& b) {
    return ((a.middle - b.middle).cwiseAbs().array() > (a.half + b.half).array()).any();
}

/// Adds the corners of a posed box to another in the world.
void add_posed(const Aabb& box, const Pose& pose, Aabb& world) {
    for (unsigned corner = 0; corner < 8; ++corner) {
        world.add(pose.apply({(corner & 1) != 0 ? box.max.x() : box.min.x(),
                              (corner & 2) != 0 ? box.max.y() : box.min.y(),
                              (corner & 4) != 0 ? box.max.z() : box.min.z()}));
    }
}

} // namespace

Result<Aabb> box_of_steps(const LineTargets& targets, StepPoses& poses, const StopCheck& stop) {
    Aabb world;
    for (std::uint64_t step = 0; step < poses.steps(); ++step) {
        if (stop && stop()) {
            return interrupted();
        }
        const PosesOfStep at = CD_TRY(poses.read(step));
        for (std::size_t body = 0; body < at.size(); ++body) {
            if (at[body] && !targets.are_ignored[body]) {
                add_posed(targets.bodies[body].box, *at[body], world);
            }
        }
    }
    if (world.is_empty()) {
        return bad_input("no body that lines may hit is there at any step");
    }
    return world;
}

SceneBundles::SceneBundles(LineTargets targets,
                           StandingBundles bundles,
                           std::unique_ptr<StepPoses> poses)
    : targets_(std::move(targets)),
      bundles_(std::move(bundles)),
      poses_(std::move(poses)),
      absences_(targets_.bodies.size(), 0) {
    CD_CHECK(targets_.are_ignored.size() == targets_.bodies.size());
    CD_CHECK(!bundles_.poses.empty());
    for (std::uint32_t i = 0; i < bundles_.poses.size(); ++i) {
        const BundlePose& bundle = bundles_.poses[i];
        if (i == 0 || bundle.view != bundles_.poses[i - 1].view) {
            directions_.push_back({bundle.pose.rotation().transpose(), i, {}});
        }
        Direction& direction = directions_.back();
        direction.origins.emplace_back(direction.to_axes * bundle.pose.translation());
    }
}

Result<std::unique_ptr<SceneBundles>> SceneBundles::create(LineTargets targets,
                                                           StandingBundles bundles,
                                                           std::unique_ptr<StepPoses> poses,
                                                           const StopCheck& stop) {
    std::unique_ptr<SceneBundles> made(
        new SceneBundles(std::move(targets), std::move(bundles), std::move(poses)));
    CD_TRY(made->count_steps(stop));
    return made;
}

Status SceneBundles::count_steps(const StopCheck& stop) {
    StepIndex index;
    for (std::uint64_t number = 0; number < poses_->steps(); ++number) {
        if (stop && stop()) {
            return interrupted();
        }
        const Step step = CD_TRY(read_step(number));
        index.add_step(covered_by(step));
        if (index.count() > limits::scenarios_max) {
            return Error{ErrorCode::TooLarge,
                         "the steps up to " + std::to_string(number) + " have " +
                             grouped(index.count()) +
                             " pairs of a body and a bundle of lines; a job has at most " +
                             grouped(limits::scenarios_max) +
                             ": test fewer steps or directions, or larger tiles"};
        }
        for (std::size_t body = 0; body < absences_.size(); ++body) {
            absences_[body] += step.poses[body] ? 0 : 1;
        }
    }
    index.set_times(poses_->times());
    index_ = std::make_shared<const StepIndex>(std::move(index));
    return Done{};
}

StepCoverage SceneBundles::covered_by(const Step& step) const {
    const std::uint64_t bundles = bundles_.poses.size();
    StepCoverage coverage;
    for (std::size_t body = 0; body < step.poses.size(); ++body) {
        std::uint64_t& pairs = !step.poses[body]            ? coverage.absent
                               : targets_.are_ignored[body] ? coverage.ignored
                                                            : coverage.apart;
        pairs += bundles;
    }
    coverage.tested = step.meetings.size();
    coverage.apart -= coverage.tested;
    return coverage;
}

Result<SceneBundles::Step> SceneBundles::read_step(std::uint64_t number) {
    Step step;
    step.number = number;
    step.poses = CD_TRY(poses_->read(number));
    CD_CHECK(step.poses.size() == targets_.bodies.size());
    for (const Direction& direction : directions_) {
        add_meetings(direction, step);
    }
    return step;
}

void SceneBundles::add_meetings(const Direction& direction, Step& step) const {
    const Vec3 middle = bundles_.lines.center();
    const Vec3 half = 0.5 * bundles_.lines.size();
    double magnitude = middle.cwiseAbs().maxCoeff() + half.maxCoeff();
    for (const Vec3& origin : direction.origins) {
        magnitude = std::max(magnitude, origin.cwiseAbs().maxCoeff());
    }
    std::vector<std::pair<std::uint32_t, MiddleBox>> boxes;
    for (std::uint32_t body = 0; body < step.poses.size(); ++body) {
        if (step.poses[body] && !targets_.are_ignored[body]) {
            boxes.emplace_back(body,
                               box_in_axes(targets_.bodies[body].box,
                                           *step.poses[body],
                                           direction.to_axes,
                                           4 * magnitude));
        }
    }
    for (std::uint32_t i = 0; i < direction.origins.size(); ++i) {
        const MiddleBox lines{middle + direction.origins[i], half};
        for (const auto& [body, box] : boxes) {
            if (!are_apart(box, lines)) {
                step.meetings.push_back({body, direction.first + i});
            }
        }
    }
}

/// Returns a step that exists; valid until the next call.
Result<const SceneBundles::Step*> SceneBundles::find_step(std::uint64_t number) {
    const auto known = std::ranges::find(kept_, number, &Step::number);
    if (known != kept_.end()) {
        return &*known;
    }
    auto step = CD_TRY(read_step(number));
    if (step.meetings.size() != index_->end_of(number) - index_->first_of(number)) {
        return Error{ErrorCode::Io, "the poses have changed since they were first read"};
    }
    if (kept_.size() == steps_kept) {
        kept_.pop_front();
    }
    kept_.push_back(std::move(step));
    return &kept_.back();
}

Scenario SceneBundles::scenario_of(const Step& step, std::uint64_t index) const {
    const auto [body, bundle] = step.meetings[index - index_->first_of(step.number)];
    return {index,
            body,
            static_cast<std::uint32_t>(targets_.bodies.size()),
            {*step.poses[body], bundles_.poses[bundle].pose},
            step.number * bundles_.poses.size() + bundle};
}

Result<std::vector<Scenario>> SceneBundles::read(std::uint64_t first, std::uint64_t count) {
    CD_CHECK(first <= index_->count());
    CD_CHECK(count <= index_->count() - first);
    const std::lock_guard lock(mutex_);
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    while (scenarios.size() < count) {
        const std::uint64_t next = first + scenarios.size();
        const Step* const step = CD_TRY(find_step(index_->step_of(next)));
        const std::uint64_t end = std::min(index_->end_of(step->number), first + count);
        for (std::uint64_t index = next; index < end; ++index) {
            scenarios.push_back(scenario_of(*step, index));
        }
    }
    return scenarios;
}

} // namespace cd
