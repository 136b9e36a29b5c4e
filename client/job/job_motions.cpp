#include "client/job/job_motions.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/poses/made_poses.hpp"

#include <algorithm>
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

Result<JobMotions> make_motions(PoseSource& poses,
                                const PoseLabels& labels,
                                const Mesh& a,
                                const Mesh& b,
                                double resolution) {
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

std::string moved_text(const BodyRadii& moved, const std::string& unit) {
    return "rounding moved the bodies by at most " + short_number(moved.a) + " and " +
           short_number(moved.b) + " " + unit;
}

} // namespace cd
