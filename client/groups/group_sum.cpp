#include "client/groups/group_sum.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/limits/engine.hpp"
#include "common/geometry/topology.hpp"
#include "common/job/result/contact_map.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// Below this number of unsorted triangles, sorting does not pay.
constexpr std::size_t unsorted_min = 1024;

constexpr std::uint32_t no_group = UINT32_MAX;

void sort_each_once(std::vector<std::uint32_t>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

bool has_proper(std::span<const ContactPair> pairs) {
    return std::ranges::any_of(
        pairs, [](const ContactPair& pair) { return pair.kind == PairClass::Proper; });
}

/// Returns the class of a group after one more scenario.
ScenarioClass class_with(const Group& group, bool is_cross) {
    return is_cross || group.kind == ScenarioClass::Cross ? ScenarioClass::Cross
           : group.pairs != 0                             ? ScenarioClass::Touch
                                                          : ScenarioClass::Near;
}

/// Extends the last episode by a scenario, or begins a new one.
void add_to(GroupEpisodes& episodes, std::uint64_t scenario) {
    const bool goes_on = episodes.count != 0 && episodes.last + 1 == scenario;
    episodes.count += goes_on ? 0 : 1;
    episodes.last = scenario;
    if (episodes.count > limits::group_episodes_max) {
        return;
    }
    if (!goes_on) {
        episodes.first.push_back({scenario, scenario});
    }
    episodes.first.back().last = scenario;
}

} // namespace

bool is_same(const Group& left, const Group& right) {
    return left.body_a == right.body_a && left.body_b == right.body_b &&
           left.part_a == right.part_a && left.part_b == right.part_b;
}

GroupSum::GroupSum(std::vector<std::shared_ptr<const Mesh>> meshes, PartKind kind)
    : meshes_(std::move(meshes)), kind_(kind) {}

void GroupSum::find_parts() {
    std::uint64_t parts = 0;
    for (std::size_t i = 0; bodies_.size() < meshes_.size(); ++i) {
        const auto has_mesh = [&](const auto& mesh) { return mesh->hash() == meshes_[i]->hash(); };
        const auto same =
            static_cast<std::size_t>(std::ranges::find_if(meshes_, has_mesh) - meshes_.begin());
        Body body;
        body.parts =
            same < i ? bodies_[same].parts : std::make_shared<const BodyParts>(*meshes_[i], kind_);
        body.first_part = parts;
        body.scenarios.assign(body.parts->count(), 0);
        body.last_seen.assign(body.parts->count(), 0);
        body.last_group.assign(meshes_[i]->triangles().size(), no_group);
        parts += body.parts->count();
        bodies_.push_back(std::move(body));
    }
}

const BodyParts& GroupSum::parts(std::size_t body) {
    find_parts();
    return *bodies_[body].parts;
}

void GroupSum::note_part(Body& body, std::uint32_t part) const {
    if (body.last_seen[part] != stamp_) {
        body.last_seen[part] = stamp_;
        ++body.scenarios[part];
    }
}

std::optional<std::uint32_t> GroupSum::group_of(const ScenarioResult& result,
                                                const ContactPair& pair) {
    Body& a = bodies_[result.body_a];
    Body& b = bodies_[result.body_b];
    const std::array<std::uint32_t, 2> part{a.parts->part_of(pair.a), b.parts->part_of(pair.b)};
    note_part(a, part[0]);
    note_part(b, part[1]);
    return number_of({result.body_a, result.body_b}, part);
}

std::optional<std::uint32_t> GroupSum::number_of(std::array<std::uint32_t, 2> bodies,
                                                 std::array<std::uint32_t, 2> part) {
    const std::uint64_t key =
        (bodies_[bodies[0]].first_part + part[0]) << 32 | (bodies_[bodies[1]].first_part + part[1]);
    if (const auto found = numbers_.find(key); found != numbers_.end()) {
        return found->second;
    }
    if (sums_.size() == limits::groups_max) {
        return std::nullopt;
    }
    Sum sum;
    sum.part = part;
    sum.group.body_a = bodies[0];
    sum.group.body_b = bodies[1];
    sums_.push_back(std::move(sum));
    return numbers_.emplace(key, static_cast<std::uint32_t>(sums_.size() - 1)).first->second;
}

void GroupSum::note_pair(const ScenarioResult& result,
                         const ContactPair& pair,
                         std::uint32_t number) {
    Sum& sum = sums_[number];
    if (sum.stamp != stamp_) {
        sum.stamp = stamp_;
        sum.pairs_here = 0;
        sum.near_here = 0;
        sum.is_proper_here = false;
        here_.push_back(number);
    }
    ++(pair.kind == PairClass::Near ? sum.near_here : sum.pairs_here);
    sum.is_proper_here = sum.is_proper_here || pair.kind == PairClass::Proper;
    std::uint32_t& last_of_a = bodies_[result.body_a].last_group[pair.a];
    std::uint32_t& last_of_b = bodies_[result.body_b].last_group[pair.b];
    if (std::exchange(last_of_a, number) != number) {
        note_triangle(sum, 0, pair.a);
    }
    if (std::exchange(last_of_b, number) != number) {
        note_triangle(sum, 1, pair.b);
    }
}

void GroupSum::note_triangle(Sum& sum, std::size_t side, std::uint32_t triangle) {
    if (!counts_regions_) {
        return;
    }
    std::vector<std::uint32_t>& touched = sum.touched[side];
    touched.push_back(triangle);
    ++triangles_;
    if (touched.size() > 2 * sum.sorted[side] + unsorted_min) {
        sort_touched(sum, side);
    }
}

void GroupSum::sort_touched(Sum& sum, std::size_t side) {
    std::vector<std::uint32_t>& touched = sum.touched[side];
    triangles_ -= touched.size();
    sort_each_once(touched);
    triangles_ += touched.size();
    sum.sorted[side] = touched.size();
}

void GroupSum::limit_triangles() {
    if (triangles_ <= limits::group_triangles_max) {
        return;
    }
    for (Sum& sum : sums_) {
        sort_touched(sum, 0);
        sort_touched(sum, 1);
    }
    // Half of the room must be free again, or the next results would soon sort everything anew.
    counts_regions_ = triangles_ <= limits::group_triangles_max / 2;
    for (Sum& sum : sums_) {
        if (!counts_regions_) {
            sum.touched = {};
        }
    }
    triangles_ = counts_regions_ ? triangles_ : 0;
}

void GroupSum::add(const ScenarioResult& result) {
    inside_ += result.kind == ScenarioClass::Inside ? 1 : 0;
    const std::vector<ContactPair> crossings = crossings_of(result);
    const std::vector<ContactPair>& pairs = result.hits.empty() ? result.pairs : crossings;
    if (pairs.empty()) {
        return;
    }
    find_parts();
    ++stamp_;
    here_.clear();
    for (const ContactPair& pair : pairs) {
        if (const auto number = group_of(result, pair)) {
            note_pair(result, pair, *number);
        } else {
            ++left_out_;
        }
    }
    const bool all_cross = result.kind == ScenarioClass::Cross && !has_proper(result.pairs);
    for (const std::uint32_t number : here_) {
        Sum& sum = sums_[number];
        Group& group = sum.group;
        ++group.scenarios;
        group.pairs += sum.pairs_here;
        group.near.pairs += sum.near_here;
        if (std::pair(sum.pairs_here, sum.near_here) >
            std::pair(group.worst_pairs, group.near.worst_pairs)) {
            group.worst_pairs = sum.pairs_here;
            group.near.worst_pairs = sum.near_here;
            group.worst = result.index;
        }
        const bool is_cross = sum.is_proper_here || (all_cross && sum.pairs_here != 0);
        group.kind = class_with(group, is_cross);
        add_to(group.episodes, result.index);
    }
    limit_triangles();
}

Status GroupSum::add(const PartContacts& contacts) {
    CD_CHECK(kind_ == PartKind::Named && meshes_.size() == contacts.parts.size());
    find_parts();
    for (std::size_t side = 0; side < contacts.parts.size(); ++side) {
        for (const PartScenarios& part : contacts.parts[side]) {
            if (part.part >= bodies_[side].parts->count()) {
                return bad_input("the sums by part name a part that a body does not have");
            }
            bodies_[side].scenarios[part.part] += part.scenarios;
        }
    }
    for (const PartPairContacts& pair : contacts.pairs) {
        if (pair.a >= bodies_[0].parts->count() || pair.b >= bodies_[1].parts->count()) {
            return bad_input("the sums by part name a part that a body does not have");
        }
        const auto number = number_of({0, 1}, {pair.a, pair.b});
        CD_CHECK(number.has_value()); // Sums have at most `limits::groups_max` pairs of parts.
        Group& group = sums_[*number].group;
        group.scenarios = pair.scenarios;
        group.pairs = pair.pairs;
        group.worst = pair.worst;
        group.worst_pairs = pair.worst_pairs;
        group.near = {pair.near, pair.worst_near};
        group.kind = class_of(pair);
        group.episodes = {0, pair.last, {{pair.first, pair.last}}};
    }
    left_out_ += contacts.left_out;
    return Done{};
}

void GroupSum::count_regions(std::uint32_t body, std::vector<Group>& groups) const {
    // A mesh in which each group has triangles of its own: all groups at once, in linear time.
    const Mesh& mesh = *meshes_[body];
    MeshArrays arrays{mesh.vertices(), {}, {}, mesh.precision()};
    std::vector<std::uint32_t> sides; // For each triangle twice its group, plus 1 on side B.
    for (std::uint32_t number = 0; number < sums_.size(); ++number) {
        const Group& group = sums_[number].group;
        for (const std::uint32_t side : {0u, 1u}) {
            if ((side == 0 ? group.body_a : group.body_b) != body) {
                continue;
            }
            std::vector<std::uint32_t> touched = sums_[number].touched[side];
            sort_each_once(touched);
            for (const std::uint32_t triangle : touched) {
                arrays.triangles.push_back(mesh.triangles()[triangle]);
                sides.push_back(2 * number + side);
            }
        }
    }
    if (sides.empty()) {
        return;
    }
    const auto made = Mesh::create(std::move(arrays));
    const std::vector<std::uint32_t> first_of = first_of_own_component(made.value(), sides);
    for (std::uint32_t i = 0; i < first_of.size(); ++i) {
        groups[sides[i] / 2].regions[sides[i] % 2] += first_of[i] == i ? 1 : 0;
    }
}

std::vector<Group> GroupSum::groups() const {
    std::vector<Group> groups;
    for (const Sum& sum : sums_) {
        Group& group = groups.emplace_back(sum.group);
        group.part_a = bodies_[group.body_a].parts->name(sum.part[0]);
        group.part_b = bodies_[group.body_b].parts->name(sum.part[1]);
    }
    for (std::uint32_t body = 0; counts_regions_ && body < bodies_.size(); ++body) {
        count_regions(body, groups);
    }
    std::ranges::stable_sort(groups, [](const Group& left, const Group& right) {
        return std::tuple(left.scenarios, left.pairs, left.near.pairs) >
               std::tuple(right.scenarios, right.pairs, right.near.pairs);
    });
    return groups;
}

std::vector<TouchedPart> GroupSum::most_touched(std::size_t count) const {
    std::vector<TouchedPart> touched;
    for (std::uint32_t number = 0; number < bodies_.size(); ++number) {
        const Body& body = bodies_[number];
        const BodyParts& parts = *body.parts;
        for (std::size_t i = 0; parts.has_lasting_names() && parts.count() > 1 && i < parts.count();
             ++i) {
            if (body.scenarios[i] != 0) {
                touched.push_back({parts.name(i), body.scenarios[i], number});
            }
        }
    }
    std::ranges::stable_sort(touched, [](const TouchedPart& left, const TouchedPart& right) {
        return left.scenarios > right.scenarios;
    });
    touched.resize(std::min(touched.size(), count));
    return touched;
}

} // namespace cd
