// A mesh as a master holds it: built, cut, and each distribution root's subtree encoded.
#pragma once

#include "common/core/compress.hpp"
#include "common/core/hash.hpp"
#include "common/tree/build.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree_block.hpp"
#include "proto/work_messages.hpp"
#include "tests/support/shapes.hpp"

#include <memory>
#include <vector>

namespace cd::tests {

struct CutBody {
    SubtreeForm form;
    ObbTree tree;
    TreeTop top;
    std::vector<SubtreeBlock> blocks;

    /// What a worker is told of it.
    [[nodiscard]] AddTree add(TreeId id) const {
        AddTree message;
        message.tree = id;
        message.form = form;
        message.cut = blocks.front().hash;
        message.top = top.nodes;
        return message;
    }
};

inline CutBody cut_body(Mesh mesh, std::uint32_t depth, SubtreeForm form = SubtreeForm::Wide) {
    ThreadPool pool(1);
    ObbTree tree = build_tree(share(std::move(mesh)), BuildOptions{}, pool);
    TreeTop top = cut_tree(tree, depth);
    std::vector<SubtreeBlock> blocks;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        const Bytes bytes = encode_subtree(extract_subtree(tree, node, form));
        SubtreeBlock block;
        block.root = static_cast<RootIndex>(blocks.size());
        block.hash = sha256(bytes);
        block.compressed = compress(bytes, compression_level_fast);
        blocks.push_back(std::move(block));
    }
    return {form, std::move(tree), std::move(top), std::move(blocks)};
}

} // namespace cd::tests
