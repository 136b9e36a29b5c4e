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

/// Returns the labels of the motions from those of the poses. Errors: BadInput for times that do
/// not rise.
Result<PoseLabels> labels_of_motions(const PoseLabels& labels, std::size_t motions) {
    PoseLabels made = labels.slice(0, motions);
    for (std::size_t i = 0; i < motions && !labels.times.empty(); ++i) {
        if (!(labels.times[i] < labels.times[i + 1])) {
            return bad_input("key " + std::to_string(i + 1) + ": its time " +
                             exact_text(labels.times[i + 1]) + " is not after " +
                             exact_text(labels.times[i]) + " of the key before");
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

} // namespace

Result<JobMotions> make_motions(
    PoseSource& poses, const PoseLabels& labels, const Mesh& a, const Mesh& b, double resolution) {
    if (poses.count() < 2) {
        return bad_input("there is one pose alone; a motion leads from one pose to the next, so "
                         "give two or more");
    }
    const auto given = CD_TRY(read_all(poses));
    const BodyRadii radii{body_radius(a.vertices()), body_radius(b.vertices())};
    const auto rounded = CD_TRY(round_keys(given, radii, resolution));
    const std::size_t count = rounded.keys.size() - 1;
    JobMotions made;
    made.labels = CD_TRY(labels_of_motions(labels, count));
    made.moved = rounded.moved;
    std::vector<Scenario> scenarios(count);
    for (std::size_t i = 0; i < count; ++i) {
        scenarios[i].index = i;
        scenarios[i].poses = rounded.keys[i];
        scenarios[i].to = rounded.keys[i + 1];
    }
    made.poses = make_list_source(std::move(scenarios));
    return made;
}

Result<InsertedPoses> make_steps(
    PoseSource& poses, const PoseLabels& labels, const Mesh& a, const Mesh& b, double max_step) {
    // A part of the time has a bound of half the way between the poses at its ends.
    const double resolution = max_step / 2;
    const auto motions = CD_TRY(make_motions(poses, labels, a, b, resolution));
    const BodyRadii radii{body_radius(a.vertices()), body_radius(b.vertices())};
    const std::uint64_t count = motions.poses->count();
    InsertedPoses made;
    std::vector<Scenario> scenarios;
    const auto add = [&](const PosePair& at, std::size_t motion, double tau) {
        scenarios.push_back({scenarios.size(), 0, 1, at});
        if (!motions.labels.end_times.empty()) {
            made.labels.times.push_back(motions.labels.time_at(motion, tau));
        }
    };
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto read = CD_TRY(motions.poses->read(i, 1));
        const Motion motion = CD_TRY(Motion::create(read[0].poses, *read[0].to, radii, resolution));
        const std::uint32_t parts = 1u << motion.depth();
        if (scenarios.size() + parts > step_poses_max) {
            return Error{ErrorCode::TooLarge,
                         "steps of at most " + exact_text(max_step) + " take more than " +
                             grouped(step_poses_max) +
                             " poses; take larger steps, or [motion], which needs none"};
        }
        for (std::uint32_t j = 0; j < parts; ++j) {
            add(motion.at(j, motion.depth()), i, std::ldexp(j, -static_cast<int>(motion.depth())));
        }
        if (i + 1 == count) {
            add(*read[0].to, i, 1);
        }
    }
    made.poses = make_list_source(std::move(scenarios));
    return made;
}

std::string moved_text(const BodyRadii& moved, const std::string& unit) {
    return "rounding moved the bodies by at most " + short_number(moved.a) + " and " +
           short_number(moved.b) + " " + unit;
}

} // namespace cd
