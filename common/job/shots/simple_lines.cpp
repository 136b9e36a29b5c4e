#include "common/job/shots/simple_lines.hpp"

#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cd {

void SimpleLines::restart(const Passes& passes, std::span<const SubtreePair> pairs) {
    passes_ = &passes;
    pairs_ = pairs;
    lines_.clear();
    if (passes.count() != 0) {
        lines_.resize(*std::ranges::max_element(passes.lines) + std::size_t{1});
    }
    open_.clear();
    coincident_ = {};
}

SettledHits SimpleLines::settle(FoundContacts& found, bool only_first, std::uint64_t& moved) {
    find_open(found);
    if (!open_.empty()) {
        move_open(found, moved);
    }
    if (only_first) {
        find_first();
    }
    return sorted(only_first);
}

/// Finds the lines that are not simple.
void SimpleLines::find_open(const FoundContacts& found) {
    for (const ContactPair& pair : found.pairs()) {
        if (pair.b < lines_.size()) {
            open(pair.b);
        }
    }
    const Passes& p = *passes_;
    equal_.restart(p.lines, p.depths, lines_.size());
    for (std::uint32_t i = 0; i < p.count(); ++i) {
        if (std::isnan(p.depths[i])) {
            open(p.lines[i]);
            continue;
        }
        const std::uint32_t earlier = equal_.add(i);
        if (earlier != none && !is_at_one_place(p.owners[i], p.owners[earlier])) {
            open(p.lines[i]);
        }
    }
}

void SimpleLines::open(std::uint32_t line) {
    if (lines_[line].is_simple) {
        lines_[line].is_simple = false;
        open_.push_back(line);
    }
}

/// Returns whether the triangles of a group and of an earlier one have the same corners.
bool SimpleLines::is_at_one_place(std::size_t group, std::size_t earlier) {
    const auto corners_of = [&](std::size_t number) {
        const Passes::Group& of = passes_->groups[number];
        return pairs_[of.pair].a.wide.triangles.corners_at(of.slot);
    };
    if (coincident_.group == group && coincident_.earlier == earlier) {
        return true;
    }
    if (!are_coincident(corners_of(group), corners_of(earlier))) {
        return false;
    }
    coincident_ = {group, earlier};
    return true;
}

/// Finds the first hit of each line.
void SimpleLines::find_first() {
    const Passes& p = *passes_;
    const auto is_earlier = [&](std::uint32_t i, std::size_t group, std::uint32_t other) {
        if (p.depths[i] != p.depths[other]) {
            return p.depths[i] < p.depths[other];
        }
        const auto place = [](const Passes::Group& of) {
            return std::tuple(order_at_one_depth(of.flags), of.triangle);
        };
        return place(p.groups[group]) < place(p.groups[p.owners[other]]);
    };
    for (std::size_t group = 0; group < p.groups.size(); ++group) {
        for (std::uint32_t i = p.groups[group].begin; i < p.end_of(group); ++i) {
            std::uint32_t& first = lines_[p.lines[i]].first;
            if (first == none || is_earlier(i, group, first)) {
                first = i;
            }
        }
    }
}

/// Moves the hits of lines that are not simple to `found`.
void SimpleLines::move_open(FoundContacts& found, std::uint64_t& moved) {
    const Passes& p = *passes_;
    for (std::size_t group = 0; group < p.groups.size(); ++group) {
        const Passes::Group& of = p.groups[group];
        for (std::uint32_t i = of.begin; i < p.end_of(group); ++i) {
            if (!lines_[p.lines[i]].is_simple) {
                moving_.push_back({of.slot, p.slots[i]});
            }
        }
        if (group + 1 == p.groups.size() || p.groups[group + 1].pair != of.pair) {
            const TriangleBlocks& a = pairs_[of.pair].a.wide.triangles;
            const TriangleBlocks& b = pairs_[of.pair].b.wide.triangles;
            found.add(a, a.ids, b, b.ids, moving_);
            moved += moving_.size();
            moving_.clear();
        }
    }
}

/// Returns the hits that stay. Those of a triangle mostly are one group, in the order of lines.
SettledHits SimpleLines::sorted(bool only_first) {
    const Passes& p = *passes_;
    triangles_.clear();
    for (const Passes::Group& group : p.groups) {
        triangles_.push_back(group.triangle);
    }
    SettledHits settled;
    settled.pairs.resize(p.count());
    settled.hits.resize(p.count());
    std::size_t count = 0;
    const auto keep = [&](const Passes::Group& group, std::uint32_t i) {
        settled.pairs[count] = {group.triangle, p.lines[i], PairClass::Touch};
        settled.hits[count] = {p.depths[i], group.flags, 0};
        ++count;
    };
    const bool are_all_kept = open_.empty() && !only_first;
    const std::span<const std::uint32_t> order = order_.of(triangles_);
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const Passes::Group& first = p.groups[order[begin]];
        for (++end; end < order.size() && triangles_[order[end]] == first.triangle;) {
            ++end;
        }
        if (are_all_kept && end - begin == 1) {
            const std::size_t before = count;
            std::uint32_t line = 0;
            bool are_ordered = true;
            for (std::uint32_t i = first.begin; i < p.end_of(order[begin]); ++i) {
                keep(first, i);
                are_ordered &= line <= p.lines[i];
                line = p.lines[i];
            }
            if (are_ordered) {
                continue;
            }
            count = before;
        }
        for (const std::uint32_t i : kept_of(order.subspan(begin, end - begin), only_first)) {
            keep(first, i);
        }
    }
    settled.pairs.resize(count);
    settled.hits.resize(count);
    return settled;
}

/// Returns the hits of groups that stay, in the order of their lines. Valid until the next call.
std::span<const std::uint32_t> SimpleLines::kept_of(std::span<const std::uint32_t> groups,
                                                    bool only_first) {
    const Passes& p = *passes_;
    kept_.clear();
    for (const std::uint32_t group : groups) {
        for (std::uint32_t i = p.groups[group].begin; i < p.end_of(group); ++i) {
            const Line& of = lines_[p.lines[i]];
            if (of.is_simple && (!only_first || of.first == i)) {
                kept_.push_back(i);
            }
        }
    }
    std::ranges::sort(kept_, {}, [&](std::uint32_t i) { return p.lines[i]; });
    return kept_;
}

} // namespace cd
