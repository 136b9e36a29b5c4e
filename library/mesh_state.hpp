// What a mesh keeps between calls.
#pragma once

#include "client/trees/mesh_trees.hpp"
#include "common/core/host/stop_check.hpp"
#include "library/include/cdcluster/cdcluster.hpp"
#include "library/pair_search.hpp"

#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cdcluster {

struct Mesh::State {
    explicit State(std::shared_ptr<const cd::Mesh> from) : mesh(std::move(from)), trees(mesh) {}

    std::shared_ptr<const cd::Mesh> mesh;
    std::filesystem::path file; ///< Where the mesh was read; empty: it came from memory.
    std::mutex mutex;           ///< Guards all below. Of two meshes, that of A is locked first.
    cd::MeshTrees trees;
    std::vector<std::shared_ptr<PairSearch>> searches; ///< As body A; those used last come first.
};

/// Returns what a mesh is for the engine. Throws BadInput for one that was moved from.
[[nodiscard]] const cd::Mesh& mesh_of(const Mesh& mesh);

/// Returns the search of two meshes for a query, which is new unless A keeps it. Builds the trees
/// that are missing, with support points if they are wanted (many poses follow). Throws Interrupted
/// soon after `stop` returns true; trees that are built by then are kept.
[[nodiscard]] std::shared_ptr<PairSearch> search_of(const Mesh& a,
                                                    const Mesh& b,
                                                    const cd::Query& query,
                                                    bool wants_points,
                                                    unsigned threads,
                                                    const cd::StopCheck& stop);

} // namespace cdcluster
