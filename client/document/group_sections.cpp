#include "client/document/group_sections.hpp"

#include "client/groups/wilson.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/printable.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace cd {

namespace {

double fraction_of(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string regions_text(const Group& group) {
    return group.regions[0] == 0 ? "-"
                                 : grouped(group.regions[0]) + " / " + grouped(group.regions[1]);
}

/// The column of near pairs, behind that of pairs in contact.
constexpr std::ptrdiff_t near_column = 6;

std::string worst_text(const Group& group, const std::string& label) {
    return label + ", " + counted(group.worst_pairs, "pair") +
           (group.near.worst_pairs == 0 ? "" : ", " + grouped(group.near.worst_pairs) + " near");
}

/// Returns a class of the style sheet for a cell of the matrix: darker for a larger share of the
/// largest.
std::string shade_of(std::uint64_t count, std::uint64_t most) {
    const double share = fraction_of(count, most);
    return count == 0 ? "h0" : share > 0.5 ? "h4" : share > 0.1 ? "h3" : share > 0.01 ? "h2" : "h1";
}

/// A body's number, and the name of one of its parts.
using PartKey = std::pair<std::uint32_t, std::string>;

/// Returns the parts that occur in most scenarios, at most `report_parts_max`.
std::vector<PartKey> most_frequent(const std::map<PartKey, std::uint64_t>& scenarios) {
    std::vector<std::pair<PartKey, std::uint64_t>> parts(scenarios.begin(), scenarios.end());
    std::ranges::stable_sort(
        parts, [](const auto& left, const auto& right) { return left.second > right.second; });
    parts.resize(std::min(parts.size(), limits::report_parts_max));
    std::vector<PartKey> keys;
    for (auto& [key, count] : parts) {
        keys.push_back(std::move(key));
    }
    return keys;
}

std::string shown(const std::string& text) {
    return std::string(utf8_prefix(text, limits::report_text_bytes_max));
}

/// Returns the first warnings, and how many more there are.
Html warnings_of(const BaselineNote& baseline) {
    const std::size_t all = baseline.warnings.size();
    const std::size_t some = std::min(all, limits::report_warnings_max);
    Html content;
    for (std::size_t i = 0; i < some; ++i) {
        content += paragraph(shown(baseline.warnings[i]), "warning");
    }
    if (all > some) {
        content += paragraph("And " + grouped(all - some) + " more.", "warning");
    }
    return content;
}

} // namespace

Html GroupSections::matrix() const {
    std::map<PartKey, std::uint64_t> of_a;
    std::map<PartKey, std::uint64_t> of_b;
    std::map<std::pair<PartKey, PartKey>, std::uint64_t> cells;
    std::uint64_t most = 0;
    for (const JudgedGroup& judged : statuses_.groups()) {
        if (judged.is_gone()) {
            continue;
        }
        const Group& group = judged.group;
        const PartKey a{group.body_a, group.part_a};
        const PartKey b{group.body_b, group.part_b};
        of_a[a] += group.scenarios;
        of_b[b] += group.scenarios;
        most = std::max(most, cells[{a, b}] += group.scenarios);
    }
    if (cells.empty()) {
        return {};
    }
    const auto rows = most_frequent(of_a);
    const auto columns = most_frequent(of_b);
    Html head = Html::element("th", "A \\ B");
    for (const auto& [body, part] : columns) {
        head += Html::element("th", names_.part_name(body, part));
    }
    Html lines = Html::element("thead", Html::element("tr", head));
    for (const PartKey& row : rows) {
        Html line = Html::element("td", names_.part_name(row.first, row.second));
        for (const PartKey& column : columns) {
            const auto found = cells.find({row, column});
            const std::uint64_t count = found == cells.end() ? 0 : found->second;
            line += Html::element(
                "td", count == 0 ? "" : grouped(count), {{"class", shade_of(count, most)}});
        }
        lines += Html::element("tr", line);
    }
    Html content = paragraph("In how many scenarios a part of A (rows) and a part of B (columns) "
                             "are in contact" +
                             std::string(manifest_.query.clearance ? " or near." : "."));
    content += Html::element("table", lines, {{"class", "numbers"}});
    if (of_a.size() > rows.size() || of_b.size() > columns.size()) {
        content += paragraph("Only the parts in most scenarios are shown; groups.csv has all.");
    }
    return html_section("Parts in contact", content);
}

std::string GroupSections::share_of(const JudgedGroup& judged) const {
    if (manifest_.query.limit_pairs != 0 || judged.is_gone()) {
        return "-"; // Pairs that are not listed may be of the group in more scenarios.
    }
    const std::uint64_t scenarios = judged.group.scenarios;
    const std::uint64_t tested = overview_.summary().tested();
    std::string text = fixed_text(100 * fraction_of(scenarios, tested), 2) + " %";
    if (is_of_file()) {
        const ShareInterval interval = wilson_interval(scenarios, tested);
        text += " (" + fixed_text(100 * interval.low, 2) + " to " +
                fixed_text(100 * interval.high, 2) + ")";
    }
    return text;
}

std::vector<Html> GroupSections::row_of(const JudgedGroup& judged, bool has_status) const {
    const Group& group = judged.group;
    // The scenarios of a group that is gone are the baseline's, which has other labels.
    const auto label = [&](std::uint64_t scenario) {
        return judged.is_gone() ? "#" + std::to_string(scenario) + " of the baseline"
                                : names_.label_of(scenario);
    };
    std::vector<std::string> cells{names_.part_name(group.body_a, group.part_a),
                                   names_.part_name(group.body_b, group.part_b),
                                   std::string(to_text(group.kind)),
                                   grouped(group.scenarios),
                                   share_of(judged),
                                   grouped(group.pairs),
                                   worst_text(group, label(group.worst)),
                                   regions_text(group)};
    if (manifest_.query.clearance) {
        cells.insert(cells.begin() + near_column, grouped(group.near.pairs));
    }
    if (is_of_file()) {
        cells.push_back(group.episodes.count == 0 ? "-" : grouped(group.episodes.count));
        cells.push_back(label(group.episodes.first.front().first));
        cells.push_back(label(group.episodes.last));
    }
    if (has_status) {
        cells.emplace_back(to_text(judged.status));
        cells.push_back(short_name(judged.note));
    }
    return html_texts(cells);
}

Html GroupSections::table() const {
    const auto& judged = statuses_.groups();
    const std::uint64_t inside = overview_.groups().inside();
    const Html no_group =
        inside == 0 ? Html()
                    : paragraph(counted(inside, "scenario") + " inside: no triangles meet, so they "
                                                              "are in no group.",
                                "warning");
    if (judged.empty()) {
        return inside == 0 ? Html() : html_section("Groups", no_group);
    }
    const bool has_status = std::ranges::any_of(
        judged, [](const JudgedGroup& each) { return each.status != GroupStatus::Unjudged; });
    std::vector<std::string> head{
        "part of A", "part of B", "class", "scenarios", "share", "pairs", "worst", "regions A / B"};
    if (manifest_.query.clearance) {
        head.insert(head.begin() + near_column, "near pairs");
    }
    if (is_of_file()) {
        head.insert(head.end(), {"episodes", "first", "last"});
    }
    if (has_status) {
        head.insert(head.end(), {"status", "note"});
    }
    std::vector<std::vector<Html>> rows{html_texts(head)};
    for (std::size_t i = 0; i < judged.size() && i < limits::report_groups_max; ++i) {
        rows.push_back(row_of(judged[i], has_status));
    }
    Html content = no_group;
    content += html_table(rows, "groups");
    if (judged.size() > limits::report_groups_max) {
        content += paragraph("The table has the first " + grouped(limits::report_groups_max) +
                             " of " + counted(judged.size(), "group") + "; groups.csv has all.");
    }
    if (overview_.groups().left_out() != 0) {
        content += paragraph(counted(overview_.groups().left_out(), "pair") +
                                 " of triangles are in no group, since there are too many groups.",
                             "warning");
    }
    const std::string state = manifest_.query.clearance ? "in contact or near" : "in contact";
    content += paragraph("Severity is the number of pairs of triangles, not a depth. A region is a "
                         "connected set of triangles " +
                         state + " in any scenario.");
    if (manifest_.query.level == Level::Count) {
        content += paragraph("Pairs were summed where the scenarios ran, by named part. So regions "
                             "and episodes are unknown, and contact is touch or, without a pair "
                             "whose triangles go through each other, cross.");
    }
    if (is_of_file()) {
        content += paragraph("Behind a share is its 95 % interval (Wilson), if the poses are a "
                             "random sample. An episode is a run of consecutive scenarios.");
    }
    return html_section("Groups", content);
}

Html GroupSections::against(const BaselineNote& baseline) const {
    Html content = warnings_of(baseline);
    if (baseline.name.empty()) {
        return content.is_empty() ? content : html_section("Statuses", content);
    }
    content +=
        paragraph("The baseline is " + shown(baseline.name) + ", digest " + baseline.digest + ".");
    std::vector<std::string> head;
    std::vector<std::string> counts;
    for (const GroupStatus status : judged_statuses) {
        head.emplace_back(to_text(status));
        counts.push_back(grouped(statuses_.count(status)));
    }
    content += html_table({html_texts(head), html_texts(counts)}, "counts");
    content += paragraph(statuses_.has_news()
                             ? "There are groups that the baseline does not have and that nobody "
                               "approved."
                             : "All groups are in the baseline or approved.",
                         statuses_.has_news() ? "bad" : "good");
    return html_section("Against the baseline", content);
}

} // namespace cd
