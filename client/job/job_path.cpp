#include "client/job/job_path.hpp"

#include "client/job/job_motions.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// Names the poses in errors about their order.
std::string place_of_poses(const PosesSpec& poses) {
    const auto* const file = std::get_if<PoseFileSpec>(&poses);
    if (file == nullptr) {
        return "the curve: ";
    }
    return file->path == "-" ? "standard input: " : file->path.string() + ": ";
}

/// Returns how far keys may be from a curve: the job's chord, or else an eighth of the length by
/// which motions or poses are resolved.
double off_curve_max(const JobSpec& spec) {
    const double usual = spec.query.motion ? spec.query.motion->resolution : *spec.max_step;
    return spec.chord.value_or(usual / 8);
}

/// Refuses a chord that does not cover the rounding of the keys as well (`keys_along`).
Status check_chord(const JobSpec& spec, const JobMotions& motions) {
    const double moved = motions.moved_between.a + motions.moved_between.b;
    if (!spec.chord || moved <= grid_share * *spec.chord) {
        return Done{};
    }
    const std::string place = spec.file.empty() ? "" : spec.file.string() + ": ";
    return bad_input(place + "[motion]: chord = " + exact_text(*spec.chord) +
                     " is too small, since rounding of the keys moves the bodies by up to " +
                     exact_text(moved) + "; make it at least " + exact_text(moved / grid_share));
}

/// Inserts poses between those of a job.
Status make_steps(PreparedJob& job, double max_step) {
    auto made = CD_TRY(
        within(place_of_poses(job.spec.poses),
               make_steps(*job.poses, job.labels, *job.meshes[0], *job.meshes[1], max_step)));
    job.poses = std::move(made.poses);
    job.labels = std::move(made.labels);
    return Done{};
}

/// Replaces the poses of a job by the motions from each to the next.
Status make_motions(PreparedJob& job, const MotionQuery& motion) {
    const std::string place = place_of_poses(job.spec.poses);
    auto made = CD_TRY(within(
        place,
        make_motions(*job.poses, job.labels, *job.meshes[0], *job.meshes[1], motion.resolution)));
    CD_TRY(check_chord(job.spec, made));
    job.poses = std::move(made.poses);
    job.labels = std::move(made.labels);
    job.warnings.push_back("note: keys of motions are rounded to a grid: " +
                           moved_text(made.moved, job.spec.unit));
    return Done{};
}

} // namespace

Status make_keys(PreparedJob& job, const CurveSpec& curve) {
    const double off_max = off_curve_max(job.spec);
    auto keys =
        CD_TRY(within(place_of_poses(job.spec.poses),
                      keys_along(curve.phases, body_radius(job.meshes[1]->vertices()), off_max)));
    std::vector<Scenario> scenarios(keys.poses.size());
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = keys.poses[i];
    }
    job.poses = make_list_source(std::move(scenarios));
    job.labels.times = std::move(keys.times);
    job.warnings.push_back("note: " + counted(job.poses->count(), "key") +
                           " of the curve, within " + exact_text(off_max) + " " + job.spec.unit +
                           (job.spec.chord ? ", by which the clearance grows" : " of it"));
    return Done{};
}

Status make_path(PreparedJob& job) {
    if (job.query.motion) {
        return make_motions(job, *job.query.motion);
    }
    return job.spec.max_step ? make_steps(job, *job.spec.max_step) : Done{};
}

double with_chord(double clearance, double chord) {
    const double sum = clearance + chord;
    const double larger = std::max(clearance, chord);
    // Exact: Dekker, A floating-point technique (1971), section 4.
    const bool is_below = sum - larger < std::min(clearance, chord);
    return is_below ? std::nextafter(sum, std::numeric_limits<double>::infinity()) : sum;
}

} // namespace cd
