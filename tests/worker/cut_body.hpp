// A mesh as a master holds it: built, cut, with the upper tree and each root's subtree encoded.
#pragma once

#include "common/core/files/compress.hpp"
#include "common/core/files/hash.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/wire/subtree_block.hpp"
#include "common/tree/wire/top_block.hpp"
#include "proto/messages/work_messages.hpp"
#include "tests/support/trees.hpp"

#include <memory>
#include <vector>

namespace cd::tests {

struct CutBody {
    SubtreeForm form;
    ObbTree tree;
    TreeTop top;
    std::vector<SubtreeBlock> blocks;
    SubtreeBlock top_block;

    [[nodiscard]] const SubtreeBlock& block(RootIndex root) const {
        return root == top_root ? top_block : blocks.at(root);
    }
    /// Returns the message that announces the tree to a worker.
    [[nodiscard]] AddTree add(TreeId id) const {
        AddTree message;
        message.tree = id;
        message.form = form;
        message.cut = blocks.front().hash;
        message.top = top_block.hash;
        message.roots = top.root_count();
        message.triangles = top.triangle_count();
        return message;
    }
};

inline SubtreeBlock packed(RootIndex root, const Bytes& bytes) {
    return {root, sha256(bytes), compress(bytes, compression_level_fast)};
}

inline CutBody cut_body(Mesh mesh, std::uint32_t depth, SubtreeForm form = SubtreeForm::Wide) {
    ObbTree tree = make_tree(std::move(mesh));
    TreeTop top = cut_tree(tree, depth);
    std::vector<SubtreeBlock> blocks;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        const auto root = static_cast<RootIndex>(blocks.size());
        blocks.push_back(packed(root, encode_subtree(extract_subtree(tree, node, form))));
    }
    SubtreeBlock top_block = packed(top_root, encode_top(top));
    return {form, std::move(tree), std::move(top), std::move(blocks), std::move(top_block)};
}

} // namespace cd::tests
