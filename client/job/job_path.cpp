#include "client/job/job_path.hpp"

#include "client/job/job_motions.hpp"
#include "client/poses/chord_check.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// Names the poses in errors about their order: their file, or the curve's line of the job file.
std::string place_of_poses(const JobSpec& spec) {
    if (const auto* const curve = std::get_if<CurveSpec>(&spec.poses)) {
        const std::string key = curve->text.substr(0, curve->text.find(' '));
        return error_at_key(spec, key, "[poses] " + key + ": ").detail;
    }
    const auto* const file = std::get_if<PoseFileSpec>(&spec.poses);
    if (file == nullptr) {
        return "the poses: ";
    }
    return file->path == "-" ? "standard input: " : file->path.string() + ": ";
}

/// Returns how far keys may be from a curve: the job's chord, or else an eighth of the length by
/// which motions or poses are resolved.
double off_curve_max(const JobSpec& spec) {
    const double usual = spec.query.motion ? spec.query.motion->resolution : *spec.max_step;
    return spec.chord.value_or(usual / 8);
}

/// Keys that were made from a file's rows. An error names a key by the row where its curve starts.
class KeySource final : public PoseSource {
  public:
    KeySource(std::vector<Scenario> keys, std::vector<std::string> places)
        : keys_(make_list_source(std::move(keys))), places_(std::move(places)) {}

    [[nodiscard]] std::uint64_t count() const override { return keys_->count(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        return keys_->read(first, count);
    }
    [[nodiscard]] std::string place_of(std::uint64_t scenario) const override {
        return places_[scenario];
    }

  private:
    std::unique_ptr<PoseSource> keys_;
    std::vector<std::string> places_; ///< By scenario.
};

/// Returns the rows of a job's poses, each with its rates: of B, or of A and B.
Result<std::vector<KeyRow>> rows_of(PreparedJob& job, const std::vector<PoseRates>& rates) {
    const auto scenarios = CD_TRY(job.poses->read(0, job.poses->count()));
    const std::size_t each = rates.size() / scenarios.size();
    std::vector<KeyRow> rows(scenarios.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].time = job.labels.times.empty() ? static_cast<double>(i) : job.labels.times[i];
        rows[i].poses = scenarios[i].poses;
        rows[i].rates[1] = rates[each * i + each - 1];
        if (each == 2) {
            rows[i].rates[0] = rates[2 * i];
        }
    }
    return rows;
}

std::string keys_note(const PreparedJob& job, double off_max) {
    return "note: " + counted(job.poses->count(), "key") + " of the curve, within " +
           exact_text(off_max) + " " + job.spec.unit +
           (job.spec.chord ? ", by which the clearance grows" : " of it");
}

/// Inserts poses between those of a job.
Status make_steps(PreparedJob& job, double max_step) {
    auto made = CD_TRY(
        within(place_of_poses(job.spec),
               make_steps(*job.poses, job.labels, *job.meshes[0], *job.meshes[1], max_step)));
    job.poses = std::move(made.poses);
    job.labels = std::move(made.labels);
    return Done{};
}

/// Replaces the poses of a job by the motions from each to the next.
Status make_motions(PreparedJob& job, const MotionQuery& motion) {
    const std::string place = place_of_poses(job.spec);
    auto made = CD_TRY(within(
        place,
        make_motions(*job.poses, job.labels, *job.meshes[0], *job.meshes[1], motion.resolution)));
    CD_TRY(check_chord(job.spec, made.moved_between.a + made.moved_between.b));
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
        CD_TRY(within(place_of_poses(job.spec),
                      keys_along(curve.phases, body_radius(job.meshes[1]->vertices()), off_max)));
    std::vector<Scenario> scenarios(keys.poses.size());
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = keys.poses[i];
    }
    job.poses = make_list_source(std::move(scenarios));
    job.labels.times = std::move(keys.times);
    job.warnings.push_back(keys_note(job, off_max));
    return Done{};
}

Status make_row_keys(PreparedJob& job, const std::vector<PoseRates>& rates) {
    const std::string place = place_of_poses(job.spec);
    if (rates.empty()) {
        return job.spec.chord
                   ? error_at_key(job.spec, "chord", "[motion]: " + std::string(chord_use))
                   : Status(Done{});
    }
    if (!job.query.motion && !job.spec.max_step) {
        job.warnings.push_back("note: " + place +
                               "its velocities count with [motion] or max_step "
                               "alone; poses are tested as they are");
        return Done{};
    }
    const double off_max = off_curve_max(job.spec);
    const BodyRadii radii{body_radius(job.meshes[0]->vertices()),
                          body_radius(job.meshes[1]->vertices())};
    const auto rows = CD_TRY(rows_of(job, rates));
    const auto name = [&](std::size_t row) { return job.poses->place_of(row); };
    auto keys =
        CD_TRY(within(place, keys_between(rows, radii, rates.size() / rows.size(), off_max, name)));
    std::vector<Scenario> scenarios(keys.poses.size());
    std::vector<std::string> places;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses = keys.poses[i];
        places.push_back(name(keys.rows[i]));
    }
    job.poses = std::make_unique<KeySource>(std::move(scenarios), std::move(places));
    job.labels = {};
    job.labels.times = std::move(keys.times);
    job.warnings.push_back(keys_note(job, off_max));
    return Done{};
}

Status make_path(PreparedJob& job) {
    if (job.query.motion) {
        return make_motions(job, *job.query.motion);
    }
    return job.spec.max_step ? make_steps(job, *job.spec.max_step) : Done{};
}

} // namespace cd
