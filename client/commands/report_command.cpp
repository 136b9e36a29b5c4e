// The verb `report`: writes the report of a run, and its groups.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/compare/judge.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/compare/group_statuses.hpp"
#include "client/document/report_pictures.hpp"
#include "client/document/run_document.hpp"
#include "client/document/run_overview.hpp"
#include "client/formats/output_file.hpp"
#include "client/groups/groups_csv.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/words.hpp"

#include <cstdio>
#include <filesystem>
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

/// Writes the report, and groups.csv beside it if the run lists pairs.
Status write_report(const fs::path& path,
                    const std::string& html,
                    const GroupStatuses& statuses,
                    const Query& query,
                    const GroupsOrigin& origin) {
    if (path.has_parent_path()) {
        CD_TRY(make_directories(path.parent_path()));
    }
    const fs::path groups = path.parent_path() / "groups.csv";
    const bool has_groups = query.level >= Level::Pairs;
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
    auto at_hand = CD_TRY(open_run_at_hand(
        command.run, command.master, command.tree_cache, Trees::ForPosesOnly, pool));
    const RunManifest& manifest = at_hand.run.manifest();
    CD_TRY(check_fail_on(command.fail_on, manifest.query.level));
    auto judge = CD_TRY(
        Judge::open(command.judge, command.fail_on, command.master, command.tree_cache, pool));
    InterruptGuard::begin_to_flag(); // From here on, a signal must not leave partial files.
    auto overview = CD_TRY(RunOverview::read(at_hand.run.records(),
                                             {at_hand.job.meshes.begin(), at_hand.job.meshes.end()},
                                             manifest.poses.count,
                                             &InterruptGuard::has_come));
    const GroupStatuses statuses = CD_TRY(judge.judge(at_hand, overview.groups()));
    ReportPictures pictures;
    CD_TRY(pictures.draw(at_hand.job, overview.worst(), &InterruptGuard::has_come));
    RunDocument document(manifest, at_hand.job, overview, statuses, pictures);
    document.set_baseline({command.judge.baseline,
                           judge.has_baseline() ? judge.baseline_digest() : "",
                           statuses.warnings()});
    const std::string html = CD_TRY(document.html(&InterruptGuard::has_come));
    if (!command.pictures.empty()) {
        CD_TRY(write_pictures(
            command.pictures, at_hand.job, overview.worst(), &InterruptGuard::has_come));
    }
    CD_TRY(write_report(command.out,
                        html,
                        statuses,
                        manifest.query,
                        {names_of_bodies(manifest),
                         overview.summary().tested(),
                         manifest.query.limit_pairs,
                         overview.groups().left_out()}));
    return exit_code_of(overview.summary(), command.fail_on, statuses.has_news());
}

} // namespace cd
