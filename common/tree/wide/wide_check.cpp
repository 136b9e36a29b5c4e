#include "common/tree/wide/wide_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

namespace cd {

namespace {

/// Reads `is_leaf` as a byte, because the byte of a bool from outside may have any value.
bool has_valid_flag(const WideNode& node) {
    std::uint8_t flag = 0;
    std::memcpy(&flag, &node.is_leaf, sizeof flag);
    return flag <= 1;
}

bool has_valid_frame(const WideNode& node, double extent) {
    // Comparisons are written so that NaN fails them.
    bool valid = true;
    for (std::size_t k = 0; k < 3; ++k) {
        valid = valid && node.steps[k] > 0 && std::isfinite(node.steps[k]) &&
                std::abs(node.origin[k]) <= extent;
    }
    for (const std::array<float, 4>& column : node.columns) {
        for (const float entry : column) {
            valid = valid && std::abs(entry) <= 1.001F;
        }
        valid = valid && column[3] == 0;
    }
    return valid && node.steps[3] == 1 && std::isfinite(extent);
}

/// Returns true if children come after their parents and each node but the first has one parent.
bool is_tree(std::span<const WideNode> nodes) {
    std::vector<bool> has_parent(nodes.size(), false);
    std::size_t children = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const WideNode& node = nodes[i];
        if (node.count == 0 || node.count > wide_children_max) {
            return false;
        }
        if (node.is_leaf) {
            continue;
        }
        if (node.first <= i || node.first >= nodes.size() ||
            node.count > nodes.size() - node.first) {
            return false;
        }
        for (std::uint32_t child = 0; child < node.count; ++child) {
            if (has_parent[node.first + child]) {
                return false;
            }
            has_parent[node.first + child] = true;
        }
        children += node.count;
    }
    return children + 1 == nodes.size();
}

/// Returns the number of triangles of each block, taken from the block's leaf. Returns nothing
/// unless blocks and leaves correspond one to one.
std::optional<std::vector<std::uint8_t>> counts_of_blocks(std::span<const WideNode> nodes,
                                                          std::size_t blocks) {
    std::vector<std::uint8_t> counts(blocks, 0);
    std::size_t leaves = 0;
    for (const WideNode& node : nodes) {
        if (!node.is_leaf) {
            continue;
        }
        if (node.first >= blocks || counts[node.first] != 0) {
            return std::nullopt;
        }
        counts[node.first] = node.count;
        ++leaves;
    }
    return leaves == blocks ? std::optional(std::move(counts)) : std::nullopt;
}

bool have_blocks_their_sizes(const TriangleBlocks& blocks) {
    if (blocks.vertex_begin.empty() || blocks.vertex_begin.front() != 0) {
        return false;
    }
    for (std::size_t i = 0; i + 1 < blocks.vertex_begin.size(); ++i) {
        const std::uint32_t begin = blocks.vertex_begin[i];
        const std::uint32_t end = blocks.vertex_begin[i + 1];
        if (end <= begin || end - begin > block_vertices_max) {
            return false;
        }
    }
    const std::size_t slots = block_size * (blocks.vertex_begin.size() - 1);
    const std::size_t numbers =
        blocks.floats.empty() ? blocks.doubles.size() : blocks.floats.size();
    return blocks.corners.size() == slots && blocks.ids.size() == slots &&
           (blocks.floats.empty() || blocks.doubles.empty()) &&
           numbers == 3 * std::size_t{blocks.vertex_begin.back()} + spare_numbers;
}

/// Returns true if the first `count` slots of a block hold triangles, none of them `seen` before,
/// and the other slots are empty.
bool holds_triangles(const TriangleBlocks& blocks,
                     std::uint32_t block,
                     std::uint32_t count,
                     std::vector<bool>& seen) {
    const std::uint32_t vertices = blocks.vertex_begin[block + 1] - blocks.vertex_begin[block];
    for (std::uint32_t i = 0; i < block_size; ++i) {
        const std::uint32_t slot = block_size * block + i;
        const BlockCorners& corners = blocks.corners[slot];
        const std::uint32_t id = blocks.ids[slot];
        if (i >= count) {
            if (corners != BlockCorners{} || id != 0) {
                return false;
            }
            continue;
        }
        if (id >= seen.size() || seen[id] ||
            std::max({corners[0], corners[1], corners[2]}) >= vertices || corners[3] != 0) {
            return false;
        }
        seen[id] = true;
    }
    return true;
}

bool is_valid(const WideView& wide, std::size_t mesh_triangles) {
    const TriangleBlocks& blocks = wide.triangles;
    if (!std::ranges::all_of(wide.nodes, has_valid_flag) || !is_tree(wide.nodes) ||
        !have_blocks_their_sizes(blocks) || !std::isfinite(blocks.reach) ||
        !std::ranges::all_of(
            wide.nodes, [&](const WideNode& node) { return has_valid_frame(node, wide.extent); })) {
        return false;
    }
    const auto counts = counts_of_blocks(wide.nodes, blocks.vertex_begin.size() - 1);
    if (!counts) {
        return false;
    }
    std::vector<bool> seen(mesh_triangles, false);
    std::size_t triangles = 0;
    for (std::uint32_t block = 0; block < counts->size(); ++block) {
        if (!holds_triangles(blocks, block, (*counts)[block], seen)) {
            return false;
        }
        triangles += (*counts)[block];
    }
    const auto within_reach = [&](auto coordinate) {
        return std::abs(static_cast<double>(coordinate)) <= blocks.reach;
    };
    return triangles == seen.size() && std::ranges::all_of(blocks.floats, within_reach) &&
           std::ranges::all_of(blocks.doubles, within_reach);
}

} // namespace

Status check_wide_tree(const WideView& wide, std::size_t triangles) {
    const TriangleBlocks& blocks = wide.triangles;
    const bool is_empty = wide.nodes.empty() && blocks.floats.empty() && blocks.doubles.empty() &&
                          blocks.vertex_begin.empty() && blocks.corners.empty() &&
                          blocks.ids.empty();
    if (!is_empty && !is_valid(wide, triangles)) {
        return Error{ErrorCode::Io, "its nodes are no tree over the mesh's triangles"};
    }
    return Done{};
}

} // namespace cd
