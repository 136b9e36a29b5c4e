// Hits of lines through the inside of triangles, with their depths.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cd {

/// Hits in groups, each of one triangle, in the order found.
struct Passes {
    struct Group {
        std::uint32_t triangle = 0; ///< Index in A's mesh.
        std::uint32_t slot = 0;     ///< Of the triangle in A's subtree.
        std::uint32_t pair = 0;     ///< Of subtrees, among those of the scenario.
        std::uint32_t begin = 0;    ///< Index of its first hit.
        std::uint8_t flags = 0;     ///< `hit_flag::crosses` and the side.
    };

    static constexpr std::uint32_t owners_at_once = 4;

    std::vector<Group> groups;
    std::vector<std::uint32_t> lines;  ///< By hit: index in B's mesh.
    std::vector<std::uint32_t> owners; ///< By hit: its group. Followed by spare ones.
    std::vector<std::uint32_t> slots;  ///< By hit: of the line in B's subtree.
    std::vector<double> depths;        ///< By hit; NaN if it is not known.

    void clear() {
        groups.clear();
        lines.clear();
        owners.clear();
        slots.clear();
        depths.clear();
    }
    /// Adds hits with unset members.
    void grow(std::size_t hits) {
        lines.resize(lines.size() + hits);
        slots.resize(slots.size() + hits);
        owners.resize(lines.size() + owners_at_once);
    }
    /// Adds a group. Its hits must have been added already.
    void add_group(const Group& group, std::uint32_t hits) {
        const auto number = static_cast<std::uint32_t>(groups.size());
        groups.push_back(group);
        // Most groups are small. Writing a fixed number of entries avoids a branch for each hit.
        for (std::uint32_t i = 0; i < hits; i += owners_at_once) {
            std::fill_n(&owners[group.begin + i], owners_at_once, number);
        }
    }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(lines.size()); }
    /// Returns the index behind the last hit of a group.
    [[nodiscard]] std::uint32_t end_of(std::size_t group) const {
        return group + 1 < groups.size() ? groups[group + 1].begin : count();
    }
};

} // namespace cd
