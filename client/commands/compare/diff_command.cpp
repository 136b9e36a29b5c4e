// The verb `diff`: compares two runs.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/compare/diff_report.hpp"
#include "client/compare/paired_results.hpp"
#include "client/folder/run_groups.hpp"
#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// The runs that are compared.
struct Compared {
    RunAtHand& earlier;
    RunAtHand& later;
    InputChanges inputs;

    [[nodiscard]] bool has_equal_mesh(std::size_t body) const {
        return !inputs.bodies[body].is_changed;
    }
    [[nodiscard]] bool have_equal_meshes() const {
        return std::ranges::none_of(inputs.bodies, &BodyChange::is_changed);
    }
    /// True if both runs list pairs of two bodies, whose triangles are compared.
    [[nodiscard]] bool maps_pairs() const {
        return least_level() >= Level::Pairs && !later.job.scene;
    }
    [[nodiscard]] Level least_level() const {
        return std::min(earlier.job.query.level, later.job.query.level);
    }
    /// True if a run has a clearance.
    [[nodiscard]] bool has_near() const {
        return earlier.job.query.clearance || later.job.query.clearance;
    }
    /// True if a run asks for the distance.
    [[nodiscard]] bool has_distance() const {
        return earlier.job.query.question == Question::Distance ||
               later.job.query.question == Question::Distance;
    }
    /// True if the groups of both runs are known.
    [[nodiscard]] bool have_groups() const {
        return check_groups(earlier.job.query, earlier.map) &&
               check_groups(later.job.query, later.map);
    }
};

GroupDiff::Meshes meshes_of(const RunAtHand& run) {
    return {run.job.meshes.begin(), run.job.meshes.end()};
}

std::vector<std::string> body_names(const RunAtHand& run) {
    std::vector<std::string> names;
    for (const ManifestBody& body : run.run.manifest().bodies) {
        names.push_back(body.name);
    }
    return names;
}

/// Checks that a result's bodies exist. Errors: BadInput.
Status check_bodies(const ScenarioResult* result, std::size_t bodies) {
    return result == nullptr || std::max(result->body_a, result->body_b) < bodies
               ? Status(Done{})
               : bad_input("the record of scenario " + std::to_string(result->index) +
                           " names a body that the run does not have");
}

/// Opens diff.csv in the folder, or stdout for -o csv; nothing if neither is asked for.
Result<std::optional<OutputFile>> csv_file(const DiffCommand& command) {
    std::optional<OutputFile> file;
    if (!command.out.empty()) {
        CD_TRY(make_directories(command.out));
        file.emplace(CD_TRY(OutputFile::create(fs::path(command.out) / "diff.csv")));
    } else if (command.output == "csv") {
        file.emplace(OutputFile::standard_output());
    }
    return file;
}

/// Writes diff_groups.csv: a row for each group that is not unchanged.
Status write_groups(const DiffReport& report, const fs::path& dir) {
    auto file = CD_TRY(RowFile::create(dir / "diff_groups.csv",
                                       "state,body_a,part_a,body_b,part_b,scenarios_old,scenarios,"
                                       "pairs_old,pairs," +
                                           std::string(report.has_near ? "near_old,near," : "") +
                                           "worst\n"));
    for (const ChangedGroup& group : report.groups) {
        if (group.state == GroupState::Unchanged) {
            continue;
        }
        CD_TRY(file.add(to_text(group.state),
                        ",",
                        csv_field(report.bodies[group.body_a]),
                        ",",
                        csv_field(group.part_a),
                        ",",
                        csv_field(report.bodies[group.body_b]),
                        ",",
                        csv_field(group.part_b),
                        ",",
                        group.earlier.scenarios,
                        ",",
                        group.later.scenarios,
                        ",",
                        group.earlier.pairs,
                        ",",
                        group.later.pairs,
                        ","));
        if (report.has_near) {
            CD_TRY(file.add(group.earlier.near, ",", group.later.near, ","));
        }
        CD_TRY(file.add(group.worst, "\n"));
    }
    return file.commit();
}

/// Writes diff_triangles.csv: a row for each triangle, of a body with an equal mesh, that is in
/// contact in another number of scenarios.
Status write_triangles(const Compared& runs, TriangleDiff& triangles, const fs::path& dir) {
    auto file = CD_TRY(
        RowFile::create(dir / "diff_triangles.csv", "body,triangle,scenarios_old,scenarios\n"));
    const auto names = body_names(runs.later);
    for (std::size_t body = 0; body < names.size(); ++body) {
        if (!runs.has_equal_mesh(body)) {
            continue;
        }
        for (const TriangleChange& change : triangles.changes(body)) {
            CD_TRY(file.add(csv_field(names[body]),
                            ",",
                            change.triangle,
                            ",",
                            change.earlier,
                            ",",
                            change.later,
                            "\n"));
        }
    }
    return file.commit();
}

/// What is compared of each scenario.
struct Differences {
    ScenarioDiff scenarios;
    GroupDiff groups;
    TriangleDiff triangles;
};

Status compare(Compared& runs, const ScenarioMatch& match, Differences& found) {
    const std::size_t bodies = runs.later.job.meshes.size();
    const bool maps_pairs = runs.maps_pairs();
    const bool have_groups = runs.have_groups();
    const auto apart = apart_pairs(runs.earlier, runs.later);
    return for_each_pair(
        {runs.earlier.run.records(),
         runs.earlier.job.poses->count(),
         apart ? &apart->front() : nullptr},
        {runs.later.run.records(), runs.later.job.poses->count(), apart ? &apart->back() : nullptr},
        match,
        &InterruptGuard::has_come,
        [&](const PairedResult& pair) -> Status {
            CD_TRY(check_bodies(pair.was, bodies));
            CD_TRY(check_bodies(pair.is, bodies));
            if (have_groups) {
                found.groups.add(pair);
            }
            if (maps_pairs) {
                found.triangles.add(pair);
            }
            return found.scenarios.add(pair);
        });
}

/// Adds the contact maps of runs without lists of pairs: their sums by part, and their triangles if
/// both runs tested the same scenarios. Returns whether there are triangles to compare. Errors:
/// BadInput for parts that a body does not have.
Result<bool> add_maps(const Compared& runs, Differences& found) {
    if (runs.have_groups()) {
        CD_TRY(found.groups.add_sums(runs.earlier.sums(), runs.later.sums()));
    }
    const ScenarioCounts& counts = found.scenarios.counts();
    const bool is_complete =
        counts.only_earlier + counts.only_later == 0 && counts.comparable == counts.in_both;
    if (runs.maps_pairs() || !is_complete) {
        return runs.maps_pairs();
    }
    const bool have_maps = runs.earlier.map && runs.later.map;
    if (have_maps) {
        found.triangles.add(*runs.earlier.map, *runs.later.map);
    }
    return have_maps;
}

/// `has_triangles` is what `add_maps` returned.
DiffReport
report_of(const Compared& runs, MatchedBy matched_by, bool has_triangles, Differences& found) {
    DiffReport report;
    report.inputs = runs.inputs;
    report.matched_by = matched_by;
    report.scenarios = found.scenarios.counts();
    report.bodies = body_names(runs.later);
    report.has_groups = runs.have_groups();
    report.has_near = runs.has_near();
    if (report.has_groups) {
        report.lists_are_cut =
            runs.earlier.job.query.limit_pairs != 0 || runs.later.job.query.limit_pairs != 0;
        report.groups = found.groups.groups();
        report.has_lasting_names = found.groups.has_lasting_names();
        report.are_sums_comparable = found.groups.are_sums_comparable();
        report.left_out = found.groups.left_out();
    }
    for (std::size_t body = 0; body < report.bodies.size(); ++body) {
        if (has_triangles && runs.has_equal_mesh(body)) {
            report.triangles.push_back({report.bodies[body], found.triangles.counts(body)});
        }
    }
    return report;
}

Result<ScenarioMatch> match(const Compared& runs) {
    return match_runs(runs.earlier.matched(),
                      runs.later.matched(),
                      runs.inputs.are_poses_equal,
                      &InterruptGuard::has_come);
}

Status print(const DiffCommand& command, const DiffReport& report) {
    const std::string text = command.output == "json" ? diff_json(report) : diff_text(report);
    if (command.output == "csv") { // Stdout has the rows.
        std::fputs(text.c_str(), stderr);
        return Done{};
    }
    OutputFile out = OutputFile::standard_output();
    CD_TRY(out.write(text));
    return out.commit();
}

/// Says why two runs may have no scenario in common; empty if nothing is known of it.
const char* hint_of(const Compared& runs) {
    const auto is_random = [](const RunAtHand& run) {
        return run.run.manifest().poses.kind == PosesKind::Random;
    };
    return is_random(runs.earlier) && is_random(runs.later) && !runs.have_equal_meshes()
               ? "; random poses depend on the bodies: runs of a grid or of one pose file can be "
                 "compared"
               : "";
}

int exit_code_of(const Compared& runs, const DiffReport& report, DiffFailOn fail_on) {
    const ScenarioCounts& counts = report.scenarios;
    if (counts.comparable == 0) {
        std::fprintf(stderr,
                     "cdctl: nothing to compare: no scenario has a class in both runs%s\n",
                     hint_of(runs));
        return exit_incomplete;
    }
    if (fail_on == DiffFailOn::Never) {
        return exit_done;
    }
    const bool fails =
        fail_on == DiffFailOn::Any ? report.has_changes() : report.count(GroupState::New) != 0;
    // What was not tested leaves the question open.
    return fails                                 ? exit_contacts
           : counts.comparable == counts.in_both ? exit_done
                                                 : exit_incomplete;
}

} // namespace

Result<int> perform(const DiffCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    ThreadPool pool(command.threads);
    const auto open = [&](const std::string& run) {
        return open_run_at_hand(run, command.master, command.tree_cache, {.map = true}, pool);
    };
    auto earlier = CD_TRY(open(command.earlier));
    auto later = CD_TRY(open(command.later));
    CD_TRY(check_comparable(earlier.run.manifest(), later.run.manifest()));
    Compared runs{earlier, later, changes_between(earlier.run.manifest(), later.run.manifest())};
    if (command.fail_on == DiffFailOn::New) {
        CD_TRY(within("--fail-on new: " + command.earlier + ": ",
                      check_groups(earlier.job.query, earlier.map)));
        CD_TRY(within("--fail-on new: " + command.later + ": ",
                      check_groups(later.job.query, later.map)));
    }
    InterruptGuard::begin_to_flag(); // From here on, a signal must not leave partial files.
    const auto matched = CD_TRY(match(runs));
    auto csv = CD_TRY(csv_file(command));
    const bool compares_pairs = runs.inputs.query.empty() && runs.have_equal_meshes();
    Differences found{
        ScenarioDiff(std::move(csv),
                     {compares_pairs, body_names(later), runs.has_near(), runs.has_distance()}),
        GroupDiff(meshes_of(earlier), meshes_of(later), part_kind(runs.least_level())),
        {}};
    CD_TRY(compare(runs, matched, found));
    const bool has_triangles = CD_TRY(add_maps(runs, found));
    const DiffReport report = report_of(runs, matched.by(), has_triangles, found);
    CD_TRY(found.scenarios.finish());
    if (!command.out.empty()) {
        CD_TRY(write_groups(report, command.out));
        CD_TRY(write_triangles(runs, found.triangles, command.out));
    }
    CD_TRY(print(command, report));
    return exit_code_of(runs, report, command.fail_on);
}

} // namespace cd
