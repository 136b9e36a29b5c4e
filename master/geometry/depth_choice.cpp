#include "master/geometry/depth_choice.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

namespace cd {

namespace {

/// Nodes of a cut, as indices into the tree.
using CutNodes = std::vector<std::uint32_t>;

CutSize size_of(const ObbTree& tree, const CutNodes& cut) {
    CutSize size{cut.size(), 0};
    double squares = 0;
    double triangles = 0;
    for (const std::uint32_t node : cut) {
        const double count = tree.nodes()[node].triangle_count();
        squares += count * count;
        triangles += count;
    }
    size.triangles = squares / triangles;
    return size;
}

CutNodes one_deeper(const ObbTree& tree, const CutNodes& cut) {
    CutNodes deeper;
    deeper.reserve(2 * cut.size());
    for (const std::uint32_t node : cut) {
        if (tree.nodes()[node].is_leaf()) {
            deeper.push_back(node);
        } else {
            deeper.push_back(node + 1);
            deeper.push_back(tree.nodes()[node].right);
        }
    }
    return deeper;
}

} // namespace

std::vector<CutSize> cut_sizes(const ObbTree& tree) {
    std::vector<CutSize> sizes;
    CutNodes cut{0};
    for (std::uint32_t depth = 0; depth <= limits::distribution_depth_max; ++depth) {
        sizes.push_back(size_of(tree, cut));
        CutNodes deeper = one_deeper(tree, cut);
        if (deeper.size() == cut.size() || cut.size() > limits::roots_chosen_max) {
            break;
        }
        cut = std::move(deeper);
    }
    return sizes;
}

std::uint32_t choose_depth(std::span<const CutSize> cuts, double bytes_per_triangle) {
    CD_CHECK(!cuts.empty());
    std::uint32_t depth = 0;
    while (depth + 1 < cuts.size() && cuts[depth + 1].roots <= limits::roots_chosen_max &&
           cuts[depth].triangles * bytes_per_triangle > limits::block_bytes_wanted) {
        ++depth;
    }
    return depth;
}

std::uint32_t choose_depth(const ObbTree& tree, SubtreeForm form) {
    return choose_depth(cut_sizes(tree),
                        form == SubtreeForm::Wide ? limits::wide_block_bytes_per_triangle
                                                  : limits::binary_block_bytes_per_triangle);
}

} // namespace cd
