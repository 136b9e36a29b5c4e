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
#include <random>
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
    auto roots =
        query_roots(cut_tree(a, depths[0]), cut_tree(b, depths[1]), scenario, query, options.radii)
            .value()
            .pairs;
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
