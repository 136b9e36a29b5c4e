#include "common/solid/inside_probes.hpp"

#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace cd {

namespace {

/// Returns 0, `count` and the bounds of the inner body's ignored ranges, ascending. All triangles
/// between two consecutive bounds are ignored with the same outer triangles.
std::vector<std::uint32_t> bounds_of(std::span<const IgnoredRange> ignored, std::uint32_t count) {
    std::vector<std::uint32_t> bounds{0, count};
    for (const IgnoredRange& range : ignored) {
        bounds.push_back(std::min(range.a_begin, count));
        bounds.push_back(std::min(range.a_end, count));
    }
    std::sort(bounds.begin(), bounds.end());
    bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
    return bounds;
}

/// Returns the outer triangles that are ignored with an inner triangle, ascending and disjoint.
std::vector<IdRange>
left_out_of(std::span<const IgnoredRange> ignored, std::uint32_t inner, std::uint32_t outer_count) {
    std::vector<IdRange> ranges;
    for (const IgnoredRange& range : ignored) {
        const std::uint32_t end = std::min(range.b_end, outer_count);
        if (range.a_begin <= inner && inner < range.a_end && range.b_begin < end) {
            ranges.push_back({range.b_begin, end});
        }
    }
    std::sort(ranges.begin(), ranges.end());
    std::vector<IdRange> joined;
    for (const IdRange& range : ranges) {
        if (!joined.empty() && range.begin <= joined.back().end) {
            joined.back().end = std::max(joined.back().end, range.end);
        } else {
            joined.push_back(range);
        }
    }
    return joined;
}

/// Divides the inner triangles into kinds: all triangles of a kind are ignored with the same outer
/// triangles.
struct Kinds {
    std::vector<std::vector<IdRange>> left_out; ///< For each kind, the ignored outer triangles.
    std::vector<std::uint32_t> of_triangle;     ///< The kind of each inner triangle.
};

/// Returns nothing if there are too many ignored ranges or kinds (limits/engine.hpp).
std::optional<Kinds> kinds_of(std::span<const IgnoredRange> ignored,
                              std::uint32_t inner_count,
                              std::uint32_t outer_count) {
    if (ignored.size() > limits::inside_ignored_max) {
        return std::nullopt;
    }
    Kinds kinds;
    std::map<std::vector<IdRange>, std::uint32_t> numbers;
    const std::vector<std::uint32_t> bounds = bounds_of(ignored, inner_count);
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        std::vector<IdRange> left_out = left_out_of(ignored, bounds[i], outer_count);
        const auto next = static_cast<std::uint32_t>(numbers.size());
        const auto [entry, is_new] = numbers.emplace(std::move(left_out), next);
        if (is_new) {
            kinds.left_out.push_back(entry->first);
        }
        if (numbers.size() > limits::inside_kinds_max) {
            return std::nullopt;
        }
        kinds.of_triangle.resize(bounds[i + 1], entry->second);
    }
    return kinds;
}

/// Returns true if each component is left out either as a whole or not at all.
bool leaves_components_whole(std::span<const std::uint32_t> component_of,
                             std::span<const IdRange> left_out) {
    std::vector<std::uint8_t> ways(
        component_of.size(),
        0); // Per component: 1 if any triangle stays, plus 2 if any is left out.
    std::uint32_t next = 0;
    const auto note = [&](std::uint32_t end, std::uint8_t way) {
        for (; next < end; ++next) {
            ways[component_of[next]] |= way;
        }
    };
    for (const IdRange& range : left_out) {
        note(range.begin, 1);
        note(range.end, 2);
    }
    note(static_cast<std::uint32_t>(component_of.size()), 1);
    return std::ranges::none_of(ways, [](std::uint8_t both) { return both == 3; });
}

} // namespace

InsideProbes
inside_probes(const ObbTree& inner, const ObbTree& outer, std::span<const IgnoredRange> ignored) {
    if (ignored.empty()) {
        return {{{inner.topology().component_triangles, {}}}, true};
    }
    const auto inner_count = static_cast<std::uint32_t>(inner.mesh().triangles().size());
    const auto outer_count = static_cast<std::uint32_t>(outer.mesh().triangles().size());
    const std::optional<Kinds> kinds = kinds_of(ignored, inner_count, outer_count);
    if (!kinds) {
        return {{}, false};
    }
    InsideProbes probes;
    const std::vector<IdRange> all{{0, outer_count}};
    const std::vector<std::uint32_t> component_of = first_of_own_component(outer.mesh(), {});
    std::vector<ProbeGroup> groups(kinds->left_out.size());
    for (std::size_t kind = 0; kind < groups.size(); ++kind) {
        groups[kind].left_out = kinds->left_out[kind];
    }
    const std::vector<std::uint32_t> piece_of =
        first_of_own_component(inner.mesh(), kinds->of_triangle);
    for (std::uint32_t i = 0; i < inner_count; ++i) {
        if (piece_of[i] == i) {
            groups[kinds->of_triangle[i]].triangles.push_back(i);
        }
    }
    for (ProbeGroup& group : groups) {
        if (group.left_out == all) {
            continue;
        }
        if (leaves_components_whole(component_of, group.left_out)) {
            probes.groups.push_back(std::move(group));
        } else {
            probes.are_all = false;
        }
    }
    return probes;
}

} // namespace cd
