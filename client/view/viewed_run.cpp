#include "client/view/viewed_run.hpp"

#include "client/folder/folder_exports.hpp"
#include "client/folder/run_groups.hpp"
#include "client/groups/body_parts.hpp"
#include "client/remote/mesh_cache.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/version.hpp"
#include "common/core/words.hpp"
#include "common/geometry/closed_parts.hpp"
#include "web/server/cluster/cluster_jobs.hpp"
#include "web/server/scenario_repeat.hpp"
#include "web/server/scene/body_filter.hpp"
#include "web/server/scene/scene_rows.hpp"

#include <algorithm>
#include <ctime>
#include <map>
#include <span>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// Poses are read in parts of this many scenarios.
constexpr std::uint64_t poses_at_once = 4096;

/// Parses what `iso_time` writes; 0 for any other text.
std::uint64_t unix_seconds(const std::string& iso) {
    std::tm parts{};
    const char* const end = ::strptime(iso.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    const std::time_t time = end == nullptr ? 0 : ::timegm(&parts);
    return time < 0 ? 0 : static_cast<std::uint64_t>(time);
}

std::string where_text(const ManifestPlace& where) {
    return where.master.empty() ? counted(where.threads, "thread")
                                : counted(where.workers, "worker") + " of " + where.master;
}

RunView run_view(const RunManifest& manifest, const fs::path& dir) {
    return {where_text(manifest.where),
            manifest.where.simd,
            manifest.origin.command,
            manifest.origin.program,
            manifest.origin.commit,
            manifest.origin.started,
            manifest.origin.ended,
            manifest.formats,
            dir.string()};
}

/// Returns the axes of a grid of poses or of lines; none for other poses.
std::vector<GridAxis> axes_of(const PosesSpec& poses) {
    if (const auto* const grid = std::get_if<GridSpec>(&poses)) {
        return grid->axes;
    }
    const auto* const shots = std::get_if<ShotsSpec>(&poses);
    return shots != nullptr && shots->is_grid()
               ? std::vector<GridAxis>{shots->azimuth_deg, shots->elevation_deg}
               : std::vector<GridAxis>();
}

PosesView poses_view(const ManifestPoses& poses, const JobSpec& spec) {
    return {poses.kind,
            poses.count,
            poses.file,
            axes_of(spec.poses),
            poses.random,
            poses.labels.ids,
            poses.labels.times,
            poses.of_both_bodies};
}

/// Returns the names of a scene's bodies; empty for a job of two bodies.
std::span<const std::string> scene_names(const PreparedJob& job) {
    return job.scene ? job.names : std::span<const std::string>();
}

/// Names a part; in a scene, whose bodies have names, with its body.
std::string
part_name(std::span<const std::string> bodies, std::uint32_t body, const std::string& part) {
    return bodies.empty() ? part : bodies[body] + "/" + part;
}

/// `names` has the names of a scene's bodies.
GroupsView groups_view(const std::vector<Group>& groups,
                       std::uint64_t tested,
                       std::span<const std::string> names) {
    GroupsView view;
    view.total = groups.size();
    for (const Group& group :
         std::span(groups).first(std::min<std::size_t>(groups.size(), limits::page_groups_max))) {
        view.rows.push_back({part_name(names, group.body_a, group.part_a),
                             part_name(names, group.body_b, group.part_b),
                             group.scenarios,
                             static_cast<double>(group.scenarios) /
                                 static_cast<double>(std::max<std::uint64_t>(tested, 1)),
                             group.pairs,
                             group.worst,
                             group.worst_pairs,
                             group.kind,
                             group.near.pairs,
                             group.near.worst_pairs});
    }
    return view;
}

std::shared_ptr<const NamedParts> shared_runs(const BodyParts& parts) {
    return std::make_shared<const NamedParts>(parts.by_runs());
}

} // namespace

Result<std::unique_ptr<ViewedRun>> ViewedRun::open(OpenedRun& run,
                                                   const PreparedJob& job,
                                                   std::optional<ContactMap> map,
                                                   ThreadPool& pool,
                                                   const StopCheck& stop) {
    auto index = CD_TRY(RecordIndex::read(run.records(), job.poses->count(), pool, stop));
    std::unique_ptr<ViewedRun> viewed(new ViewedRun(run, job, std::move(index), std::move(map)));
    const Query& query = viewed->manifest().query;
    if (!job.scene && !query.maps && query.level >= Level::Pairs) {
        viewed->map_ = viewed->index_.map();
    }
    CD_TRY(viewed->sum_groups(stop));
    return viewed;
}

Status ViewedRun::sum_groups(const StopCheck& stop) {
    const Query& query = manifest().query;
    const PartKind kind = part_kind(query.level);
    if (!check_groups(query, map_)) {
        std::map<const Mesh*, std::shared_ptr<const NamedParts>> known;
        for (const auto& mesh : job_.meshes) {
            std::shared_ptr<const NamedParts>& parts = known[mesh.get()];
            parts = parts ? parts : shared_runs(BodyParts(*mesh, kind));
            parts_.push_back(parts);
        }
        return Done{};
    }
    auto begun = CD_TRY(begin_groups(query, {job_.meshes.begin(), job_.meshes.end()}, map_, kind));
    auto sum = CD_TRY(groups_of(run_.records(), std::move(begun), stop));
    for (std::uint32_t body = 0; body < job_.meshes.size(); ++body) {
        parts_.push_back(shared_runs(sum.parts(body)));
    }
    groups_ = groups_view(sum.groups(), index_.summary().tested(), scene_names(job_));
    return Done{};
}

fs::path ViewedRun::folder() const {
    std::error_code error;
    const fs::path path = fs::absolute(run_.dir(), error);
    return error ? run_.dir() : path;
}

double ViewedRun::seconds() const {
    const auto report = read_summary(run_.dir() / "summary.json");
    return report ? report.value().execution.seconds : 0;
}

JobRow ViewedRun::row(const std::string& id) const {
    const RunManifest& run = manifest();
    JobRow row{id, run.is_complete() ? "done" : "incomplete", {}};
    row.status.name = run.name;
    row.status.state = JobState::Done;
    row.status.summary = index_.summary();
    row.status.digest = run.outcome.digest;
    row.status.began = unix_seconds(run.origin.started);
    row.status.seconds = seconds();
    if (row.status.seconds > 0) {
        row.status.scenarios_per_second =
            static_cast<double>(index_.summary().merged()) / row.status.seconds;
    }
    return row;
}

JobView ViewedRun::view(const std::string& id) const {
    const RunManifest& run = manifest();
    JobView view{row(id), run.unit, run.query, {}, poses_view(run.poses, job_.spec), {}, {}, {}};
    for (std::size_t i = 0; i < run.bodies.size(); ++i) {
        view.bodies.push_back(body_view(run.bodies[i], *job_.trees[i]));
    }
    view.map = {map_.has_value(), run.query.maps ? 0 : run.query.limit_pairs};
    view.run = run_view(run, folder());
    view.groups = groups_;
    if (job_.scene) {
        view.steps = job_.scene->steps->steps();
        view.poses.of_both_bodies = true;
    }
    return view;
}

Result<std::vector<std::uint8_t>> ViewedRun::classes(const ScenarioChoice& choice) const {
    CD_TRY(choice.check(count(), limits::page_classes_max));
    std::vector<std::uint8_t> classes(choice.size());
    for (std::uint64_t i = 0; i < classes.size(); ++i) {
        classes[i] = index_.class_of(choice.at(i, count()));
    }
    return classes;
}

Result<std::vector<std::uint32_t>> ViewedRun::counts(const ScenarioChoice& choice) const {
    CD_TRY(choice.check(count(), limits::page_classes_max));
    std::vector<std::uint32_t> counts(choice.size());
    for (std::uint64_t i = 0; i < counts.size(); ++i) {
        counts[i] = index_.count_of(choice.at(i, count()));
    }
    return counts;
}

Result<std::vector<double>> ViewedRun::distances(const ScenarioChoice& choice) const {
    CD_TRY(choice.check(count(), limits::page_classes_max));
    std::vector<double> distances(choice.size());
    for (std::uint64_t i = 0; i < distances.size(); ++i) {
        distances[i] = index_.distance_of(choice.at(i, count()));
    }
    return distances;
}

Result<std::vector<Scenario>> ViewedRun::read_poses(std::uint64_t first, std::uint64_t count) {
    const std::scoped_lock lock(mutex_);
    return job_.poses->read(first, count);
}

Result<std::optional<KeptRecord>> ViewedRun::find_record(std::uint64_t scenario) {
    const std::scoped_lock lock(mutex_);
    const KeptRecord* const kept = CD_TRY(run_.records().find(scenario));
    return kept == nullptr ? std::nullopt : std::optional(*kept);
}

Result<PoseRows> ViewedRun::poses(const ScenarioChoice& choice) {
    CD_TRY(choice.check(count(), limits::page_scenarios_max));
    PoseRows rows{has_both_poses() ? std::size_t{2} : 1, {}};
    rows.numbers.reserve(12 * rows.poses_each * choice.size());
    CD_TRY(for_each_chosen(choice, [&](const std::vector<Scenario>& scenarios) -> Status {
        for (const Scenario& scenario : scenarios) {
            rows.add(scenario.poses);
        }
        return Done{};
    }));
    return rows;
}

Status ViewedRun::for_each_chosen(const ScenarioChoice& choice,
                                  const std::function<Status(const std::vector<Scenario>&)>& take) {
    const std::uint64_t step = choice.sample != 0 ? 1 : poses_at_once;
    for (std::uint64_t i = 0; i < choice.size(); i += step) {
        const std::uint64_t part = std::min(step, choice.size() - i);
        const auto scenarios = CD_TRY(read_poses(choice.at(i, count()), part));
        CD_TRY(take(scenarios));
    }
    return Done{};
}

Result<std::vector<MotionKeys>> ViewedRun::keys(const ScenarioChoice& choice) {
    CD_TRY(choice.check(count(), limits::page_scenarios_max));
    std::vector<MotionKeys> keys;
    CD_TRY(for_each_chosen(choice, [&](const std::vector<Scenario>& scenarios) -> Status {
        const auto some = CD_TRY(scene_motions(scenarios));
        keys.insert(keys.end(), some.begin(), some.end());
        return Done{};
    }));
    return keys;
}

Result<std::vector<ScenePlace>> ViewedRun::places(const ScenarioChoice& choice) {
    CD_TRY(choice.check(count(), limits::page_scenarios_max));
    if (!job_.scene) {
        return no_scene();
    }
    std::vector<ScenePlace> places;
    CD_TRY(for_each_chosen(choice, [&](const std::vector<Scenario>& scenarios) -> Status {
        const auto some = CD_TRY(scene_places(scenarios, *job_.scene->steps));
        places.insert(places.end(), some.begin(), some.end());
        return Done{};
    }));
    return places;
}

Result<std::vector<StepRow>> ViewedRun::steps(const ScenarioChoice& choice) const {
    return job_.scene ? step_rows(*job_.scene->steps, choice) : no_scene();
}

Result<std::vector<TriangleContacts>> ViewedRun::map(std::uint64_t body) const {
    if (!map_ || body >= map_->bodies.size()) {
        return Error{ErrorCode::NotFound,
                     map_ ? "there is no such body"
                          : "the run has no contact map: it was not asked for (maps = true)"};
    }
    return map_->bodies[body];
}

Result<std::shared_ptr<const NamedParts>> ViewedRun::parts(std::uint64_t body) const {
    if (body >= parts_.size()) {
        return Error{ErrorCode::NotFound, "there is no such body"};
    }
    return parts_[body];
}

Result<std::vector<bool>> ViewedRun::closed_parts(std::uint64_t body) const {
    const auto found = CD_TRY(parts(body));
    return cd::closed_parts(*job_.meshes[body], found->runs);
}

Result<std::shared_ptr<const ScenarioView>> ViewedRun::scenario(std::uint64_t number,
                                                                const StopCheck& stop) {
    if (number >= count()) {
        return Error{ErrorCode::NotFound, "the run has " + counted(count(), "scenario")};
    }
    const auto record = CD_TRY(find_record(number));
    const auto scenarios = CD_TRY(read_poses(number, 1));
    ScenarioView view =
        repeat_scenario(TreesByBody(job_.trees), job_.query, scenarios.front(), record, stop);
    add_label(job_.labels, number, view);
    add_step_time(job_.scene ? job_.scene->steps.get() : nullptr, number, view);
    return std::make_shared<const ScenarioView>(std::move(view));
}

Result<PartFilter> ViewedRun::filter_of(const NextContact& wanted) const {
    if (wanted.part_a.empty() && wanted.part_b.empty()) {
        return PartFilter();
    }
    if (manifest().query.level < Level::Pairs) {
        return bad_input("the run lists no pairs, so that the parts of a scenario are not known: "
                         "its level is " +
                         std::string(to_text(manifest().query.level)));
    }
    return PartFilter::make(
        job_.names, [&](std::uint32_t body) { return parts(body); }, wanted);
}

Result<NextFound> ViewedRun::next(const NextContact& wanted) {
    const auto filter = CD_TRY(filter_of(wanted));
    const auto of_body = CD_TRY(BodyFilter::make(job_.names, wanted.body));
    Status status = Done{};
    const auto fits = [&](std::uint64_t scenario) {
        if (filter.is_empty() && of_body.is_empty()) {
            return true;
        }
        const auto record = find_record(scenario);
        status = record ? Status(Done{}) : record.error();
        return !record || (record.value() && of_body.passes(record.value()->result) &&
                           filter.passes(record.value()->result));
    };
    const auto found = index_.next(wanted, fits);
    return status ? Result(NextFound{found, std::nullopt}) : status.error();
}

std::shared_ptr<const Mesh> ViewedRun::mesh(const Sha256& mesh) const {
    const auto found =
        std::ranges::find_if(job_.meshes, [&](const auto& each) { return each->hash() == mesh; });
    return found == job_.meshes.end() ? nullptr : *found;
}

fs::path ViewedRun::mesh_path(const Sha256& mesh) const {
    return mesh_file_path(run_.dir() / "inputs" / "meshes", mesh);
}

PageOrigin folder_origin(const ViewedRun& run) {
    PageOrigin origin;
    origin.program = "cdctl " + std::string(version);
    origin.name = run.folder().string();
    origin.job = "folder";
    return origin;
}

} // namespace cd
