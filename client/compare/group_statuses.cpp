#include "client/compare/group_statuses.hpp"

#include "common/core/words.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace cd {

namespace {

constexpr std::array<std::string_view, 7> status_names{
    "", "new", "active", "resolved", "not comparable", "reviewed", "approved"};

/// What makes a group the same in two runs.
using SameGroup = std::tuple<std::uint32_t, std::uint32_t, std::string, std::string>;

SameGroup names_of(const Group& group) {
    return {group.body_a, group.body_b, group.part_a, group.part_b};
}

bool matches(const StatusRule& rule, const Group& group, const std::vector<std::string>& bodies) {
    return rule.a.is_of_body(bodies[group.body_a]) && rule.a.is_of_part(group.part_a) &&
           rule.b.is_of_body(bodies[group.body_b]) && rule.b.is_of_part(group.part_b);
}

/// Applies a rule that matches a group.
void apply_rule(const StatusRule& rule, JudgedGroup& group) {
    const std::uint64_t most =
        rule.pairs_max.value_or(group.is_in_baseline ? 2 * group.baseline_worst_pairs : UINT64_MAX);
    const std::string word = rule.is_approved ? "approved" : "reviewed";
    group.note = rule.note;
    if (group.group.worst_pairs <= most) {
        group.status = rule.is_approved ? GroupStatus::Approved : GroupStatus::Reviewed;
        return;
    }
    group.note += (group.note.empty() ? "" : "; ") + word + " up to " + counted(most, "pair") +
                  ", now " + grouped(group.group.worst_pairs) + " in scenario " +
                  std::to_string(group.group.worst);
}

} // namespace

std::string_view to_text(GroupStatus status) {
    return status_names[static_cast<std::size_t>(status)];
}

GroupStatuses::GroupStatuses(const std::vector<Group>& groups,
                             const Baseline* baseline,
                             const std::vector<StatusRule>& rules,
                             const std::vector<std::string>& bodies) {
    for (const Group& group : groups) {
        groups_.push_back({group});
    }
    if (baseline != nullptr) {
        add_baseline(*baseline);
    }
    apply(rules, bodies);
}

void GroupStatuses::add_baseline(const Baseline& baseline) {
    std::map<SameGroup, std::size_t> places;
    for (JudgedGroup& group : groups_) {
        group.status = GroupStatus::New;
        places.emplace(names_of(group.group), places.size());
    }
    for (const Group& group : baseline.groups) {
        const auto found = places.find(names_of(group));
        const bool is_here = found != places.end();
        JudgedGroup& judged = is_here ? groups_[found->second] : groups_.emplace_back();
        judged.is_in_baseline = true;
        judged.baseline_worst_pairs = group.worst_pairs;
        if (is_here) {
            judged.status = GroupStatus::Active;
        } else {
            judged.group = group;
            judged.status =
                baseline.is_resolved(group) ? GroupStatus::Resolved : GroupStatus::NotComparable;
        }
    }
}

void GroupStatuses::apply(const std::vector<StatusRule>& rules,
                          const std::vector<std::string>& bodies) {
    std::vector<bool> is_used(rules.size(), false);
    for (JudgedGroup& group : groups_) {
        const StatusRule* last = nullptr;
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (matches(rules[i], group.group, bodies)) {
                is_used[i] = true;
                last = &rules[i];
            }
        }
        if (last != nullptr && !group.is_gone()) {
            apply_rule(*last, group);
        }
    }
    for (std::size_t i = 0; i < rules.size(); ++i) {
        if (!is_used[i]) {
            warnings_.push_back(rules[i].place + " matches no group");
        }
    }
}

std::uint64_t GroupStatuses::count(GroupStatus status) const {
    return static_cast<std::uint64_t>(std::ranges::count(groups_, status, &JudgedGroup::status));
}

bool GroupStatuses::is_news(const JudgedGroup& group) {
    return !group.is_in_baseline && group.status != GroupStatus::Approved;
}

bool GroupStatuses::has_news() const {
    return std::ranges::any_of(groups_, is_news);
}

std::vector<GroupRow> rows_of(const GroupStatuses& statuses) {
    std::vector<GroupRow> rows;
    for (const JudgedGroup& group : statuses.groups()) {
        rows.push_back(
            {group.group, std::string(to_text(group.status)), group.note, group.is_gone()});
    }
    return rows;
}

} // namespace cd
