#include "client/commands/compare/judge.hpp"

#include "client/base/interrupt.hpp"
#include "client/compare/group_diff.hpp"
#include "client/compare/input_changes.hpp"
#include "client/compare/paired_results.hpp"
#include "client/compare/scenario_match.hpp"
#include "client/folder/run_groups.hpp"
#include "common/core/errors.hpp"
#include "common/core/printable.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace cd {

namespace {

std::vector<std::shared_ptr<const Mesh>> meshes_in(const RunAtHand& run) {
    return {run.job.meshes.begin(), run.job.meshes.end()};
}

std::vector<std::string> names_in(const RunAtHand& run) {
    std::vector<std::string> names;
    for (const ManifestBody& body : run.run.manifest().bodies) {
        names.push_back(body.name);
    }
    return names;
}

/// Compares all groups of two runs, scenario by scenario.
Result<std::vector<ChangedGroup>> changed_groups(RunAtHand& earlier, RunAtHand& later) {
    CD_TRY(check_comparable(earlier.run.manifest(), later.run.manifest()));
    const InputChanges inputs = changes_between(earlier.run.manifest(), later.run.manifest());
    const ScenarioMatch match = CD_TRY(match_runs(
        earlier.matched(), later.matched(), inputs.are_poses_equal, &InterruptGuard::has_come));
    GroupDiff groups(meshes_in(earlier),
                     meshes_in(later),
                     part_kind(std::min(earlier.job.query.level, later.job.query.level)));
    const auto apart = apart_pairs(earlier, later);
    CD_TRY(for_each_pair(
        {earlier.run.records(), earlier.job.poses->count(), apart ? &apart->front() : nullptr},
        {later.run.records(), later.job.poses->count(), apart ? &apart->back() : nullptr},
        match,
        &InterruptGuard::has_come,
        [&](const PairedResult& pair) {
            groups.add(pair);
            return Status(Done{});
        }));
    CD_TRY(groups.add_sums(earlier.sums(), later.sums()));
    return groups.groups();
}

bool is_resolved(const std::vector<ChangedGroup>& changed, const Group& group) {
    return std::ranges::any_of(changed, [&](const ChangedGroup& each) {
        return each.state == GroupState::Resolved && each.body_a == group.body_a &&
               each.body_b == group.body_b && each.part_a == group.part_a &&
               each.part_b == group.part_b;
    });
}

bool has_gone(const std::vector<Group>& earlier, const std::vector<Group>& later) {
    return std::ranges::any_of(earlier, [&](const Group& was) {
        return std::ranges::none_of(later, [&](const Group& is) { return is_same(was, is); });
    });
}

/// Warns of bodies whose parts are pieces, which neither statuses nor baselines name for long.
void warn_of_pieces(const RunAtHand& run, GroupSum& groups) {
    for (std::size_t i = 0; i < run.job.meshes.size(); ++i) {
        if (!groups.parts(i).has_lasting_names()) {
            std::fprintf(stderr,
                         "body %s has no named parts, and its pieces may have other numbers in "
                         "another revision: statuses and baselines may name other pieces then\n",
                         run.run.manifest().bodies[i].name.c_str());
        }
    }
}

/// Returns how a run compares with its baseline, with the first groups that are new.
std::string judged_text(const GroupStatuses& statuses,
                        const std::vector<std::string>& bodies,
                        const std::string& baseline,
                        std::uint64_t inside) {
    // In a scene a part alone does not tell whose it is.
    const auto part_name = [&](std::uint32_t body, const std::string& part) {
        return (bodies.size() > 2 ? escaped(bodies[body]) + "/" : "") + escaped(part);
    };
    constexpr std::size_t shown_max = 10;
    std::string text = "  baseline      " + baseline + ": ";
    const char* comma = "";
    for (const GroupStatus status : judged_statuses) {
        text += comma + std::string(to_text(status)) + " " + grouped(statuses.count(status));
        comma = ", ";
    }
    text += "\n";
    std::size_t shown = 0;
    for (const JudgedGroup& each : statuses.groups()) {
        if (GroupStatuses::is_news(each) && shown++ < shown_max) {
            text += "  new           " + part_name(each.group.body_a, each.group.part_a) + " x " +
                    part_name(each.group.body_b, each.group.part_b) + ": " +
                    counted(each.group.scenarios, "scenario") + ", worst #" +
                    std::to_string(each.group.worst) + " with " +
                    counted(each.group.worst_pairs, "pair") + "\n";
        }
    }
    if (inside != 0) {
        text += "  no group      " + counted(inside, "scenario") +
                " inside, where no triangles meet: --fail-on new does not see them\n";
    }
    return shown <= shown_max
               ? text
               : text + "  new           and " + grouped(shown - shown_max) + " more\n";
}

} // namespace

Result<Judge> Judge::open(const JudgeOptions& options,
                          FailOn fail_on,
                          const MasterOptions& master,
                          const std::string& tree_cache,
                          ThreadPool& pool) {
    if (fail_on.news && options.baseline.empty()) {
        return bad_input("--fail-on new compares with an earlier run: give --baseline OLD");
    }
    std::vector<StatusRule> rules;
    if (!options.statuses.empty()) {
        rules = CD_TRY(read_status_file(options.statuses));
    }
    if (options.baseline.empty()) {
        return Judge(std::nullopt, std::move(rules));
    }
    if (!is_folder(options.baseline) && master.address.empty()) {
        return bad_input("--baseline: there is no folder '" + options.baseline +
                         "'; for a job give --master");
    }
    auto earlier =
        CD_TRY(open_run_at_hand(options.baseline, master, tree_cache, {.map = true}, pool));
    if (const Status known = check_groups(earlier.job.query, earlier.map); !known) {
        return bad_input("--baseline: " + options.baseline + ": " + known.error().detail);
    }
    return Judge(std::move(earlier), std::move(rules));
}

Result<GroupStatuses> Judge::judge(RunAtHand& run, GroupSum& groups) {
    const std::vector<Group> now = groups.groups();
    Baseline baseline;
    std::vector<ChangedGroup> changed;
    if (earlier_) {
        auto begun = CD_TRY(begin_groups(earlier_->job.query,
                                         meshes_in(*earlier_),
                                         earlier_->map,
                                         kind_of_parts(run.job.query.level)));
        const GroupSum before =
            CD_TRY(groups_of(earlier_->run.records(), std::move(begun), &InterruptGuard::has_come));
        baseline.groups = before.groups();
        if (has_gone(baseline.groups, now)) {
            changed = CD_TRY(changed_groups(*earlier_, run));
        }
        baseline.is_resolved = [&](const Group& group) { return is_resolved(changed, group); };
    }
    GroupStatuses statuses(now, earlier_ ? &baseline : nullptr, rules_, names_in(run));
    for (const std::string& warning : statuses.warnings()) {
        std::fprintf(stderr, "%s\n", warning.c_str());
    }
    if (earlier_ || !rules_.empty()) {
        warn_of_pieces(run, groups);
    }
    return statuses;
}

PartKind Judge::kind_of_parts(Level level) const {
    return part_kind(earlier_ ? std::min(level, earlier_->job.query.level) : level);
}

std::string Judge::baseline_digest() const {
    const auto& digest = earlier_->run.manifest().outcome.digest;
    return digest ? to_hex(*digest) : "none, since results are missing";
}

Result<bool>
judge_folder(Judge& judge, const RunCommand& command, const std::string& dir, ThreadPool& pool) {
    auto run =
        CD_TRY(open_run_at_hand(dir, command.master, command.host.tree_cache, {.map = true}, pool));
    const Query& query = run.job.query;
    auto begun =
        CD_TRY(begin_groups(query, meshes_in(run), run.map, judge.kind_of_parts(query.level)));
    auto groups = CD_TRY(groups_of(run.run.records(), std::move(begun), &InterruptGuard::has_come));
    const GroupStatuses statuses = CD_TRY(judge.judge(run, groups));
    if (judge.has_baseline()) {
        std::fputs(
            judged_text(statuses, names_in(run), command.judge.baseline, groups.inside()).c_str(),
            command.output == "text" ? stdout : stderr);
    }
    return statuses.has_news();
}

} // namespace cd
