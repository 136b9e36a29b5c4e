#include "client/compare/diff_report.hpp"

#include "common/core/printable.hpp"
#include "common/core/words.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cd {

namespace {

using Json = nlohmann::ordered_json;

/// Groups of one state that the text shows.
constexpr std::uint64_t groups_shown_max = 20;

std::string scenarios_text(const DiffReport& report) {
    const ScenarioCounts& counts = report.scenarios;
    std::string text = "  scenarios     " + grouped(counts.in_both) + " in both, matched by " +
                       std::string(to_text(report.matched_by));
    text += counts.only_earlier == 0 ? "" : "; " + grouped(counts.only_earlier) + " only in OLD";
    text += counts.only_later == 0 ? "" : "; " + grouped(counts.only_later) + " only in NEW";
    text += counts.apart == 0
                ? ""
                : "; " + grouped(counts.apart) + " of them apart by their boxes in one run";
    const std::uint64_t rest = counts.in_both - counts.comparable;
    text += rest == 0 ? "" : "; " + grouped(rest) + " failed, undecided or without result";
    return text + "\n  changed       " + grouped(counts.changed) + " of " +
           grouped(counts.in_both) + "\n";
}

/// Returns the matrix of outcomes, without rows and columns of zeros.
std::string outcomes_text(const ScenarioCounts& counts) {
    Table table;
    table.columns.push_back({"was", "OLD \\ NEW"});
    std::array<std::uint64_t, outcome_kinds> sums{};
    for (const auto& row : counts.outcomes) {
        for (std::size_t i = 0; i < outcome_kinds; ++i) {
            sums[i] += row[i];
        }
    }
    for (std::size_t i = 0; i < outcome_kinds; ++i) {
        if (sums[i] != 0) {
            const std::string name(outcome_name(i));
            table.columns.push_back({name, name, CellKind::Count});
        }
    }
    for (std::size_t was = 0; was < outcome_kinds; ++was) {
        const auto& row = counts.outcomes[was];
        if (std::ranges::all_of(row, [](std::uint64_t count) { return count == 0; })) {
            continue;
        }
        std::vector<Cell>& cells = table.rows.emplace_back();
        cells.emplace_back(std::string(outcome_name(was)));
        for (std::size_t is = 0; is < outcome_kinds; ++is) {
            if (sums[is] != 0) {
                cells.emplace_back(row[is]);
            }
        }
    }
    return table_text(table, false, "    ");
}

std::string counts_text(const GroupCounts& counts) {
    return counted(counts.scenarios, "scenario") + ", " + counted(counts.pairs, "pair") +
           (counts.near == 0 ? "" : ", " + counted(counts.near, "near pair"));
}

/// Names the part of a group's body; in a scene with the body before it.
std::string part_name(const DiffReport& report, std::uint32_t body, const std::string& part) {
    return (report.bodies.size() > 2 ? escaped(report.bodies[body]) + "/" : "") + escaped(part);
}

std::string group_text(const DiffReport& report, const ChangedGroup& group) {
    const bool has_earlier = group.earlier.scenarios != 0;
    const bool has_later = group.later.scenarios != 0;
    std::string text = "    " + std::string(to_text(group.state)) + ": " +
                       part_name(report, group.body_a, group.part_a) + " x " +
                       part_name(report, group.body_b, group.part_b) + ": ";
    text += has_earlier && has_later
                ? counts_text(group.later) + "; was " + counts_text(group.earlier)
                : counts_text(has_later ? group.later : group.earlier);
    return text + ", most in #" + std::to_string(group.worst) + "\n";
}

std::string groups_text(const DiffReport& report) {
    if (!report.has_groups) {
        return "  groups        not compared: they need level pairs or contacts, or level count "
               "with maps\n";
    }
    std::string text;
    std::string lines;
    for (std::size_t i = 0; i < group_states; ++i) {
        const auto state = static_cast<GroupState>(i);
        const std::uint64_t count = report.count(state);
        if (count != 0) {
            text += (text.empty() ? "  groups        " : ", ") + grouped(count) + " " +
                    std::string(to_text(state));
        }
        std::uint64_t shown = 0;
        for (const ChangedGroup& group : report.groups) {
            if (group.state == state && state != GroupState::Unchanged &&
                shown++ < groups_shown_max) {
                lines += group_text(report, group);
            }
        }
        if (shown > groups_shown_max) {
            lines += "    and " + grouped(shown - groups_shown_max) + " more; see -o json\n";
        }
    }
    text += text.empty() ? "  groups        none\n" : "\n";
    if (report.lists_are_cut) {
        text += "                of the first limit_pairs pairs a scenario\n";
    }
    if (!report.are_sums_comparable) {
        text +=
            "                of all scenarios of each run, which level count cannot tell apart: "
            "not comparable\n";
    }
    if (!report.has_lasting_names) {
        text +=
            "                piece N is a connected piece: a changed mesh may number its pieces "
            "otherwise\n";
    }
    if (report.left_out != 0) {
        text += "                " + counted(report.left_out, "pair") +
                " left out, since there are too many groups\n";
    }
    return text + lines;
}

std::string triangles_text(const DiffReport& report) {
    std::string text;
    for (const BodyTriangles& each : report.triangles) {
        text += (text.empty() ? "  triangles     " : "                ") + each.body +
                (report.has_near ? ": in contact or near " : ": in contact ") +
                grouped(each.counts.in_both) + " in both, " + grouped(each.counts.only_earlier) +
                " only in OLD, " + grouped(each.counts.only_later) + " only in NEW\n";
    }
    return text;
}

Json outcomes_json(const ScenarioCounts& counts) {
    Json json = Json::object();
    for (std::size_t was = 0; was < outcome_kinds; ++was) {
        for (std::size_t is = 0; is < outcome_kinds; ++is) {
            if (counts.outcomes[was][is] != 0) {
                json[std::string(outcome_name(was))][std::string(outcome_name(is))] =
                    counts.outcomes[was][is];
            }
        }
    }
    return json;
}

Json inputs_json(const DiffReport& report) {
    Json bodies = Json::array();
    for (std::size_t i = 0; i < report.inputs.bodies.size(); ++i) {
        const BodyChange& body = report.inputs.bodies[i];
        bodies.push_back({{"name", report.bodies[i]},
                          {"changed", body.is_changed},
                          {"parts", body.parts},
                          {"parts_new", body.parts_new},
                          {"parts_gone", body.parts_gone}});
    }
    return {{"text", changes_text(report.inputs)},
            {"bodies", std::move(bodies)},
            {"poses_equal", report.inputs.are_poses_equal},
            {"query_changes", report.inputs.query}};
}

Json group_json(const DiffReport& report, const ChangedGroup& group) {
    const auto counts = [&](const GroupCounts& sums) {
        Json json{{"scenarios", sums.scenarios}, {"pairs", sums.pairs}};
        if (report.has_near) {
            json["near"] = sums.near;
        }
        return json;
    };
    return {{"state", to_text(group.state)},
            {"body_a", report.bodies[group.body_a]},
            {"part_a", group.part_a},
            {"body_b", report.bodies[group.body_b]},
            {"part_b", group.part_b},
            {"old", counts(group.earlier)},
            {"new", counts(group.later)},
            {"worst", group.worst}};
}

} // namespace

std::uint64_t DiffReport::count(GroupState state) const {
    return static_cast<std::uint64_t>(std::ranges::count(groups, state, &ChangedGroup::state));
}

bool DiffReport::has_changes() const {
    return scenarios.changed != 0 || std::ranges::any_of(groups, [](const ChangedGroup& group) {
               return group.state != GroupState::Unchanged &&
                      group.state != GroupState::NotComparable;
           });
}

std::string diff_text(const DiffReport& report) {
    return changes_text(report.inputs) + "\n" + scenarios_text(report) +
           outcomes_text(report.scenarios) + groups_text(report) + triangles_text(report);
}

std::string diff_json(const DiffReport& report) {
    const ScenarioCounts& counts = report.scenarios;
    Json groups = Json::array();
    for (const ChangedGroup& group : report.groups) {
        groups.push_back(group_json(report, group));
    }
    Json triangles = Json::array();
    for (const BodyTriangles& each : report.triangles) {
        triangles.push_back({{"body", each.body},
                             {"both", each.counts.in_both},
                             {"only_old", each.counts.only_earlier},
                             {"only_new", each.counts.only_later}});
    }
    return json_text(Json{{"inputs", inputs_json(report)},
                          {"matched_by", to_text(report.matched_by)},
                          {"both", counts.in_both},
                          {"apart", counts.apart},
                          {"only_old", counts.only_earlier},
                          {"only_new", counts.only_later},
                          {"comparable", counts.comparable},
                          {"changed", counts.changed},
                          {"classes", outcomes_json(counts)},
                          {"groups", report.has_groups ? std::move(groups) : Json()},
                          {"triangles", std::move(triangles)}},
                     1);
}

} // namespace cd
