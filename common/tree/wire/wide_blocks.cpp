#include "common/tree/wire/wide_blocks.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::size_t blocks_at_once = 256;

TriangleBlockArrays make_part(const TreeView& tree,
                              const WideLeaves& leaves,
                              std::span<const std::uint32_t> leaf_of_block,
                              Precision precision) {
    TriangleBlockArrays part(precision);
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> ids;
    for (const std::uint32_t number : leaf_of_block) {
        const WideLeaf& leaf = leaves.leaves[number];
        triangles.clear();
        ids.clear();
        for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
            triangles.push_back(tree.triangles[leaves.order[i]]);
            ids.push_back(tree.triangle_ids[leaves.order[i]]);
        }
        static_cast<void>(part.add(triangles, ids, tree.vertices));
    }
    return part;
}

template <class T>
void copy_to(std::vector<T>& all, std::size_t offset, std::span<const T> part) {
    std::copy(part.begin(), part.end(), all.begin() + static_cast<std::ptrdiff_t>(offset));
}

} // namespace

WideBlocks make_wide_blocks(const TreeView& tree,
                            const WideLeaves& leaves,
                            std::span<const std::uint32_t> leaf_of_block,
                            Precision precision,
                            ThreadPool* pool) {
    const std::size_t blocks = leaf_of_block.size();
    const std::size_t tasks = (blocks + blocks_at_once - 1) / blocks_at_once;
    std::vector<TriangleBlockArrays> parts(tasks, TriangleBlockArrays(precision));
    parallel_for(pool, tasks, [&](std::size_t task) {
        const std::size_t begin = task * blocks_at_once;
        const std::size_t count = std::min(blocks_at_once, blocks - begin);
        parts[task] = make_part(tree, leaves, leaf_of_block.subspan(begin, count), precision);
    });

    std::vector<std::uint32_t> vertices_before; // Number of vertices before each part.
    WideBlocks all;
    std::uint32_t vertices = 0;
    for (const TriangleBlockArrays& part : parts) {
        const TriangleBlocks view = part.view();
        vertices_before.push_back(vertices);
        vertices += view.vertex_begin.back();
        all.reach = std::max(all.reach, view.reach);
    }
    // The padding after the last vertex comes with the last part.
    const TriangleBlocks last = parts.back().view();
    const std::size_t spare = 3 * std::size_t{last.vertex_begin.back()};
    const std::size_t numbers = 3 * std::size_t{vertices};
    all.floats.resize(last.floats.empty() ? 0 : numbers + last.floats.size() - spare);
    all.doubles.resize(last.doubles.empty() ? 0 : numbers + last.doubles.size() - spare);
    all.vertex_begin.resize(blocks + 1);
    all.vertex_begin.back() = vertices;
    all.corners.resize(block_size * blocks);
    all.ids.resize(block_size * blocks);
    parallel_for(pool, tasks, [&](std::size_t task) {
        const TriangleBlocks part = parts[task].view();
        const std::size_t first = task * blocks_at_once;
        const std::size_t own = 3 * std::size_t{part.vertex_begin.back()};
        const std::size_t offset = 3 * std::size_t{vertices_before[task]};
        copy_to(all.floats, offset, part.floats.first(std::min(own, part.floats.size())));
        copy_to(all.doubles, offset, part.doubles.first(std::min(own, part.doubles.size())));
        copy_to(all.corners, block_size * first, part.corners);
        copy_to(all.ids, block_size * first, part.ids);
        for (std::size_t i = 0; i + 1 < part.vertex_begin.size(); ++i) {
            all.vertex_begin[first + i] = vertices_before[task] + part.vertex_begin[i];
        }
    });
    return all;
}

} // namespace cd
