#include "common/tree/wire/node_columns.hpp"

#include "common/core/varint.hpp"
#include "common/tree/node_check.hpp"
#include "common/tree/wire/byte_planes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace cd {

namespace {

/// Predicts the third row of a frame as the cross product of the other rows: equal up to the sign
/// and a few ulps, with operations that round alike on every host. The difference from the third
/// row compresses to next to nothing.
std::array<std::uint32_t, 3> predicted_row(const std::array<float, 9>& axes) {
    const auto at = [&](std::size_t i) { return static_cast<double>(axes[i]); };
    const std::array<double, 3> cross{at(1) * at(5) - at(2) * at(4),
                                      at(2) * at(3) - at(0) * at(5),
                                      at(0) * at(4) - at(1) * at(3)};
    std::array<std::uint32_t, 3> bits{};
    for (std::size_t i = 0; i < 3; ++i) {
        bits[i] = std::bit_cast<std::uint32_t>(static_cast<float>(cross[i]));
    }
    return bits;
}

void put_boxes(ByteWriter& out, std::span<const ObbNode> nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
        put_column<double>(out, nodes.size(), [&](std::size_t i) { return nodes[i].center[k]; });
    }
    for (std::size_t k = 0; k < 6; ++k) {
        put_column<float>(out, nodes.size(), [&](std::size_t i) { return nodes[i].axes[k]; });
    }
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<std::uint32_t> differences(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            differences[i] = std::bit_cast<std::uint32_t>(nodes[i].axes[6 + k]) -
                             predicted_row(nodes[i].axes)[k];
        }
        put_planes(out, std::span<const std::uint32_t>(differences));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        put_column<float>(out, nodes.size(), [&](std::size_t i) { return nodes[i].half[k]; });
    }
}

bool get_boxes(ByteReader& in, std::span<ObbNode> nodes) {
    bool complete = true;
    for (std::size_t k = 0; k < 3; ++k) {
        complete = complete && get_column<double>(in, nodes.size(), [&](std::size_t i) -> double& {
                       return nodes[i].center[k];
                   });
    }
    for (std::size_t k = 0; k < 6; ++k) {
        complete = complete && get_column<float>(in, nodes.size(), [&](std::size_t i) -> float& {
                       return nodes[i].axes[k];
                   });
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto differences = get_planes<std::uint32_t>(in, nodes.size());
        for (std::size_t i = 0; i < differences.size(); ++i) {
            nodes[i].axes[6 + k] =
                std::bit_cast<float>(differences[i] + predicted_row(nodes[i].axes)[k]);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        complete = complete && get_column<float>(in, nodes.size(), [&](std::size_t i) -> float& {
                       return nodes[i].half[k];
                   });
    }
    return complete && !in.failed() && std::all_of(nodes.begin(), nodes.end(), is_valid_box);
}

/// Writes the shape of the tree: for each node in preorder 0, or for a leaf its number of
/// triangles.
void put_shape(ByteWriter& out, std::span<const ObbNode> nodes) {
    for (const ObbNode& node : nodes) {
        put_varint(out, node.is_leaf() ? node.triangle_count() : 0);
    }
}

/// Sets children and triangle ranges. Returns false when the shape is no tree over `triangles`
/// triangles.
bool get_shape(ByteReader& in, std::span<ObbNode> nodes, std::uint32_t triangles) {
    std::uint32_t begin = 0;
    for (ObbNode& node : nodes) {
        const auto count = get_varint(in);
        if (!count || *count > triangles - begin) {
            return false;
        }
        node.triangles_begin = begin;
        begin += static_cast<std::uint32_t>(*count);
        node.triangles_end = begin;
    }
    // The loop runs from the back; a stack holds the complete subtrees, the leftmost on top.
    std::vector<std::uint32_t> complete;
    for (auto i = static_cast<std::uint32_t>(nodes.size()); i-- > 0;) {
        ObbNode& node = nodes[i];
        if (node.triangle_count() == 0) {
            if (complete.size() < 2) {
                return false;
            }
            complete.pop_back(); // The left child is the node that follows.
            node.right = complete.back();
            node.triangles_end = nodes[node.right].triangles_end;
            complete.pop_back();
        }
        complete.push_back(i);
    }
    return complete.size() == 1 && begin == triangles;
}

} // namespace

void put_nodes(ByteWriter& out, std::span<const ObbNode> nodes) {
    put_boxes(out, nodes);
    put_shape(out, nodes);
}

bool get_nodes(ByteReader& in, std::span<ObbNode> nodes, std::uint32_t triangles) {
    return get_boxes(in, nodes) && get_shape(in, nodes, triangles);
}

} // namespace cd
