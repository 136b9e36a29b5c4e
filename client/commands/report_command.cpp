// The verb `report`: writes the report of a run, and its groups.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/shell_word.hpp"
#include "client/base/slow_note.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/compare/judge.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/compare/group_statuses.hpp"
#include "client/document/embedded_viewer.hpp"
#include "client/document/motion/motion_sections.hpp"
#include "client/document/report_pictures.hpp"
#include "client/document/run_document.hpp"
#include "client/document/run_overview.hpp"
#include "client/folder/run_groups.hpp"
#include "client/formats/output_file.hpp"
#include "client/groups/body_choice.hpp"
#include "client/groups/groups_csv.hpp"
#include "client/trees/body_trees.hpp"
#include "client/view/held_answers.hpp"
#include "client/view/held_steps.hpp"
#include "client/view/viewed_run.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"
#include "common/core/version.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of_bodies(const RunManifest& manifest) {
    std::vector<std::string> names;
    for (const ManifestBody& body : manifest.bodies) {
        names.push_back(body.name);
    }
    return names;
}

/// Errors: TooLarge if a report, so far, has more bytes than it may have.
Status check_size(std::uint64_t bytes, const ReportCommand& command) {
    const std::uint64_t most = command.has_viewer ? command.bytes_max : limits::report_bytes_max;
    const auto megabytes = [](std::uint64_t size) {
        return fixed_text(static_cast<double>(size) / 1e6, 1) + " MB";
    };
    return bytes <= most
               ? Status(Done{})
               : Error{ErrorCode::TooLarge,
                       std::string(command.has_viewer ? "with --3d the" : "the") +
                           " report takes " + megabytes(bytes) + " or more, above " +
                           megabytes(most) + "; " +
                           (command.has_viewer ? "leave out --3d, and " : "") +
                           "see the run in 3D with: cdctl view " + shell_word(command.run)};
}

PageOrigin origin_of(const ViewedRun& run, const ReportCommand& command) {
    if (is_folder(command.run)) {
        return folder_origin(run);
    }
    const ManifestPlace& where = run.manifest().where;
    return {
        PageOrigin::Kind::Remote, "cdctl " + std::string(version), where.master, false, where.job};
}

/// Adds the other bodies of a scene's steps, as far as the report has room; says what is left out.
Status add_steps(EmbeddedViewer& viewer,
                 ViewedRun& run,
                 const std::string& job,
                 std::span<const std::uint64_t> scenarios,
                 const ReportCommand& command) {
    // The rest of the report keeps its room.
    const std::uint64_t bytes_max =
        command.bytes_max - std::min(command.bytes_max, limits::report_bytes_max);
    const auto offer = [&](std::span<const HeldAnswer> answers) {
        return viewer.add_if_room(answers, bytes_max);
    };
    const LeftOut left_out =
        CD_TRY(offer_steps(run, job, scenarios, offer, &InterruptGuard::has_come));
    if (!left_out.is_empty()) {
        std::fprintf(stderr,
                     "the viewer has no room for %s; cdctl view %s shows them\n",
                     left_out.text().c_str(),
                     shell_word(command.run).c_str());
    }
    return Done{};
}

/// Makes the viewer of the worst scenarios; nothing if it is not asked for or has nothing to show.
Result<std::optional<EmbeddedViewer>>
make_viewer(const ReportCommand& command, RunAtHand& at_hand, ThreadPool& pool) {
    std::optional<EmbeddedViewer> viewer;
    if (!command.has_viewer) {
        return viewer;
    }
    const auto run = CD_TRY(
        ViewedRun::open(at_hand.run, at_hand.job, at_hand.map, pool, &InterruptGuard::has_come));
    const auto worst = run->worst(limits::report_viewer_scenarios_max);
    if (worst.empty()) {
        std::fprintf(stderr,
                     "%s: there is nothing to show in 3D\n",
                     run->manifest().query.question == Question::Distance
                         ? "no scenario is in contact or has a distance"
                         : "no scenario is in contact");
        return viewer;
    }
    viewer.emplace();
    const auto take = [&](const HeldAnswer& answer) {
        viewer->add(answer);
        return check_size(viewer->bytes(), command);
    };
    const PageOrigin origin = origin_of(*run, command);
    CD_TRY(for_each_answer(*run, origin, worst, take, &InterruptGuard::has_come));
    CD_TRY(add_steps(*viewer, *run, origin.job, worst, command));
    return viewer;
}

/// Reads what lines tell; nothing for a run that lists no hits.
Result<std::optional<ShotsSections>> read_lines_of(RunAtHand& run) {
    std::optional<ShotsSections> sections;
    const Query& query = run.job.query;
    if (query.question == Question::Shots && query.level >= Level::Pairs) {
        sections =
            CD_TRY(ShotsSections::read(run.run.records(), run.job, &InterruptGuard::has_come));
    }
    return sections;
}

/// Reads what is proven of motions; nothing for a run without.
Result<std::optional<MotionSections>> read_motions_of(const RunAtHand& run) {
    std::optional<MotionSections> sections;
    if (run.job.query.motion) {
        sections =
            CD_TRY(MotionSections::read(run.run.records(), run.job, &InterruptGuard::has_come));
    }
    return sections;
}

/// Reads what the steps of a scene tell; nothing for a run of two bodies.
Result<std::optional<SceneSections>> read_scene_of(const RunAtHand& run) {
    std::optional<SceneSections> sections;
    if (run.job.scene) {
        sections =
            CD_TRY(SceneSections::read(run.run.records(), run.job, &InterruptGuard::has_come));
    }
    return sections;
}

/// Returns the bodies that the report is about; from now on the run has only their records. Errors:
/// BadInput for a body that the run lacks, or if an earlier run is to be compared.
Result<BodyChoice> choose_bodies(const ReportCommand& command, OpenedRun& run) {
    auto bodies = CD_TRY(BodyChoice::of_names(command.bodies, names_of_bodies(run.manifest())));
    if (!bodies.is_all() && !command.judge.baseline.empty()) {
        return bad_input("--baseline compares all bodies: leave out --body");
    }
    if (!bodies.is_all()) {
        run.records().keep_only([bodies](const ScenarioResult& result) {
            return bodies.has(result.body_a, result.body_b);
        });
    }
    return bodies;
}

/// Begins the sum of a run's groups, or an empty one if they are unknown. Errors: BadInput if they
/// are unknown, but there is a baseline to compare with.
Result<GroupSum> groups_begun(const RunAtHand& run, const Judge& judge) {
    std::vector<std::shared_ptr<const Mesh>> meshes{run.job.meshes.begin(), run.job.meshes.end()};
    const Query& query = run.job.query;
    if (!judge.has_baseline() && !check_groups(query, run.map)) {
        return GroupSum(std::move(meshes));
    }
    return begin_groups(query, std::move(meshes), run.map, judge.kind_of_parts(query.level));
}

/// Gives the worst scenarios of a run that lists no pairs the pairs for their pictures.
Status
add_pairs(RunAtHand& run, RunOverview& overview, const std::string& cache, ThreadPool& pool) {
    const Query& query = run.job.query;
    const bool has_no_pictures = query.question == Question::Shots || overview.worst().empty();
    if (query.level >= Level::Pairs || has_no_pictures) {
        return Done{};
    }
    const SlowNote note("running the worst scenarios again for their pictures...", false);
    if (run.job.trees.empty()) {
        TreeCache trees(tree_cache_folder(cache));
        run.job.trees = make_body_trees(run.job.meshes, TreeUse{.settles = true}, trees, pool);
    }
    return overview.add_pairs_to_worst(run.job, timing::report_run_max, &InterruptGuard::has_come);
}

/// Returns the scenarios that the report has pictures of; none of a job of lines, whose pictures
/// are those of its directions.
std::vector<ScenarioResult> pictured_of(const RunAtHand& run, const RunOverview& overview) {
    return run.job.query.question == Question::Shots ? std::vector<ScenarioResult>()
                                                     : overview.pictured();
}

/// Writes the report and, if `has_groups`, groups.csv beside it.
Status write_report(const fs::path& path,
                    const std::string& html,
                    const GroupStatuses& statuses,
                    bool has_groups,
                    const GroupsOrigin& origin) {
    if (path.has_parent_path()) {
        CD_TRY(make_directories(path.parent_path()));
    }
    const fs::path groups = path.parent_path() / "groups.csv";
    if (has_groups) {
        CD_TRY(write_groups_csv(groups, rows_of(statuses), origin));
    }
    CD_TRY(write_file(path, html));
    std::printf("%s%s%s\n",
                path.string().c_str(),
                has_groups ? ", " : "",
                has_groups ? groups.string().c_str() : "");
    return Done{};
}

} // namespace

Result<int> perform(const ReportCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    ThreadPool pool(command.threads);
    // Scenarios are run again for the viewer.
    const Trees trees = command.has_viewer ? Trees::Always : Trees::ForPosesOnly;
    auto at_hand = CD_TRY(open_run_at_hand(
        command.run, command.master, command.tree_cache, {.trees = trees, .map = true}, pool));
    const RunManifest& manifest = at_hand.run.manifest();
    CD_TRY(check_fail_on(command.fail_on, manifest.query));
    const BodyChoice bodies = CD_TRY(choose_bodies(command, at_hand.run));
    auto judge = CD_TRY(
        Judge::open(command.judge, command.fail_on, command.master, command.tree_cache, pool));
    InterruptGuard::begin_to_flag(); // From here on, a signal must not leave partial files.
    auto begun = CD_TRY(groups_begun(at_hand, judge));
    auto overview = CD_TRY(RunOverview::read(at_hand.run.records(),
                                             std::move(begun),
                                             manifest.poses.count,
                                             &InterruptGuard::has_come,
                                             manifest.scene_head()));
    if (!bodies.is_all()) {
        CD_TRY(overview.restrict_to(bodies, *at_hand.job.poses, &InterruptGuard::has_come));
    }
    const GroupStatuses statuses = CD_TRY(judge.judge(at_hand, overview.groups()));
    const auto viewer = CD_TRY(make_viewer(command, at_hand, pool));
    CD_TRY(add_pairs(at_hand, overview, command.tree_cache, pool));
    ReportPictures pictures;
    const std::vector<ScenarioResult> pictured = pictured_of(at_hand, overview);
    CD_TRY(pictures.draw(at_hand.job, pictured, &InterruptGuard::has_come));
    RunDocument document(manifest, at_hand.job, overview, statuses, pictures);
    document.set_baseline({command.judge.baseline,
                           judge.has_baseline() ? judge.baseline_digest() : "",
                           statuses.warnings()});
    const Status has_groups = check_groups(manifest.query, at_hand.map);
    if (!has_groups) {
        document.set_no_groups(has_groups.error().detail);
    }
    if (viewer) {
        document.set_viewer(*viewer);
    }
    const std::optional<ShotsSections> shots = CD_TRY(read_lines_of(at_hand));
    if (shots) {
        document.set_shots(*shots);
    }
    const std::optional<SceneSections> scene = CD_TRY(read_scene_of(at_hand));
    if (scene) {
        document.set_scene(*scene);
    }
    const std::optional<MotionSections> motions = CD_TRY(read_motions_of(at_hand));
    if (motions) {
        document.set_motions(*motions);
    }
    const std::string html = CD_TRY(document.html(&InterruptGuard::has_come));
    CD_TRY(check_size(html.size(), command));
    if (!command.pictures.empty()) {
        CD_TRY(write_pictures(command.pictures, at_hand.job, pictured, &InterruptGuard::has_come));
        if (shots) {
            CD_TRY(write_thickness_pictures(
                command.pictures, at_hand.run.records(), at_hand.job, &InterruptGuard::has_come));
        }
    }
    CD_TRY(write_report(command.out,
                        html,
                        statuses,
                        has_groups.has_value(),
                        {names_of_bodies(manifest),
                         overview.summary().tested(),
                         manifest.query.limit_pairs,
                         overview.groups().left_out(),
                         manifest.query.clearance.has_value()}));
    return exit_code_of(overview.summary(), command.fail_on, statuses.has_news());
}

} // namespace cd
