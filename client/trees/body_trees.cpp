#include "client/trees/body_trees.hpp"

#include "client/trees/mesh_trees.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace cd {

std::vector<std::shared_ptr<const ObbTree>>
make_body_trees(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool) {
    std::vector<MeshTrees> distinct;
    std::map<Sha256, std::size_t> numbers;
    std::vector<std::size_t> number_of; // For each body, that of its mesh.
    for (const auto& mesh : meshes) {
        const auto [known, is_new] = numbers.try_emplace(mesh->hash(), distinct.size());
        if (is_new) {
            distinct.emplace_back(mesh);
        }
        number_of.push_back(known->second);
    }
    for (MeshTrees& body : distinct) {
        body.need_wide(cache, pool);
        body.need_points(use.makes_points, cache, pool);
    }
    const auto closed = std::ranges::count_if(
        number_of, [&](std::size_t number) { return distinct[number].is_closed(); });
    // A search uses the binary trees if a body has no wide nodes.
    const bool all_need_binary = !std::ranges::all_of(distinct, &MeshTrees::has_wide_nodes);
    for (MeshTrees& body : distinct) {
        if (all_need_binary || (use.settles && closed >= 2 && body.is_closed())) {
            body.need_binary(cache, pool);
        }
    }
    std::vector<std::shared_ptr<const ObbTree>> made;
    for (const MeshTrees& body : distinct) {
        made.push_back(body.tree());
    }
    std::vector<std::shared_ptr<const ObbTree>> trees;
    for (const std::size_t number : number_of) {
        trees.push_back(made[number]);
    }
    return trees;
}

} // namespace cd
