#include "common/job/shots/simple_lines.hpp"

#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace cd {

namespace {

/// Returns whether two triangles of one block have the same three vertex indices. If not, their
/// corners may still be equal.
bool have_same_vertices(const TriangleBlocks& blocks, std::uint32_t left, std::uint32_t right) {
    static_assert(block_vertices_max <= 64);
    const auto vertices_of = [&](std::uint32_t slot) {
        const BlockCorners& corners = blocks.corners[slot];
        return std::uint64_t{1} << corners[0] | std::uint64_t{1} << corners[1] |
               std::uint64_t{1} << corners[2];
    };
    return vertices_of(left) == vertices_of(right) && std::popcount(vertices_of(left)) == 3;
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
    if (coincident_.group == group && coincident_.earlier == earlier) {
        return true;
    }
    const Passes::Group& left = passes_->groups[group];
    const Passes::Group& right = passes_->groups[earlier];
    const TriangleBlocks& of_left = pairs_[left.pair].a.wide.triangles;
    const TriangleBlocks& of_right = pairs_[right.pair].a.wide.triangles;
    const bool is_one_block =
        left.pair == right.pair && left.slot / block_size == right.slot / block_size;
    if (!(is_one_block && have_same_vertices(of_left, left.slot, right.slot)) &&
        !are_coincident(of_left.corners_at(left.slot), of_right.corners_at(right.slot))) {
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

/// Sorts the hits by triangle. Hits of one triangle keep the order in which they were found.
void SimpleLines::put_in_order() {
    constexpr std::uint32_t at_once = 4;
    const Passes& p = *passes_;
    triangles_.clear();
    for (const Passes::Group& group : p.groups) {
        triangles_.push_back(group.triangle);
    }
    in_order_.resize(p.count() + at_once);
    Placed* to = in_order_.data();
    const std::span<const std::uint32_t> order = order_.of(triangles_);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Passes::Group& group = p.groups[order[k]];
        const std::uint32_t count = p.end_of(order[k]) - group.begin;
        const bool is_back = (group.flags & hit_flag::back) != 0;
        const std::uint32_t packed = group.triangle << 1 | (is_back ? 1u : 0u);
        // Most groups are small. Writing a fixed number of entries avoids a branch for each hit.
        for (std::uint32_t from = 0; from < count; from += at_once) {
            for (std::uint32_t i = 0; i < at_once; ++i) {
                to[from + i] = {group.begin + from + i, packed};
            }
        }
        to += count;
    }
    in_order_.resize(p.count());
}

/// Returns the settled hits, sorted by triangle, then by line. Hits of one triangle are usually
/// found in the order of their lines, so sorting by triangle usually suffices.
SettledHits SimpleLines::sorted(bool only_first) {
    put_in_order();
    if (!open_.empty() || only_first) {
        keep_settled(only_first);
    }
    const std::vector<Placed>& hits = in_order_;
    const std::uint32_t* const lines = passes_->lines.data();
    const double* const depths = passes_->depths.data();
    SettledHits settled;
    settled.pairs.reserve(hits.size());
    settled.hits.reserve(hits.size());
    disordered_.clear();
    std::uint64_t before = 0;
    for (const Placed& each : hits) {
        const std::uint32_t line = lines[each.hit];
        const std::uint64_t key = std::uint64_t{each.triangle()} << 32 | line;
        if (key < before) {
            disordered_.push_back(settled.pairs.size());
        }
        before = key;
        settled.pairs.push_back({each.triangle(), line, PairClass::Touch});
        settled.hits.push_back({depths[each.hit], each.flags(), 0});
    }
    std::size_t end = 0;
    for (const std::size_t i : disordered_) {
        end = i < end ? end : sort_triangle(settled, i);
    }
    return settled;
}

/// Removes the hits of lines that are not simple and, if only first hits are asked for, all others.
void SimpleLines::keep_settled(bool only_first) {
    std::erase_if(in_order_, [&](const Placed& each) {
        const Line& line = lines_[passes_->lines[each.hit]];
        return !line.is_simple || (only_first && line.first != each.hit);
    });
}

/// Sorts all hits of the triangle of hit `of` by line. Returns the index after the last of them.
std::size_t SimpleLines::sort_triangle(SettledHits& settled, std::size_t of) {
    const auto pairs = std::ranges::equal_range(
        settled.pairs, settled.pairs[of].a, {}, [](const ContactPair& pair) { return pair.a; });
    const auto first = static_cast<std::size_t>(pairs.begin() - settled.pairs.begin());
    by_line_.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        by_line_.emplace_back(pairs[i].b, settled.hits[first + i]);
    }
    std::ranges::sort(by_line_, {}, [](const auto& each) { return each.first; });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        std::tie(pairs[i].b, settled.hits[first + i]) = by_line_[i];
    }
    return first + pairs.size();
}

} // namespace cd
