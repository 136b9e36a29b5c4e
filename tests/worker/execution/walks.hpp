// Trees and results of descents in tests.
#pragma once

#include "common/job/result/result.hpp"
#include "tests/worker/cut_body.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/walk.hpp"

#include <cstring>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace cd::tests {

/// Returns a tree of which the worker holds the upper tree alone.
[[nodiscard]] inline PartialObbTree held_top(const CutBody& body) {
    PartialObbTree tree(body.top.root_count());
    tree.set_top(std::make_shared<const TreeTop>(body.top));
    return tree;
}

/// Gives a worker's tree one of its blocks.
inline void fill(PartialObbTree& tree, const CutBody& body, RootIndex root) {
    const OpenedBlock opened = open_block(body.block(root)).value();
    tree.fill(root, std::get<std::shared_ptr<const Subtree>>(opened));
}

/// Returns a tree of which the worker holds all blocks.
[[nodiscard]] inline PartialObbTree held(const CutBody& body) {
    PartialObbTree tree = held_top(body);
    for (RootIndex root = 0; root < body.top.root_count(); ++root) {
        fill(tree, body, root);
    }
    return tree;
}

[[nodiscard]] inline std::vector<ScenarioResult> results_of(const FinishedScenarios& finished) {
    std::vector<ScenarioResult> results;
    std::span<const std::byte> left = finished.records;
    while (!left.empty()) {
        std::uint32_t size = 0;
        std::memcpy(&size, left.data(), sizeof(size));
        results.push_back(decode_result(left.subspan(sizeof(size), size)).value());
        left = left.subspan(sizeof(size) + size);
    }
    return results;
}

} // namespace cd::tests
