// Proves that results do not depend on irrelevant choices: the order of bodies, vertices and
// corners, the unit of length by powers of two, the world's axes, the processor's instructions, the
// first stage of decisions, and wide or binary trees. Not one bit differs, on every hard scene.
#include "common/job/run_scenario.hpp"
#include "tests/corpus/categories.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cd::tests {

namespace {

ScenarioResult
result_of(const Scene& scene, Level level = Level::Pairs, const BuildOptions& options = {}) {
    return run_scenario(make_tree(*scene.a.mesh, options),
                        make_tree(*scene.b.mesh, options),
                        make_scenario(scene.poses),
                        query_of(level))
        .result;
}

/// Rotates each triangle's corners, which keeps its direction, and reverses the vertices.
Body renumbered(const Body& body) {
    const auto count = static_cast<std::uint32_t>(body.mesh->vertices().size());
    std::vector<Vec3> vertices(body.mesh->vertices().rbegin(), body.mesh->vertices().rend());
    std::vector<Triangle> triangles;
    for (const Triangle& t : body.mesh->triangles()) {
        triangles.push_back({count - 1 - t[1], count - 1 - t[2], count - 1 - t[0]});
    }
    return {share(make_mesh(std::move(vertices), std::move(triangles))), body.closed};
}

Vec3 rescaled(const Vec3& point, int exponent) {
    return {std::ldexp(point.x(), exponent),
            std::ldexp(point.y(), exponent),
            std::ldexp(point.z(), exponent)};
}

Body rescaled(const Body& body, int exponent) {
    const auto rescale = [&](const Vec3& vertex) { return rescaled(vertex, exponent); };
    return {share(mapped(*body.mesh, rescale)), body.closed};
}

Pose rescaled(const Pose& pose, int exponent) {
    return with_translation(pose, rescaled(pose.translation(), exponent));
}

Scene rescaled(const Scene& scene, int exponent) {
    return {scene.name,
            scene.category,
            rescaled(scene.a, exponent),
            rescaled(scene.b, exponent),
            {rescaled(scene.poses.a, exponent), rescaled(scene.poses.b, exponent)}};
}

/// Turns the world by 180 degrees about z: exact for both kinds of pose.
Pose turned_half(const Pose& pose) {
    const Vec3 t = pose.translation();
    const Vec3 offset(-t.x(), -t.y(), t.z());
    if (pose.kind() == Pose::Kind::Quaternion) {
        return Pose::from_quaternion(Quaternion{0, 0, 0, 1} * pose.quaternion(), offset);
    }
    Mat3 matrix = pose.matrix();
    matrix.row(0) = -pose.matrix().row(0);
    matrix.row(1) = -pose.matrix().row(1);
    return Pose::from_matrix(matrix, offset);
}

/// Permutes the world's axes cyclically: exact for matrices.
Pose turned_third(const Pose& pose) {
    const Vec3 t = pose.translation();
    Mat3 matrix;
    for (int row = 0; row < 3; ++row) {
        matrix.row((row + 1) % 3) = pose.matrix().row(row);
    }
    return Pose::from_matrix(matrix, Vec3(t.z(), t.x(), t.y()));
}

bool has_matrices(const PosePair& poses) {
    return poses.a.kind() == Pose::Kind::Matrix && poses.b.kind() == Pose::Kind::Matrix;
}

} // namespace

class Metamorphic : public testing::TestWithParam<std::string> {};

TEST_P(Metamorphic, SwappedBodiesGiveThePairsSwapped) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        ScenarioResult expected = result_of(*scene);
        for (ContactPair& pair : expected.pairs) {
            std::swap(pair.a, pair.b);
        }
        std::sort(expected.pairs.begin(), expected.pairs.end());
        const Scene swapped{"", "", scene->b, scene->a, {scene->poses.b, scene->poses.a}};
        EXPECT_EQ(digest_of(result_of(swapped)), digest_of(expected));
    }
}

TEST_P(Metamorphic, TheOrderOfVerticesAndCornersChangesNothing) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const Scene other{"", "", renumbered(scene->a), renumbered(scene->b), scene->poses};
        EXPECT_EQ(digest_of(result_of(other)), digest_of(result_of(*scene)));
    }
}

TEST_P(Metamorphic, PowersOfTwoScalePointsAndChangeNothingElse) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const ScenarioResult expected = result_of(*scene, Level::Contacts);
        for (const int exponent : {20, -20}) {
            const Scene other = rescaled(*scene, exponent);
            if (rescaled(other, -exponent).a.mesh->vertices() != scene->a.mesh->vertices()) {
                continue; // It is below the least denormal.
            }
            ScenarioResult result = result_of(other, Level::Contacts);
            EXPECT_EQ(result.kind, expected.kind);
            EXPECT_EQ(result.pairs, expected.pairs);
            if (scene->category != "extreme magnitudes") { // Denormal points are rounded.
                for (auto* points : {&result.points, &result.point_origins}) {
                    for (Vec3& point : *points) {
                        point = rescaled(point, -exponent);
                    }
                }
                EXPECT_EQ(digest_of(result), digest_of(expected));
            }
        }
    }
}

TEST_P(Metamorphic, TheAxesOfTheWorldChangeNothing) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const Sha256 expected = digest_of(result_of(*scene));
        Scene turned = *scene;
        turned.poses = {turned_half(scene->poses.a), turned_half(scene->poses.b)};
        EXPECT_EQ(digest_of(result_of(turned)), expected);
        if (has_matrices(scene->poses)) {
            turned.poses = {turned_third(scene->poses.a), turned_third(scene->poses.b)};
            EXPECT_EQ(digest_of(result_of(turned)), expected);
        }
    }
}

TEST_P(Metamorphic, TheFirstStageChangesNothing) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const ObbTree a = make_tree(*scene->a.mesh);
        const ObbTree b = make_tree(*scene->b.mesh);
        const std::vector<ContactPair> expected = contact_pairs(a, b, scene->poses);
        for (std::size_t stage = 1; stage < pair_stage_count; ++stage) {
            SearchOptions options;
            options.first_stage = static_cast<PairStage>(stage);
            const auto search = make_search(a.view(), b.view(), scene->poses, {}, options);
            search->collect(a.view(), b.view());
            search->contacts().sort();
            EXPECT_EQ(search->contacts().pairs(), expected) << "first stage " << stage;
        }
    }
}

TEST_P(Metamorphic, TheTreeThatIsWalkedChangesNothing) {
    constexpr BuildOptions binary{.prepare_search = false};
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        for (const Level level : levels) {
            EXPECT_EQ(digest_of(result_of(*scene, level)),
                      digest_of(result_of(*scene, level, binary)));
        }
        // Swap and renumber the bodies, and compare binary trees, too.
        const Scene other{"", "", renumbered(scene->b), scene->a, {scene->poses.b, scene->poses.a}};
        EXPECT_EQ(digest_of(result_of(other)), digest_of(result_of(other, Level::Pairs, binary)));
    }
}

TEST_P(Metamorphic, TheSimdTargetChangesNothing) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const Sha256 expected = digest_of(result_of(*scene, Level::Contacts));
        on_every_target([&](SimdTarget) {
            EXPECT_EQ(digest_of(result_of(*scene, Level::Contacts)), expected);
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, Metamorphic, testing::ValuesIn(scene_categories()), test_name);

} // namespace cd::tests
