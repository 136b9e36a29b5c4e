#include "common/job/shots/simple_lines.hpp"

#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace cd {

namespace {

/// Returns a number below 64. Fibonacci hashing: see EqualDepths.
unsigned hash_of(double depth) {
    return static_cast<unsigned>(std::bit_cast<std::uint64_t>(depth) * 0x9e3779b97f4a7c15 >> 58);
}

} // namespace

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
    const std::span<const std::uint32_t> doubtful = find_doubtful();
    depths_.restart(p.lines, p.depths, doubtful.size());
    std::size_t group = 0;
    for (const std::uint32_t i : doubtful) {
        if (std::isnan(p.depths[i])) {
            open(p.lines[i]);
            continue;
        }
        while (i >= p.end_of(group)) {
            ++group;
        }
        const std::uint32_t earlier = depths_.add(i);
        if (earlier != none && !is_at_one_place(group, earlier)) {
            open(p.lines[i]);
        }
    }
}

/// Returns the hits of lines of which two depths may be equal or some depth is not known, in
/// ascending order.
std::span<const std::uint32_t> SimpleLines::find_doubtful() {
    const Passes& p = *passes_;
    bool are_some = false;
    for (std::uint32_t i = 0; i < p.count(); ++i) {
        Line& line = lines_[p.lines[i]];
        const std::uint64_t bit = std::uint64_t{1} << hash_of(p.depths[i]);
        const bool is_doubtful = ((line.depths & bit) != 0) | std::isnan(p.depths[i]);
        line.depths |= bit;
        line.is_doubtful |= is_doubtful;
        are_some |= is_doubtful;
    }
    doubtful_.resize(are_some ? p.count() : 0);
    std::size_t count = 0;
    for (std::uint32_t i = 0; are_some && i < p.count(); ++i) {
        doubtful_[count] = i;
        count += lines_[p.lines[i]].is_doubtful ? 1 : 0;
    }
    return std::span(doubtful_).first(count);
}

void SimpleLines::open(std::uint32_t line) {
    if (lines_[line].is_simple) {
        lines_[line].is_simple = false;
        open_.push_back(line);
    }
}

/// Returns whether a group's triangle has the same corners as that of an earlier hit.
bool SimpleLines::is_at_one_place(std::size_t group, std::uint32_t earlier) {
    const auto corners_of = [&](std::size_t number) {
        const Passes::Group& of = passes_->groups[number];
        return pairs_[of.pair].a.wide.triangles.corners_at(of.slot);
    };
    const bool is_alike = coincident_.group == group &&
                          earlier >= passes_->groups[coincident_.earlier].begin &&
                          earlier < passes_->end_of(coincident_.earlier);
    if (is_alike) {
        return true;
    }
    const std::size_t other = group_of(earlier);
    if (!are_coincident(corners_of(group), corners_of(other))) {
        return false;
    }
    coincident_ = {group, other};
    return true;
}

std::size_t SimpleLines::group_of(std::uint32_t hit) const {
    const auto after = std::ranges::upper_bound(passes_->groups, hit, {}, &Passes::Group::begin);
    return static_cast<std::size_t>(after - passes_->groups.begin()) - 1;
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
        return place(p.groups[group]) < place(p.groups[group_of(other)]);
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
