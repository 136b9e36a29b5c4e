// Bodies and poses for tests of the library, and what the engine finds of them.
#pragma once

#include "common/job/result/merge.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "library/include/cdcluster/cdcluster.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace cd::tests {

/// Two closed bodies, B's poses around A in the form Wxyz, and the same poses for the engine.
struct LibraryBodies {
    explicit LibraryBodies(std::size_t poses)
        : mesh_a(share(make_torus(2, 0.7, 24, 12))), mesh_b(share(make_sphere(3))) {
        std::mt19937_64 random(7);
        for (std::size_t i = 0; i < poses; ++i) {
            Scenario& scenario = scenarios.emplace_back();
            scenario.index = i;
            scenario.poses.b = make_pose(random, 4);
            const Vec3& t = scenario.poses.b.translation();
            const Quaternion& q = scenario.poses.b.quaternion();
            numbers.insert(numbers.end(), {t[0], t[1], t[2], q.w, q.x, q.y, q.z});
        }
    }

    [[nodiscard]] cdcluster::Poses poses() const { return {numbers, cdcluster::PoseForm::Wxyz}; }

    /// Answers each pose by a search of its own.
    [[nodiscard]] std::vector<ScenarioResult> answers(const Query& query) const {
        ThreadPool pool(1);
        const ObbTree tree_a = build_tree(mesh_a, {}, pool);
        const ObbTree tree_b = build_tree(mesh_b, {}, pool);
        std::vector<ScenarioResult> results;
        for (const Scenario& scenario : scenarios) {
            results.push_back(run_scenario(tree_a, tree_b, scenario, query).result);
        }
        return results;
    }

    std::shared_ptr<const Mesh> mesh_a;
    std::shared_ptr<const Mesh> mesh_b;
    cdcluster::Mesh a = cdcluster::Mesh::from_canonical_bytes(mesh_a->canonical_bytes());
    cdcluster::Mesh b = cdcluster::Mesh::from_canonical_bytes(mesh_b->canonical_bytes());
    std::vector<Scenario> scenarios;
    std::vector<double> numbers;
};

[[nodiscard]] inline std::string digest_of(const std::vector<ScenarioResult>& results) {
    ResultMerger merger(results.size());
    for (const ScenarioResult& result : results) {
        static_cast<void>(merger.add(result));
    }
    return to_hex(merger.digest().value());
}

/// Returns the message of the error that `call` throws; empty if it throws none.
template <class Call>
[[nodiscard]] std::string error_of(const Call& call) {
    try {
        static_cast<void>(call());
    } catch (const cdcluster::Error& error) {
        return error.what();
    }
    return "";
}

} // namespace cd::tests
