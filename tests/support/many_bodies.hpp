// A job of more than two bodies, some of which share a mesh.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/job/trees_by_body.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/shapes.hpp"

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace cd::tests {

struct ManyBodies {
    BodyTrees trees;
    std::vector<Scenario> scenarios;
};

/// Makes five closed bodies of three meshes: a torus, a sphere twice and a box twice. In each step
/// the bodies have random poses, and each pair of bodies is a scenario.
[[nodiscard]] inline ManyBodies make_many_bodies(std::uint64_t steps) {
    ThreadPool pool(1);
    const auto tree_of = [&](Mesh mesh) {
        return std::make_shared<const ObbTree>(build_tree(share(std::move(mesh)), {}, pool));
    };
    const auto torus = tree_of(make_torus(1, 0.4, 40, 20));
    const auto sphere = tree_of(make_sphere(3));
    const auto box = tree_of(make_gridded_box(Vec3(0.3, 0.3, 0.3), 4));
    ManyBodies job{{torus, sphere, box, sphere, box}, {}};
    std::mt19937_64 random(7);
    for (std::uint64_t step = 0; step < steps; ++step) {
        std::vector<Pose> poses;
        for (std::size_t body = 0; body < job.trees.size(); ++body) {
            poses.push_back(make_pose(random, 1));
        }
        for (std::uint32_t a = 0; a < poses.size(); ++a) {
            for (std::uint32_t b = a + 1; b < poses.size(); ++b) {
                job.scenarios.push_back({job.scenarios.size(), a, b, {poses[a], poses[b]}});
            }
        }
    }
    return job;
}

} // namespace cd::tests
