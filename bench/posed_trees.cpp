#include "bench/posed_trees.hpp"

#include "client/import/mesh_import.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/tree/box_test.hpp"
#include "common/tree/build/build.hpp"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace cd::bench {

void PosedTreesOptions::add_to(CLI::App& app) {
    app.add_option("MESH_A", a, "A mesh file")->required();
    app.add_option("MESH_B", b, "A mesh file; without it A meets itself");
    app.add_option("--unit-a", unit_a, "What A's coordinates are multiplied by");
    app.add_option("--poses", poses, "A file of poses of B in A's frame");
    app.add_option("--random", random, "How many random poses, without a file");
    app.add_flag("--planes", planes, "Make support points");
}

std::optional<PosedTrees> load(const PosedTreesOptions& options) {
    const auto a = import_mesh(options.a, {options.unit_a});
    const auto b = options.b.empty() ? a : import_mesh(options.b, {});
    for (const auto* mesh : {&a, &b}) {
        if (!*mesh) {
            std::fprintf(stderr, "%s\n", mesh->error().detail.c_str());
            return std::nullopt;
        }
    }
    ThreadPool pool;
    PosedTrees trees{a.value().mesh,
                     b.value().mesh,
                     build_tree(a.value().mesh, {}, pool),
                     build_tree(b.value().mesh, {}, pool),
                     {}};
    auto poses = options.poses.empty()
                     ? random_poses(trees.a, trees.b, options.random, pool)
                     : read_poses(options.poses).value_or(std::vector<PosePair>());
    if (poses.empty()) {
        std::fprintf(stderr, "no poses in %s\n", options.poses.c_str());
        return std::nullopt;
    }
    trees.poses = std::move(poses);
    if (options.planes) {
        for (ObbTree* tree : {&trees.a, &trees.b}) {
            const auto begin = std::chrono::steady_clock::now();
            tree->prepare_planes();
            const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
            const SupportView support = tree->view().wide.support;
            std::printf(
                "support points of %zu triangles: %.3f s, %.1f bytes a triangle\n",
                tree->mesh().triangles().size(),
                spent.count(),
                static_cast<double>(support.sets.size_bytes() + support.columns.size_bytes()) /
                    static_cast<double>(tree->mesh().triangles().size()));
        }
    }
    return trees;
}

std::optional<std::vector<PosePair>> read_poses(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        return std::nullopt;
    }
    std::vector<PosePair> poses;
    for (std::string line; std::getline(file, line);) {
        std::istringstream stream(line);
        const std::vector<double> n(std::istream_iterator<double>(stream), {});
        if (n.size() != 12) {
            return std::nullopt;
        }
        Mat3 rotation;
        rotation << n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8];
        poses.push_back({Pose{}, Pose::from_matrix(rotation, {n[9], n[10], n[11]})});
    }
    return poses;
}

std::vector<PosePair>
random_poses(const ObbTree& a, const ObbTree& b, std::uint64_t count, ThreadPool& pool) {
    RandomPoses random;
    random.count = count;
    std::vector<PosePair> all;
    for (const Scenario& scenario : make_random_poses(random, a, b, pool)) {
        all.push_back(scenario.poses);
    }
    return all;
}

std::vector<Candidate> candidates_of(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    const BoxTest boxes(relative_pose(poses));
    const TriangleSpan triangles_a{a.view().vertices, a.view().triangles};
    const TriangleSpan triangles_b{b.view().vertices, b.view().triangles};
    std::vector<Candidate> candidates;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [ia, ib] = stack.back();
        stack.pop_back();
        const ObbNode& node_a = a.nodes()[ia];
        const ObbNode& node_b = b.nodes()[ib];
        if (!boxes.may_overlap(node_a, node_b)) {
            continue;
        }
        if (!node_a.is_leaf() &&
            (node_b.is_leaf() || node_a.triangle_count() >= node_b.triangle_count())) {
            stack.emplace_back(node_a.right, ib);
            stack.emplace_back(ia + 1, ib);
        } else if (!node_b.is_leaf()) {
            stack.emplace_back(ia, node_b.right);
            stack.emplace_back(ia, ib + 1);
        } else {
            for (std::uint32_t i = node_a.triangles_begin; i < node_a.triangles_end; ++i) {
                const Aabb own = bounding_box(triangles_a.corners_at(i));
                for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
                    const Aabb other = boxes.bounds(triangles_b.corners_at(j));
                    if ((own.min.array() <= other.max.array()).all() &&
                        (other.min.array() <= own.max.array()).all()) {
                        candidates.push_back({i, j});
                    }
                }
            }
        }
    }
    return candidates;
}

} // namespace cd::bench
