#include "client/compare/group_diff.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// A group's sums in the scenarios that both runs tested, and in the others.
struct Sums {
    GroupCounts tested;
    GroupCounts rest;
    std::uint64_t worst = 0;
    GroupCounts worst_counts; ///< Of `worst`.

    [[nodiscard]] bool exist() const { return tested.scenarios + rest.scenarios != 0; }
    [[nodiscard]] GroupCounts all() const {
        return {
            tested.scenarios + rest.scenarios, tested.pairs + rest.pairs, tested.near + rest.near};
    }
};

struct BothSums {
    Sums earlier;
    Sums later;
};

/// The bodies and the names of the parts.
using GroupKey = std::tuple<std::uint32_t, std::uint32_t, std::string, std::string>;
using GroupTable = std::map<GroupKey, BothSums>;

void collect(const GroupSum& sum,
             Sums BothSums::*run,
             GroupCounts Sums::*counts,
             GroupTable& table) {
    for (const Group& group : sum.groups()) {
        Sums& sums = table[{group.body_a, group.body_b, group.part_a, group.part_b}].*run;
        sums.*counts = {group.scenarios, group.pairs, group.near.pairs};
        const GroupCounts worst{1, group.worst_pairs, group.near.worst_pairs};
        if (worst > sums.worst_counts) {
            sums.worst = group.worst;
            sums.worst_counts = worst;
        }
    }
}

GroupState state_of(const BothSums& sums, bool are_comparable) {
    const GroupCounts& was = sums.earlier.tested;
    const GroupCounts& is = sums.later.tested;
    if (!sums.earlier.exist()) {
        return GroupState::New;
    }
    if (!sums.later.exist()) {
        return sums.earlier.rest.scenarios == 0 ? GroupState::Resolved : GroupState::NotComparable;
    }
    if (!are_comparable || was.scenarios + is.scenarios == 0) {
        return GroupState::NotComparable;
    }
    return is > was ? GroupState::Grown : is < was ? GroupState::Shrunk : GroupState::Unchanged;
}

ChangedGroup changed_group(const GroupKey& key, const BothSums& sums, bool are_comparable) {
    ChangedGroup group;
    std::tie(group.body_a, group.body_b, group.part_a, group.part_b) = key;
    group.state = state_of(sums, are_comparable);
    const bool over_all =
        group.state == GroupState::New || group.state == GroupState::NotComparable;
    group.earlier = over_all ? sums.earlier.all() : sums.earlier.tested;
    group.later = over_all ? sums.later.all() : sums.later.tested;
    group.worst = sums.later.exist() ? sums.later.worst : sums.earlier.worst;
    return group;
}

} // namespace

std::string_view to_text(GroupState state) {
    constexpr std::array<std::string_view, group_states> names{
        "new", "grown", "shrunk", "resolved", "not comparable", "unchanged"};
    return names[static_cast<std::size_t>(state)];
}

GroupDiff::GroupDiff(const Meshes& earlier, const Meshes& later, PartKind kind)
    : bodies_(later.size()),
      earlier_{GroupSum(earlier, kind), GroupSum(earlier, kind)},
      later_{GroupSum(later, kind), GroupSum(later, kind)} {}

void GroupDiff::add(const PairedResult& pair) {
    const auto add_to = [&](Run& run, const ScenarioResult* result) {
        if (result == nullptr) {
            return;
        }
        if (pair.is_comparable()) {
            return run.tested.add(*result);
        }
        run.rest.add(*result);
        run.rest_is_in_contact =
            run.rest_is_in_contact || result->pair_count + result->near_count != 0;
    };
    add_to(earlier_, pair.was);
    add_to(later_, pair.is);
}

Status GroupDiff::add_sums(Run& run, const PartContacts* sums) {
    run.has_sums = sums != nullptr;
    return sums == nullptr ? Status(Done{})
                           : (run.rest_is_in_contact ? run.rest : run.tested).add(*sums);
}

Status GroupDiff::add_sums(const PartContacts* earlier, const PartContacts* later) {
    CD_TRY(add_sums(earlier_, earlier));
    return add_sums(later_, later);
}

bool GroupDiff::are_sums_comparable() const {
    return !(earlier_.has_sums && earlier_.rest_is_in_contact) &&
           !(later_.has_sums && later_.rest_is_in_contact);
}

std::vector<ChangedGroup> GroupDiff::groups() const {
    GroupTable table;
    collect(earlier_.tested, &BothSums::earlier, &Sums::tested, table);
    collect(earlier_.rest, &BothSums::earlier, &Sums::rest, table);
    collect(later_.tested, &BothSums::later, &Sums::tested, table);
    collect(later_.rest, &BothSums::later, &Sums::rest, table);
    std::vector<ChangedGroup> groups;
    for (const auto& [key, sums] : table) {
        groups.push_back(changed_group(key, sums, are_sums_comparable()));
    }
    std::ranges::stable_sort(groups, [](const ChangedGroup& left, const ChangedGroup& right) {
        const auto size = [](const ChangedGroup& group) {
            return std::max(group.earlier, group.later);
        };
        return std::pair(left.state, size(right)) < std::pair(right.state, size(left));
    });
    return groups;
}

bool GroupDiff::has_lasting_names() {
    bool last = true;
    for (Run* run : {&earlier_, &later_}) {
        for (std::size_t body = 0; body < bodies_; ++body) {
            last = last && run->tested.parts(body).has_lasting_names();
        }
    }
    return last;
}

std::uint64_t GroupDiff::left_out() const {
    return earlier_.tested.left_out() + earlier_.rest.left_out() + later_.tested.left_out() +
           later_.rest.left_out();
}

} // namespace cd
