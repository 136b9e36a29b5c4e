#include "web/server/cluster/cluster_jobs.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/closed_parts.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/severity.hpp"
#include "web/server/part_filter.hpp"
#include "web/server/scenario_repeat.hpp"
#include "web/server/scene/body_filter.hpp"
#include "web/server/scene/scene_rows.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// Scenarios are looked through in parts of at most this many.
constexpr std::uint64_t part_scenarios = 4096;

/// Calls `take` with each result and its place in the choice. A sample that is larger than the job
/// has several places for some scenarios, whose records are read once.
Status for_each_chosen(const RecordReader& records,
                       const PagedJob& job,
                       const ScenarioChoice& choice,
                       const TakeRecord& take) {
    if (choice.sample == 0) {
        return records(choice, [&](std::uint64_t scenario, const ScenarioResult& result) {
            return take(scenario - choice.first, result);
        });
    }
    if (choice.sample <= job.scenarios()) {
        return records(choice, take);
    }
    std::uint64_t place = 0;
    const ScenarioChoice all{0, job.scenarios()};
    return records(all, [&](std::uint64_t index, const ScenarioResult& result) -> Status {
        while (place < choice.sample && choice.at(place, job.scenarios()) < index) {
            ++place; // The scenario before has no result.
        }
        for (; place < choice.sample && choice.at(place, job.scenarios()) == index; ++place) {
            CD_TRY(take(place, result));
        }
        return Done{};
    });
}

PosesView poses_view(const Submit& submit) {
    const PosesOrigin& poses = submit.poses;
    return {poses.kind,
            submit.scenarios,
            poses.file,
            poses.axes,
            poses.random,
            poses.labels.ids != IdKind::None,
            poses.labels.has_times,
            poses.of_both_bodies || poses.scene};
}

/// Makes the groups of a job of its sums by part; nothing if they are unknown or too many.
std::optional<GroupsView>
groups_view(const ContactMapAnswer& sums, const BodyTrees& trees, const PagedJob& job) {
    if (!sums.is_asked || !sums.withdrawn.empty() || trees.size() != 2) {
        return std::nullopt;
    }
    const auto map = unpack_map(sums.map, any_map(job.scenarios()));
    if (!map || map.value().parts.left_out != 0) {
        return std::nullopt;
    }
    std::vector<PartPairContacts> pairs = map.value().parts.pairs;
    std::ranges::stable_sort(pairs, [](const auto& left, const auto& right) {
        return std::tuple(left.scenarios, left.pairs, left.near) >
               std::tuple(right.scenarios, right.pairs, right.near);
    });
    GroupsView view;
    view.total = pairs.size();
    pairs.resize(std::min(pairs.size(), limits::page_groups_max));
    const auto tested = std::max<std::uint64_t>(1, job.status.summary.tested());
    const NamedParts a = named_parts(trees[0]->mesh());
    const NamedParts b = named_parts(trees[1]->mesh());
    for (const PartPairContacts& pair : pairs) {
        if (pair.a >= a.names.size() || pair.b >= b.names.size()) {
            return std::nullopt;
        }
        view.rows.push_back({a.names[pair.a],
                             b.names[pair.b],
                             pair.scenarios,
                             static_cast<double>(pair.scenarios) / static_cast<double>(tested),
                             pair.pairs,
                             pair.worst,
                             pair.worst_pairs,
                             class_of(pair),
                             pair.near,
                             pair.worst_near});
    }
    return view;
}

/// Returns the parts that the sums of a cluster's job have.
std::shared_ptr<const NamedParts> shared_parts(const ObbTree& tree) {
    return std::make_shared<const NamedParts>(named_parts(tree.mesh()));
}

std::vector<std::string> names_of(const Submit& submit) {
    std::vector<std::string> names;
    for (const JobBody& body : submit.bodies) {
        names.push_back(body.name);
    }
    return names;
}

Result<PartFilter>
filter_of(ClusterReader& reader, const PagedJob& job, const NextContact& wanted) {
    if (wanted.part_a.empty() && wanted.part_b.empty()) {
        return PartFilter();
    }
    const auto description = CD_TRY(reader.description(job.status.job));
    if (description.submit.query.level < Level::Pairs) {
        return bad_input("the job lists no pairs, so that the parts of a scenario are not known: "
                         "its level is " +
                         std::string(to_text(description.submit.query.level)));
    }
    const auto trees = CD_TRY(reader.trees(description.submit));
    return PartFilter::make(
        names_of(description.submit),
        [&](std::uint32_t body) { return Result(shared_parts(*trees[body])); },
        wanted);
}

Result<BodyFilter>
body_filter_of(ClusterReader& reader, const PagedJob& job, const NextContact& wanted) {
    if (wanted.body.empty()) {
        return BodyFilter();
    }
    const auto description = CD_TRY(reader.description(job.status.job));
    return BodyFilter::make(names_of(description.submit), wanted.body);
}

/// A range of scenarios to look through.
struct Window {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// Returns the number of scenarios beyond the one from which the search begins.
std::uint64_t number_beyond(const NextContact& wanted, std::uint64_t total) {
    const std::uint64_t from = std::min(wanted.from, total);
    return wanted.is_backwards ? from : total - std::min(from + 1, total);
}

/// Returns the scenarios to look through after `done` ones were.
Window window_after(const NextContact& wanted, std::uint64_t total, std::uint64_t done) {
    const std::uint64_t from = std::min(wanted.from, total);
    const std::uint64_t count = std::min(
        {number_beyond(wanted, total) - done, limits::page_scenarios_max - done, part_scenarios});
    return {wanted.is_backwards ? from - done - count : from + 1 + done, count};
}

/// Returns what a search that found nothing in `done` scenarios says.
NextFound nothing_in(const NextContact& wanted, std::uint64_t total, std::uint64_t done) {
    if (done == number_beyond(wanted, total)) {
        return {};
    }
    return {std::nullopt, wanted.is_backwards ? wanted.from - done : wanted.from + done};
}

} // namespace

Result<JobView> view_of(ClusterReader& reader, const PagedJob& job, const ContactMapAnswer& sums) {
    const auto description = CD_TRY(reader.description(job.status.job));
    const Submit& submit = description.submit;
    JobView view;
    view.row = {job.id, "", job.status};
    view.unit = submit.unit;
    view.query = submit.query;
    view.poses = poses_view(submit);
    view.map.exists = submit.query.maps && job.status.state == JobState::Done;
    view.run.where = counted(job.workers, "worker");
    const auto steps = CD_TRY(steps_of(submit));
    if (steps != nullptr) {
        view.steps = steps->steps();
    }
    const auto trees = reader.trees(submit);
    for (std::size_t i = 0; i < submit.bodies.size(); ++i) {
        view.bodies.push_back(trees && i < trees.value().size()
                                  ? body_view(submit.bodies[i], *trees.value()[i])
                                  : BodyView{submit.bodies[i]});
    }
    if (trees) {
        view.groups = groups_view(sums, trees.value(), job);
    }
    return view;
}

Result<std::vector<std::uint8_t>>
classes_of(const RecordReader& records, const PagedJob& job, const ScenarioChoice& choice) {
    CD_TRY(choice.check(job.scenarios(), limits::page_scenarios_max));
    std::vector<std::uint8_t> classes(choice.size(), no_class);
    CD_TRY(for_each_chosen(
        records, job, choice, [&](std::uint64_t place, const ScenarioResult& each) -> Status {
            classes[place] = static_cast<std::uint8_t>(each.kind);
            return Done{};
        }));
    return classes;
}

Result<std::vector<std::uint32_t>>
counts_of(const RecordReader& records, const PagedJob& job, const ScenarioChoice& choice) {
    CD_TRY(choice.check(job.scenarios(), limits::page_scenarios_max));
    std::vector<std::uint32_t> counts(choice.size());
    CD_TRY(for_each_chosen(
        records, job, choice, [&](std::uint64_t place, const ScenarioResult& each) -> Status {
            counts[place] = static_cast<std::uint32_t>(std::min<std::uint64_t>(
                pairs_of_class(each), std::numeric_limits<std::uint32_t>::max()));
            return Done{};
        }));
    return counts;
}

Result<std::vector<double>>
distances_of(const RecordReader& records, const PagedJob& job, const ScenarioChoice& choice) {
    CD_TRY(choice.check(job.scenarios(), limits::page_scenarios_max));
    std::vector<double> distances(choice.size(), std::numeric_limits<double>::quiet_NaN());
    CD_TRY(for_each_chosen(
        records, job, choice, [&](std::uint64_t place, const ScenarioResult& each) -> Status {
            distances[place] = each.nearest ? each.nearest->distance : distances[place];
            return Done{};
        }));
    return distances;
}

Result<PoseRows>
poses_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice) {
    CD_TRY(choice.check(job.scenarios(), limits::page_scenarios_max));
    const auto description = CD_TRY(reader.description(job.status.job));
    PoseRows rows{poses_view(description.submit).of_both_bodies ? std::size_t{2} : 1, {}};
    const LabelledScenarios read = CD_TRY(reader.poses(job.status.job, choice));
    for (const Scenario& scenario : read.scenarios) {
        rows.add(scenario.poses);
    }
    return rows;
}

Result<std::vector<MotionKeys>>
motions_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice) {
    CD_TRY(choice.check(job.scenarios(), limits::page_scenarios_max));
    const LabelledScenarios read = CD_TRY(reader.poses(job.status.job, choice));
    return scene_motions(read.scenarios);
}

Result<std::vector<ScenePlace>>
places_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice) {
    CD_TRY(choice.check(job.scenarios(), limits::page_scenarios_max));
    const auto description = CD_TRY(reader.description(job.status.job));
    const auto steps = CD_TRY(steps_of(description.submit));
    if (steps == nullptr) {
        return no_scene();
    }
    const LabelledScenarios read = CD_TRY(reader.poses(job.status.job, choice));
    return scene_places(read.scenarios, *steps);
}

Result<std::vector<StepRow>>
steps_of(ClusterReader& reader, const PagedJob& job, const ScenarioChoice& choice) {
    const auto description = CD_TRY(reader.description(job.status.job));
    const auto steps = CD_TRY(steps_of(description.submit));
    return steps == nullptr ? no_scene() : step_rows(*steps, choice);
}

Result<std::vector<TriangleContacts>> map_of(ClusterReader& reader,
                                             const PagedJob& job,
                                             const ContactMapAnswer& answer,
                                             std::uint64_t body) {
    if (!answer.is_asked || !answer.withdrawn.empty()) {
        return Error{ErrorCode::NotFound,
                     answer.is_asked ? "the map was withdrawn: " + answer.withdrawn
                                     : "the job has no contact map: it was not asked for "
                                       "(maps = true)"};
    }
    const auto description = CD_TRY(reader.description(job.status.job));
    const auto trees = CD_TRY(reader.trees(description.submit));
    const auto map = CD_TRY(unpack_map(answer.map,
                                       {trees[0]->mesh().triangles().size(),
                                        trees[1]->mesh().triangles().size(),
                                        job.scenarios(),
                                        limits::map_crossings_max}));
    if (body >= map.bodies.size()) {
        return Error{ErrorCode::NotFound, "there is no such body"};
    }
    return map.bodies[body];
}

Result<std::shared_ptr<const NamedParts>>
parts_of(ClusterReader& reader, const PagedJob& job, std::uint64_t body) {
    const auto description = CD_TRY(reader.description(job.status.job));
    const auto trees = CD_TRY(reader.trees(description.submit));
    if (body >= trees.size()) {
        return Error{ErrorCode::NotFound, "there is no such body"};
    }
    return shared_parts(*trees[body]);
}

Result<std::vector<bool>>
closed_parts_of(ClusterReader& reader, const PagedJob& job, std::uint64_t body) {
    const auto parts = CD_TRY(parts_of(reader, job, body));
    const auto description = CD_TRY(reader.description(job.status.job));
    const auto trees = CD_TRY(reader.trees(description.submit));
    return closed_parts(trees[body]->mesh(), parts->runs);
}

Result<NextFound> next_of(ClusterReader& reader,
                          const RecordReader& records,
                          const PagedJob& job,
                          const NextContact& wanted) {
    const auto filter = CD_TRY(filter_of(reader, job, wanted));
    const auto of_body = CD_TRY(body_filter_of(reader, job, wanted));
    std::uint64_t done = 0;
    for (Window window = window_after(wanted, job.scenarios(), done); window.count != 0;
         window = window_after(wanted, job.scenarios(), done)) {
        std::optional<std::uint64_t> found;
        const ScenarioChoice choice{window.first, window.count};
        CD_TRY(records(choice, [&](std::uint64_t, const ScenarioResult& result) {
            const bool is_better = !found || wanted.is_backwards;
            const auto kind = static_cast<std::uint8_t>(result.kind);
            if (is_better && wanted.has_class(kind) && of_body.passes(result) &&
                filter.passes(result)) {
                found = result.index;
            }
            return Status(Done{});
        }));
        if (found) {
            return NextFound{found, std::nullopt};
        }
        done += window.count;
    }
    return nothing_in(wanted, job.scenarios(), done);
}

Result<ScenarioInputs> inputs_of(ClusterReader& reader,
                                 const RecordReader& records,
                                 const PagedJob& job,
                                 std::uint64_t scenario) {
    if (scenario >= job.scenarios()) {
        return Error{ErrorCode::NotFound, "the job has " + counted(job.scenarios(), "scenario")};
    }
    const auto description = CD_TRY(reader.description(job.status.job));
    ScenarioInputs inputs;
    inputs.query = description.submit.query;
    inputs.trees = CD_TRY(reader.trees(description.submit));
    const ScenarioChoice one{scenario, 1};
    auto read = CD_TRY(reader.poses(job.status.job, one));
    inputs.scenario = read.scenarios.front();
    inputs.labels = std::move(read.labels);
    inputs.steps = CD_TRY(steps_of(description.submit));
    CD_TRY(records(one, [&](std::uint64_t, const ScenarioResult& result) {
        inputs.record = KeptRecord{encode_result(result), result};
        return Status(Done{});
    }));
    return inputs;
}

std::shared_ptr<const ScenarioView> run_again(const ScenarioInputs& inputs, const StopCheck& stop) {
    ScenarioView view = repeat_scenario(
        TreesByBody(inputs.trees), inputs.query, inputs.scenario, inputs.record, stop);
    add_label(inputs.labels, 0, view);
    add_step_time(inputs.steps.get(), inputs.scenario.index, view);
    return std::make_shared<const ScenarioView>(std::move(view));
}

BodyView body_view(const JobBody& body, const ObbTree& tree) {
    const Mesh& mesh = tree.mesh();
    const Aabb box = bounding_box(mesh.vertices());
    return {body,
            mesh.triangles().size(),
            mesh.parts().size(),
            tree.topology().is_closed(),
            mesh.canonical_bytes().size(),
            mesh.precision(),
            box.size(),
            box.is_empty() ? Vec3(Vec3::Zero()) : box.min};
}

void add_label(const PoseLabels& labels, std::uint64_t place, ScenarioView& view) {
    if (place < labels.integers.size()) {
        view.id = std::to_string(labels.integers[place]);
    } else if (place < labels.texts.size()) {
        view.id = labels.texts[place];
    }
    if (place < labels.times.size()) {
        view.time = labels.times[place];
    }
}

} // namespace cd
