// The messages of a simulated cluster: the real ones, whose blocks have no bytes and whose results
// say only which scenarios they answer. Their sizes are those on the real wire.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "common/core/id.hpp"
#include "proto/codec/message.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace cd::bench {

using Messages = std::vector<Message>;

/// The number of a tree at the master: the two bodies are its first trees.
[[nodiscard]] inline TreeId tree_id(std::uint8_t tree) {
    return TreeId{std::uint64_t{1} + tree};
}
[[nodiscard]] inline BlockId block_id(TreeId tree, RootIndex root) {
    return {static_cast<std::uint8_t>(tree.value - 1), root};
}

/// Makes a message with the roots of each tree that has any of the blocks.
template <class Type>
[[nodiscard]] Messages by_tree(std::vector<BlockId> blocks) {
    std::ranges::sort(blocks);
    Messages messages;
    for (auto block = blocks.begin(); block != blocks.end();) {
        Type message;
        message.tree = tree_id(block->tree);
        for (const auto tree = block->tree; block != blocks.end() && block->tree == tree; ++block) {
            message.roots.push_back(block->root);
        }
        messages.emplace_back(std::move(message));
    }
    return messages;
}

/// The positions of a range are its scenarios.
[[nodiscard]] std::vector<std::uint64_t> scenarios_in(const WorkUnit& unit);
[[nodiscard]] std::vector<std::uint64_t> scenarios_in(const Results& results);
/// Sets `count` and `records`.
void set_scenarios(Results& results, const std::vector<std::uint64_t>& scenarios);

/// Returns the size by the codec, with the frame; records, poses and blocks take the workload's
/// sizes.
[[nodiscard]] std::uint64_t bytes_of(const Message& message, const Workload& workload);

} // namespace cd::bench
