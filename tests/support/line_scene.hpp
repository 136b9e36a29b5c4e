// Lines through two boxes and a plate.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/export/result_writer.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd::tests {

inline void add_part(const Mesh& mesh, const std::string& name, MeshArrays& arrays) {
    const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
    const auto begin = static_cast<std::uint32_t>(arrays.triangles.size());
    arrays.vertices.insert(arrays.vertices.end(), mesh.vertices().begin(), mesh.vertices().end());
    for (const Triangle& triangle : mesh.triangles()) {
        arrays.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    arrays.parts.push_back({name, begin, static_cast<std::uint32_t>(arrays.triangles.size())});
}

/// Makes two boxes and a plate behind them, seen along x.
inline Mesh boxes_and_plate() {
    MeshArrays arrays;
    add_part(make_box_between(Vec3(2, 0, 0), Vec3(2.5, 1, 1)), "first", arrays);
    add_part(make_box_between(Vec3(0, 0, 0), Vec3(1, 1, 1)), "second", arrays);
    add_part(make_mesh({Vec3(-1, 0, 0), Vec3(-1, 1, 0), Vec3(-1, 1, 1), Vec3(-1, 0, 1)},
                       {{0, 1, 2}, {0, 2, 3}}),
             "plate",
             arrays);
    return Mesh::create(std::move(arrays)).value();
}

[[nodiscard]] inline Query shots_query(Level level) {
    Query query;
    query.question = Question::Shots;
    query.level = level;
    return query;
}

/// Lines from the front through the boxes and the plate. The fifth of nine bundles has 16 lines,
/// which all meet them; the others have none that does.
struct LineScene {
    std::shared_ptr<const Mesh> a = share(boxes_and_plate());
    ShotsSpec spec;
    std::shared_ptr<const Mesh> lines;

    LineScene() {
        spec.grid.spacing = 0.25;
        spec.grid.tile = 4;
        lines = share(shot_mesh(spec, box()).value());
    }

    [[nodiscard]] Aabb box() const { return bounding_box(a->vertices()); }
    [[nodiscard]] std::shared_ptr<const ShotViews> views() const {
        return std::make_shared<const ShotViews>(spec, box());
    }

    /// Returns what exports know of the lines and the body.
    [[nodiscard]] ExportContext context() const {
        ExportContext context;
        context.bodies = {{"a", "a.obj", a}, {"lines", "", lines}};
        context.bodies[1].views = views();
        context.unit = "m";
        context.describe(shots_query(Level::Pairs));
        return context;
    }

    [[nodiscard]] std::vector<ScenarioResult> results(const Query& query) const {
        const ObbTree tree_a = make_tree(*a);
        const ObbTree tree_b = make_tree(*lines);
        std::vector<ScenarioResult> results;
        const std::vector<BundlePose> poses = shot_poses(spec, box()).value();
        for (const BundlePose& pose : poses) {
            Scenario scenario = make_scenario({Pose(), pose.pose});
            scenario.index = results.size();
            results.push_back(run_scenario(tree_a, tree_b, scenario, query).result);
        }
        return results;
    }
};

} // namespace cd::tests
