#include "client/scene/prepared_scene.hpp"

#include "client/base/slow_note.hpp"
#include "client/poses/chord_check.hpp"
#include "client/poses/fcd_file.hpp"
#include "client/scene/scene_meshes.hpp"
#include "client/scene/scene_steps.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/motion/motion_bound.hpp"
#include "common/scene/scene_head.hpp"
#include "common/scene/scene_poses.hpp"
#include "common/scene/swept_box.hpp"

#include <utility>

namespace cd {

namespace {

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// Places the bodies of a scene by the boxes and radii of their meshes.
std::vector<PlacedBody> placed(const SceneBodies& scene, const std::vector<bool>& are_fixed) {
    std::vector<PlacedBody> of_meshes;
    for (const auto& mesh : scene.meshes) {
        of_meshes.push_back({bounding_box(mesh->vertices()), false, body_radius(mesh->vertices())});
    }
    std::vector<PlacedBody> bodies;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        bodies.push_back(of_meshes[scene.bodies[i].mesh]);
        bodies.back().is_fixed = are_fixed[i];
        bodies.back().name = scene.bodies[i].name;
    }
    return bodies;
}

/// Returns how many steps are tested, of so many that have poses: motions lead from each to the
/// next.
std::uint64_t steps_tested(const Query& query, std::uint64_t steps) {
    return query.motion ? steps - 1 : steps;
}

/// Returns the bodies of a scene, which pairs are tested, and how its query asks about them.
Scene scene_of(std::vector<PlacedBody> bodies, PairSet ignored, const Query& query) {
    Scene scene{std::move(bodies), std::move(ignored), reach_of(query)};
    if (query.motion) {
        scene.resolution = query.motion->resolution;
    }
    return scene;
}

/// Returns the hash of each body's mesh.
std::vector<Sha256> hashes_of(const SceneBodies& scene) {
    std::vector<Sha256> hashes;
    for (const NamedBody& body : scene.bodies) {
        hashes.push_back(scene.mesh_of(body).hash());
    }
    return hashes;
}

/// Takes the scenarios of pairs of bodies.
Status take_pairs(const JobSpec& spec,
                  std::vector<PlacedBody> bodies,
                  PairSet ignored,
                  std::unique_ptr<StepPoses> poses,
                  const StopCheck& stop,
                  PreparedScene& prepared) {
    prepared.head = scene_head(hashes_of(prepared.scene),
                               prepared.are_fixed,
                               steps_tested(spec.query, poses->steps()),
                               ignored,
                               prepared.ignored);
    auto made = CD_TRY(ScenePoses::create(
        scene_of(std::move(bodies), std::move(ignored), prepared.query), std::move(poses), stop));
    CD_TRY(check_chord(spec, 2 * made->moved_between().value_or(0)));
    prepared.steps = made->steps();
    prepared.facts.absences.assign(made->absences().begin(), made->absences().end());
    prepared.facts.moved = made->moved();
    prepared.poses = std::move(made);
    return Done{};
}

/// Takes the scenarios of bodies and lines. `ignored` has the lines as the last body.
Status take_lines(const JobSpec& spec,
                  const PairSet& ignored,
                  std::unique_ptr<StepPoses> poses,
                  const StopCheck& stop,
                  PreparedScene& prepared) {
    const auto lines = static_cast<std::uint32_t>(prepared.scene.bodies.size());
    LineTargets targets{placed(prepared.scene, prepared.are_fixed), {}};
    for (std::uint32_t body = 0; body < lines; ++body) {
        targets.are_ignored.push_back(ignored.has({body, lines}));
    }
    const std::uint64_t steps = poses->steps();
    auto standing = CD_TRY(
        stand_lines(*spec.scene->shots, std::move(targets), std::move(poses), spec.file, stop));
    prepared.steps = standing.poses->steps();
    prepared.facts.absences.assign(standing.poses->absences().begin(),
                                   standing.poses->absences().end());
    prepared.poses = std::move(standing.poses);
    prepared.lines = std::move(standing.lines);
    prepared.are_fixed.push_back(false);
    std::vector<Sha256> hashes = hashes_of(prepared.scene);
    hashes.push_back(prepared.lines->mesh->hash());
    prepared.head = scene_head(
        hashes, prepared.are_fixed, steps * prepared.lines->bundles, ignored, prepared.ignored);
    return Done{};
}

/// Reads the vehicles of SUMO; null if the job has none. Errors: those of `read_fcd_file`.
Result<std::shared_ptr<const RoadTraffic>> read_traffic(const SceneSpec& scene, bool quiet) {
    if (!scene.fcd) {
        return std::shared_ptr<const RoadTraffic>();
    }
    const SlowNote note("reading " + scene.fcd->path.filename().string() + "...", quiet);
    return std::make_shared<const RoadTraffic>(CD_TRY(read_fcd_file(*scene.fcd)));
}

/// Puts keys between the steps where rows have velocities. Errors: as `CurvedSteps::create`;
/// BadInput for a chord without velocities.
Status follow_curves(const JobSpec& spec,
                     const std::vector<PlacedBody>& bodies,
                     OpenedSteps& steps,
                     std::vector<std::string>& notes,
                     const StopCheck& stop) {
    if (steps.rates.empty()) {
        return spec.chord
                   ? Status(error_at_key(spec, "chord", "[motion]: " + std::string(chord_use)))
                   : Status(Done{});
    }
    if (!spec.query.motion) {
        notes.emplace_back("velocities count with [motion] alone; poses are tested as they are");
        return Done{};
    }
    const double off_max = spec.chord.value_or(spec.query.motion->resolution / 8);
    const std::uint64_t given = steps.poses->steps();
    auto curved = CD_TRY(
        CurvedSteps::create(std::move(steps.poses), std::move(steps.rates), bodies, off_max, stop));
    notes.push_back(grouped(given) + " steps became " + counted(curved->steps(), "key") +
                    " along the bodies' velocities, within " + exact_text(off_max) + " " +
                    spec.unit + (spec.chord ? ", by which the clearance grows" : " of them"));
    steps.poses = std::move(curved);
    return Done{};
}

} // namespace

double reach_of(const Query& query) {
    if (query.motion) {
        return reach_of_motions(query.clearance.value_or(0), query.motion->resolution);
    }
    return query.question == Question::Distance ? query.up_to.value_or(0)
                                                : query.clearance.value_or(0);
}

Result<PreparedScene> prepare_scene(const JobSpec& spec, bool quiet, const StopCheck& stop) {
    CD_CHECK(spec.scene.has_value());
    const SceneSpec& scene = *spec.scene;
    const auto read = CD_TRY(import_meshes(scene, spec.unit, quiet));
    PreparedScene prepared;
    append(prepared.warnings, read.warnings);
    auto traffic = CD_TRY(read_traffic(scene, quiet));
    prepared.scene =
        CD_TRY(expand_bodies(scene, read.meshes, spec.file, traffic ? *traffic : RoadTraffic()));
    auto rules = CD_TRY(scene.shots ? apply_rules_of_lines(scene, prepared.scene, spec.file)
                                    : apply_rules(scene.rules, prepared.scene, spec.file));
    prepared.effects = std::move(rules.effects);
    prepared.ignored = std::move(rules.ranges);
    prepared.ignored_pairs = rules.ignored.count();
    const SlowNote note("reading poses, and pairing the boxes of each step...", quiet);
    auto steps = CD_TRY(open_steps(scene, prepared.scene, spec.file, std::move(traffic)));
    if (spec.query.motion && steps.poses->steps() < 2) {
        return error_at_key(
            spec,
            "[motion]",
            "[motion] leads from one step to the next; give the bodies poses for two "
            "steps or more, or leave out [motion]");
    }
    append(prepared.warnings, steps.warnings);
    prepared.query = covering(spec.query, spec.chord);
    std::vector<PlacedBody> bodies = placed(prepared.scene, steps.are_fixed);
    CD_TRY(follow_curves(spec, bodies, steps, prepared.facts.notes, stop));
    prepared.facts.zeros = std::move(steps.zeros);
    prepared.are_fixed = std::move(steps.are_fixed);
    if (scene.shots) {
        CD_TRY(take_lines(spec, rules.ignored, std::move(steps.poses), stop, prepared));
    } else {
        CD_TRY(take_pairs(spec,
                          std::move(bodies),
                          std::move(rules.ignored),
                          std::move(steps.poses),
                          stop,
                          prepared));
    }
    const std::uint64_t count = prepared.steps->steps();
    if (scene.rules.learn && *scene.rules.learn >= count) {
        return error_at_key(spec,
                            "learn",
                            "[rules] learn = " + std::to_string(*scene.rules.learn) +
                                ": the steps are 0 to " + std::to_string(count - 1));
    }
    return prepared;
}

} // namespace cd
