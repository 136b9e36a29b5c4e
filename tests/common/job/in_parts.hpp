// Runs scenarios as the cluster does.
#pragma once

#include "common/job/query_roots.hpp"
#include "common/job/run_motion.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/wire/subtree_block.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace cd::tests {

/// Returns the subtrees of a cut after they went through bytes.
[[nodiscard]] inline std::vector<Subtree>
decoded_parts(const ObbTree& tree, std::uint32_t depth, SubtreeForm form) {
    std::vector<Subtree> parts;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        parts.push_back(decode_subtree(encode_subtree(extract_subtree(tree, node, form))).value());
    }
    return parts;
}

/// Returns a function that returns the part of a named root, and null for other roots.
[[nodiscard]] inline std::function<const Subtree*(RootIndex)>
named_parts(const std::vector<Subtree>& parts, std::vector<RootIndex> named) {
    return [&parts, named = std::move(named)](RootIndex root) {
        return std::ranges::binary_search(named, root) ? &parts[root] : nullptr;
    };
}

/// Cuts both trees, and runs on the colliding parts in random order.
[[nodiscard]] inline ScenarioResult run_in_parts(const ObbTree& a,
                                                 const ObbTree& b,
                                                 std::array<std::uint32_t, 2> depths,
                                                 SubtreeForm form,
                                                 const Scenario& scenario,
                                                 const Query& query,
                                                 std::mt19937_64& random) {
    const std::vector<Subtree> parts_a = decoded_parts(a, depths[0], form);
    const std::vector<Subtree> parts_b = decoded_parts(b, depths[1], form);
    RunOptions options;
    options.radii = radii_of(radii_for(TreesByBody(a, b), query), scenario);
    const TreeTop top_a = cut_tree(a, depths[0]);
    const TreeTop top_b = cut_tree(b, depths[1]);
    auto roots = query_roots(top_a, top_b, scenario, query, options.radii).value().pairs;
    const CutBodies cut({top_a, named_parts(parts_a, roots_of_a(roots))},
                        {top_b, named_parts(parts_b, roots_of_b(roots))});
    options.cut = query.question == Question::Motion ? &cut : nullptr;
    std::shuffle(roots.begin(), roots.end(), random);
    std::vector<SubtreePair> parts;
    for (const RootPair& pair : roots) {
        parts.push_back({parts_a[pair.a].view(), parts_b[pair.b].view()});
    }
    ScenarioResult result = run_on_subtrees(parts, scenario, query, options).result;
    (void)Settler(a, b, query.ignored).settle(scenario, result);
    return result;
}

} // namespace cd::tests
