#include "client/job/job_motions.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/poses/made_poses.hpp"
#include "common/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::uint64_t poses_at_once = 4096;

Result<std::vector<PosePair>> read_all(PoseSource& poses) {
    std::vector<PosePair> keys;
    keys.reserve(poses.count());
    for (std::uint64_t first = 0; first < poses.count(); first += poses_at_once) {
        const auto scenarios =
            CD_TRY(poses.read(first, std::min(poses_at_once, poses.count() - first)));
        for (const Scenario& scenario : scenarios) {
            keys.push_back(scenario.poses);
        }
    }
    return keys;
}

/// Returns the labels of the motions from those of the poses, whose places `name` tells. Errors:
/// BadInput for times that do not rise.
Result<PoseLabels>
labels_of_motions(const PoseLabels& labels, std::size_t motions, const NameKey& name) {
    PoseLabels made = labels.slice(0, motions);
    for (std::size_t i = 0; i < motions && !labels.times.empty(); ++i) {
        if (!(labels.times[i] < labels.times[i + 1])) {
            return bad_input(name(i + 1) + ": the time " + exact_text(labels.times[i + 1]) +
                             " is not after " + exact_text(labels.times[i]) + " of " + name(i));
        }
        made.end_times.push_back(labels.times[i + 1]);
    }
    return made;
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

/// Returns how far motions change at most if their keys are rounded to a grid.
///
/// Rounding moves each component of a quaternion by at most 2^(bits-53), so q(tau) by at most
/// 2^(bits-52). |q(tau)| is at least cos(22.5 degrees), so the body turns by less than
/// 2^(bits-50.8) more or less. c(tau) moves by no more than its ends do, which `moved` covers.
BodyRadii moved_between(const RoundedKeys& rounded, const BodyRadii& radii) {
    const double turned = std::ldexp(1.0, static_cast<int>(rounded.bits) - 50);
    return {rounded.moved.a + turned * radii.a, rounded.moved.b + turned * radii.b};
}

/// Makes the motions between poses that have been read from `source`, which names their places.
Result<JobMotions> motions_between(const std::vector<PosePair>& given,
                                   const PoseSource& source,
                                   const PoseLabels& labels,
                                   const BodyRadii& radii,
                                   double resolution) {
    if (given.size() < 2) {
        return bad_input("there is one pose alone; a motion leads from one pose to the next, so "
                         "give two or more");
    }
    const NameKey name = [&](std::size_t key) { return source.place_of(key); };
    const auto rounded = CD_TRY(round_keys(given, radii, resolution, name));
    const std::size_t count = rounded.keys.size() - 1;
    JobMotions made;
    made.labels = CD_TRY(labels_of_motions(labels, count, name));
    made.moved = rounded.moved;
    made.moved_between = moved_between(rounded, radii);
    std::vector<Scenario> scenarios(count);
    for (std::size_t i = 0; i < count; ++i) {
        scenarios[i].index = i;
        scenarios[i].poses = rounded.keys[i];
        scenarios[i].to = rounded.keys[i + 1];
    }
    made.poses = make_list_source(std::move(scenarios));
    return made;
}

Error too_many_steps(double max_step) {
    return {ErrorCode::TooLarge,
            "steps of at most " + exact_text(max_step) + " take more than " +
                grouped(step_poses_max) +
                " poses; take larger steps, or [motion], which needs none"};
}

BodyRadii radii_of(const Mesh& a, const Mesh& b) {
    return {body_radius(a.vertices()), body_radius(b.vertices())};
}

} // namespace

Result<JobMotions> make_motions(
    PoseSource& poses, const PoseLabels& labels, const Mesh& a, const Mesh& b, double resolution) {
    const auto given = CD_TRY(read_all(poses));
    return motions_between(given, poses, labels, radii_of(a, b), resolution);
}

Result<InsertedPoses> make_steps(
    PoseSource& poses, const PoseLabels& labels, const Mesh& a, const Mesh& b, double max_step) {
    // A part of the time has a bound of half the way between the poses at its ends. An eighth of
    // the way is left for the rounding of the poses between which others are inserted.
    const double resolution = max_step * (7.0 / 16);
    const auto given = CD_TRY(read_all(poses));
    const BodyRadii radii = radii_of(a, b);
    auto made_motions = motions_between(given, poses, labels, radii, resolution);
    if (!made_motions && made_motions.error().code == ErrorCode::TooLarge) {
        return too_many_steps(max_step);
    }
    const auto motions = CD_TRY(std::move(made_motions));
    const double moved = motions.moved.a + motions.moved.b;
    if (!(moved <= max_step / 16)) {
        return bad_input("max_step = " + exact_text(max_step) +
                         " is too small: rounding moves the "
                         "bodies by up to " +
                         short_number(moved));
    }
    InsertedPoses made;
    std::vector<Scenario> scenarios;
    const auto add = [&](const PosePair& at, std::size_t motion, double tau) {
        scenarios.push_back({scenarios.size(), 0, 1, at});
        if (!motions.labels.end_times.empty()) {
            made.labels.times.push_back(motions.labels.time_at(motion, tau));
        }
    };
    for (std::size_t i = 0; i + 1 < given.size(); ++i) {
        const auto read = CD_TRY(motions.poses->read(i, 1));
        const Motion motion = CD_TRY(Motion::create(read[0].poses, *read[0].to, radii, resolution));
        const std::uint32_t parts = 1u << motion.depth();
        if (scenarios.size() + parts > step_poses_max) {
            return too_many_steps(max_step);
        }
        add(given[i], i, 0);
        for (std::uint32_t j = 1; j < parts; ++j) {
            add(motion.at(j, motion.depth()), i, std::ldexp(j, -static_cast<int>(motion.depth())));
        }
    }
    add(given.back(), given.size() - 2, 1);
    made.poses = make_list_source(std::move(scenarios));
    return made;
}

std::string moved_text(const BodyRadii& moved, const std::string& unit) {
    return "rounding moved the bodies by at most " + short_number(moved.a) + " and " +
           short_number(moved.b) + " " + unit;
}

} // namespace cd
