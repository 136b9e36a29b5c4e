// Proves that a search for the nearest pair finds the one that an exact test of all pairs finds:
// the least rounded distance, and among equal ones the first pair.

#include "common/geometry/aabb.hpp"
#include "common/search/contact_search.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/touching_bodies.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace cd::tests {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Nearest {
    double distance;
    std::uint32_t a;
    std::uint32_t b;

    friend auto operator<=>(const Nearest&, const Nearest&) = default;
};

/// Returns the nearest pair of two bodies that share no point, by the distances of all pairs.
Nearest nearest_of_all(const Mesh& a, const Mesh& b, const PosePair& poses) {
    TriangleDistance distance(poses, DistanceStage::Double);
    Nearest nearest{infinity, 0, 0};
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
            nearest = std::min(nearest, {distance.rounded(a.corners(i), b.corners(j)), i, j});
        }
    }
    return nearest;
}

std::optional<Nearest> found_by(ContactSearch& search) {
    const auto& best = search.nearest().best();
    return best ? std::optional(Nearest{best->distance, best->a, best->b}) : std::nullopt;
}

/// Compares searches of both forms of trees, from a first and from a good guess, with all pairs.
/// Returns the distance, or nothing if the bodies touch.
std::optional<double> expect_agreement(const Mesh& a, const Mesh& b, const PosePair& poses) {
    const BuildOptions variants[] = {{}, {.leaf_triangles_max = 1}, {.boxes = BoxKind::Aabb}};
    std::optional<Nearest> expected;
    for (const BuildOptions& options : variants) {
        ObbTree tree_a = make_tree(a, options);
        ObbTree tree_b = make_tree(b, options);
        tree_a.prepare_planes();
        tree_b.prepare_planes();
        const auto search =
            make_search(tree_a.view(), tree_b.view(), poses, {}, {.nearest_up_to = infinity});
        if (search->any(tree_a.view(), tree_b.view())) {
            return std::nullopt;
        }
        expected = expected ? expected : std::optional(nearest_of_all(a, b, poses));
        for (int round = 0; round < 2; ++round) {
            search->restart(poses);
            search->find_nearest(tree_a.view(), tree_b.view());
            EXPECT_TRUE(found_by(*search) == expected);
        }
        const double distance = expected->distance;
        const auto just =
            make_search(tree_a.view(), tree_b.view(), poses, {}, {.nearest_up_to = 2 * distance});
        just->find_nearest(tree_a.view(), tree_b.view());
        EXPECT_TRUE(found_by(*just) == expected);
        const auto none = make_search(
            tree_a.view(), tree_b.view(), poses, {}, {.nearest_up_to = 0.99 * distance});
        none->find_nearest(tree_a.view(), tree_b.view());
        EXPECT_FALSE(found_by(*none));
    }
    return expected->distance;
}

TEST(NearestSearch, AgreesWithAllPairsOnRandomSoups) {
    int apart = 0;
    for (SeededRandom random : seeds(raised(25))) {
        const Mesh a = make_triangle_soup(random, 30);
        const Mesh b = make_triangle_soup(random, 40, 0.2);
        const double far = std::pow(10, uniform(random, 0, 3));
        const bool is_quaternion = random() % 2 == 0;
        const PosePair poses{make_pose(random, 1),
                             is_quaternion ? make_pose(random, far)
                                           : make_matrix_pose(random, far)};
        apart += expect_agreement(a, b, poses) ? 1 : 0;
    }
    EXPECT_GT(apart, 10);
}

TEST(NearestSearch, TheFirstOfEquallyNearPairsIsTheAnswer) {
    const Mesh box = make_gridded_box(Vec3(1, 1, 1), 4);
    EXPECT_EQ(expect_agreement(box, box, {Pose{}, translation_pose(1.25, 0, 0)}), 0.25);
    EXPECT_EQ(expect_agreement(box, box, {Pose{}, translation_pose(1.25, 1.25, 0)}),
              std::sqrt(0.125));
    EXPECT_EQ(expect_agreement(box, box, {Pose{}, translation_pose(0, 0, 5)}), 4.0);
}

TEST(NearestSearch, AgreesWithAllPairsWhereBodiesNearlyTouch) {
    int apart = 0;
    for (std::size_t category = 0; category < touching_categories; ++category) {
        SCOPED_TRACE(touching_category(category));
        for (SeededRandom random : seeds(1)) {
            TouchingBodies bodies = make_touching(category, random);
            const double size = bounding_box(bodies.a.vertices()).diagonal();
            for (const double share : {0.0, 1e-6, 0.1}) {
                PosePair poses = bodies.poses;
                poses.b = Pose::from_matrix(poses.b.rotation(),
                                            poses.b.translation() + share * size * bodies.outwards);
                apart += expect_agreement(bodies.a, bodies.b, poses) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(apart, 20);
}

TEST(NearestSearch, EarlierPosesChangeNoAnswer) {
    ObbTree torus = make_tree(make_torus(1, 0.3, 60, 30));
    ObbTree box = make_tree(make_gridded_box(Vec3(1, 0.5, 0.25), 12));
    torus.prepare_planes();
    box.prepare_planes();
    const SearchOptions options{.nearest_up_to = infinity};
    const auto kept = make_search(torus.view(), box.view(), PosePair{}, {}, options);
    Vec3 place(1.95, 0, 0);
    for (SeededRandom random : seeds(60)) {
        place += 0.02 * make_pose(random, 1).translation();
        const PosePair poses{Pose{}, translation_pose(place.x(), place.y(), place.z())};
        kept->restart(poses);
        if (kept->any(torus.view(), box.view())) {
            continue;
        }
        kept->find_nearest(torus.view(), box.view());
        const auto fresh = make_search(torus.view(), box.view(), poses, {}, options);
        fresh->find_nearest(torus.view(), box.view());
        EXPECT_TRUE(found_by(*kept) == found_by(*fresh));
    }
}

TEST(NearestSearch, IgnoredPairsDoNotCount) {
    const ObbTree box = make_tree(make_box(Vec3(1, 1, 1)));
    const PosePair poses{Pose{}, translation_pose(1.25, 0, 0)};
    const auto whole = make_search(box.view(), box.view(), poses, {}, {.nearest_up_to = infinity});
    whole->find_nearest(box.view(), box.view());
    const Nearest nearest = *found_by(*whole);
    const IgnoredRange ignored[] = {{nearest.a, nearest.a + 1, 0, 12}};
    const auto search =
        make_search(box.view(), box.view(), poses, ignored, {.nearest_up_to = infinity});
    search->find_nearest(box.view(), box.view());
    ASSERT_TRUE(found_by(*search));
    EXPECT_NE(found_by(*search)->a, nearest.a);
}

} // namespace

} // namespace cd::tests
