// Proves that the wide descent misses no touching pair: random rigid and slightly skew poses,
// distant origins, sizes of different orders, on every SIMD target.

#include "common/tree/wide/wide_descent.hpp"

#include "common/search/brute_force.hpp"
#include "common/search/contact_search.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cd::tests {

namespace {

using IdPair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns the sorted triangle ids of all candidates; expects no duplicates.
std::vector<IdPair> candidates_of(const WideView& a,
                                  const WideView& b,
                                  const PosePair& poses,
                                  std::size_t wanted = 256,
                                  WideDescent::Aim aim = WideDescent::Aim::All,
                                  const Vec3& direction = Vec3::Zero()) {
    WideDescent descent(relative_pose(poses));
    std::vector<IdPair> found;
    descent.start(a, b, aim);
    descent.set_direction(direction);
    while (!descent.is_done()) {
        for (const Candidate& pair : descent.next(wanted)) {
            found.emplace_back(a.triangles.ids[pair.a], b.triangles.ids[pair.b]);
        }
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    return found;
}

Vec3 any_direction(std::size_t seed) {
    std::mt19937_64 random(seed);
    return random_point(random, 1).normalized();
}

struct Tally {
    std::size_t contacts = 0;
    std::size_t candidates = 0;
    std::size_t pairs = 0;
};

/// Expects the candidates of two bodies to include every touching pair.
void expect_none_lost(const Mesh& a, const Mesh& b, const PosePair& poses, Tally& tally) {
    const ObbTree tree_a = make_tree(a);
    const ObbTree tree_b = make_tree(b);
    ASSERT_FALSE(tree_a.view().wide.nodes.empty());
    ASSERT_FALSE(tree_b.view().wide.nodes.empty());
    const std::vector<ContactPair> contacts = contact_pairs_brute_force(a, b, poses);
    on_every_target([&](SimdTarget) {
        const auto found = candidates_of(tree_a.view().wide, tree_b.view().wide, poses);
        for (const ContactPair& pair : contacts) {
            ASSERT_TRUE(std::binary_search(found.begin(), found.end(), IdPair{pair.a, pair.b}))
                << pair.a << " of A and " << pair.b << " of B";
        }
        // Whatever the direction, a descent for the nearest pair finds those at distance 0.
        const auto nearest = candidates_of(tree_a.view().wide,
                                           tree_b.view().wide,
                                           poses,
                                           64,
                                           WideDescent::Aim::Nearest,
                                           any_direction(tally.contacts));
        for (const ContactPair& pair : contacts) {
            ASSERT_TRUE(std::binary_search(nearest.begin(), nearest.end(), IdPair{pair.a, pair.b}))
                << pair.a << " of A and " << pair.b << " of B, along a direction";
        }
        tally.candidates += found.size();
        tally.pairs += a.triangles().size() * b.triangles().size();
    });
    tally.contacts += contacts.size();
}

/// Returns poses that bring a point of A's body to a point of B's.
PosePair meeting_at(const Pose& a, const Vec3& place_a, const Pose& b, const Vec3& place_b) {
    const Vec3 between = a.apply(place_a) - b.apply(place_b);
    return {a, with_translation(b, b.translation() + between)};
}

Mesh any_mesh(std::mt19937_64& random) {
    switch (random() % 5) {
    case 0:
        return make_sphere(2);
    case 1:
        return make_degenerate_soup(random, 60);
    case 2:
        return make_gridded_box(Vec3(1, 0.5, 0.25), 3);
    case 3:
        return make_triangle_soup(random, 120, 0.1);
    default:
        return make_triangle_soup(random, 1 + static_cast<std::uint32_t>(random() % 40));
    }
}

TEST(WideDescent, LosesNoPairUnderRigidPoses) {
    Tally tally;
    for (SeededRandom random : seeds(60)) {
        const Mesh a = any_mesh(random);
        const Mesh b = any_mesh(random);
        const Pose pose_a = any_pose(random, 3);
        const Pose pose_b = random.seed % 5 == 0 ? pose_a : any_pose(random, 3);
        expect_none_lost(
            a, b, meeting_at(pose_a, random_point(random, 1), pose_b, Vec3::Zero()), tally);
    }
    EXPECT_GT(tally.contacts, 1000u);
    EXPECT_LT(tally.candidates, tally.pairs / 4); // Otherwise this proves little.
}

TEST(WideDescent, LosesNoPairUnderSkewPoses) {
    Tally tally;
    for (SeededRandom random : seeds(40)) {
        const Mesh a = any_mesh(random);
        const Mesh b = any_mesh(random);
        // From somewhat more than the bounds allow for to almost none.
        const double skew = std::ldexp(1.1, -10 - static_cast<int>(random.seed % 16));
        Mat3 stretch = Mat3::Identity();
        for (int i = 0; i < 3; ++i) {
            stretch.col(i) += random_point(random, 0.25 * skew);
        }
        const Mat3 turned = make_pose(random, 1).rotation() * stretch;
        const Pose skewed = Pose::from_matrix(turned, random_point(random, 3));
        const Pose other = make_pose(random, 3);
        const bool is_of_a = random() % 2 == 0;
        expect_none_lost(a,
                         b,
                         meeting_at(is_of_a ? skewed : other,
                                    random_point(random, 1),
                                    is_of_a ? other : skewed,
                                    Vec3::Zero()),
                         tally);
    }
    EXPECT_GT(tally.contacts, 500u);
    EXPECT_LT(tally.candidates, tally.pairs / 4);
}

TEST(WideDescent, LosesNoPairFarFromTheOrigin) {
    Tally tally;
    for (SeededRandom random : seeds(40)) {
        const double offset = std::ldexp(1.0, 10 + static_cast<int>(random.seed % 4) * 8);
        const Vec3 place_a = random_point(random, offset);
        const Vec3 place_b = random_point(random, offset);
        const Mesh a = translated(any_mesh(random), place_a);
        const Mesh b = translated(any_mesh(random), place_b);
        expect_none_lost(
            a,
            b,
            meeting_at(any_pose(random, offset), place_a, any_pose(random, 16 * offset), place_b),
            tally);
    }
    EXPECT_GT(tally.contacts, 500u);
}

TEST(WideDescent, LosesNoPairOfBodiesOfDifferentSizes) {
    Tally tally;
    for (SeededRandom random : seeds(60)) {
        // A corner of the small one is on, or in, a triangle of the large one.
        const double scale = std::ldexp(1.0, static_cast<int>(random.seed % 60) - 30);
        const Mesh a = any_mesh(random);
        const Mesh b = scaled(any_mesh(random), scale);
        const Vec3 place_a = a.vertices()[a.triangles()[0][0]];
        const Vec3 place_b = b.vertices()[b.triangles()[0][0]];
        const PosePair poses =
            random() % 2 == 0
                ? meeting_at(any_pose(random, 1), place_a, any_pose(random, 1), place_b)
                : PosePair{translation_pose(-place_a.x(), -place_a.y(), -place_a.z()),
                           translation_pose(-place_b.x(), -place_b.y(), -place_b.z())};
        expect_none_lost(a, b, poses, tally);
    }
    EXPECT_GT(tally.contacts, 60u);
    EXPECT_LT(tally.candidates, tally.pairs / 4);
}

TEST(WideDescent, LosesNoPairOfTheTiniestOnTheLargestTriangles) {
    // One large triangle and all tiny ones have a corner at the origin: in the tiny ones' steps,
    // the large size is near the limit of floats.
    Tally tally;
    for (SeededRandom random : seeds(30)) {
        const double tiny = std::ldexp(1.0, -60 - static_cast<int>(random.seed % 30));
        std::vector<Vec3> small = make_triangle_soup(random, 40).vertices();
        std::vector<Vec3> large = make_triangle_soup(random, 12, 0.1).vertices();
        for (std::uint32_t i = 0; i < small.size(); ++i) {
            if (i < 3 * 24) { // The others make the body large enough.
                small[i] *= i % 3 == 0 ? 0 : tiny;
            }
        }
        for (Vec3& vertex : large) {
            vertex *= 0x1p49;
        }
        large[0] = Vec3::Zero();
        large[1] *= 0x1p-20;
        large[2] *= std::ldexp(1.0, -static_cast<int>(random.seed % 50));
        const Mesh a = make_soup(small);
        const Mesh b = make_soup(large);
        const Pose turn = with_translation(make_pose(random, 1), Vec3::Zero());
        expect_none_lost(a, b, {Pose{}, turn}, tally);
        expect_none_lost(b, a, {turn, Pose{}}, tally);
    }
    EXPECT_GT(tally.contacts, 30u * 2 * 24 - 1);
}

TEST(WideDescent, LosesNoPairWhereNumbersOverflow) {
    Tally tally;
    std::mt19937_64 random(1);
    const Mesh soup = make_triangle_soup(random, 30);
    for (const double far : {1e300, 1e30, 0x1p128, 0x1p140}) {
        SCOPED_TRACE(testing::Message() << "translations of " << far);
        const Pose there = translation_pose(far, -far, far);
        const Pose turned = with_translation(make_pose(random, 1), Vec3(far, -far, far));
        expect_none_lost(soup, soup, {there, there}, tally);
        expect_none_lost(soup, soup, {turned, turned}, tally);
        expect_none_lost(soup, soup, {there, turned}, tally);
        expect_none_lost(soup, soup, {Pose{}, there}, tally);
        const ObbTree tree = make_tree(soup);
        EXPECT_TRUE(contact_pairs(tree, tree, {Pose{}, there}).empty());
        EXPECT_TRUE(contact_pairs(tree, tree, {turned, Pose{}}).empty());
    }
    EXPECT_GT(tally.contacts, 30u * 8);
}

TEST(WideDescent, TheWantedCountChangesNoCandidates) {
    const ObbTree sphere = make_tree(make_sphere(3));
    const WideView view = sphere.view().wide;
    std::mt19937_64 random(2);
    const PosePair poses{Pose{}, make_pose(random, 0.5)};
    on_every_target([&](SimdTarget) {
        const auto expected = candidates_of(view, view, poses, 1u << 20);
        EXPECT_GT(expected.size(), 100u);
        EXPECT_EQ(candidates_of(view, view, poses, 1), expected);
        EXPECT_EQ(candidates_of(view, view, poses, 1000), expected);
    });
}

TEST(WideDescent, EveryAimFindsAllCandidatesInTheEnd) {
    const ObbTree sphere = make_tree(make_sphere(4));
    const WideView view = sphere.view().wide;
    std::mt19937_64 random(5);
    for (const double far : {0.0, 0.5, 1.9, 2.5}) {
        const PosePair poses{Pose{}, make_pose(random, far)};
        on_every_target([&](SimdTarget) {
            const auto expected = candidates_of(view, view, poses);
            for (const auto aim : {WideDescent::Aim::First, WideDescent::Aim::LikelyFirst}) {
                EXPECT_EQ(candidates_of(view, view, poses, 1, aim), expected);
                EXPECT_EQ(candidates_of(view, view, poses, 1u << 20, aim), expected);
            }
        });
    }
}

TEST(WideDescent, PausesAfterMuchWorkAndResumes) {
    // Two shells that are near each other everywhere.
    const ObbTree inner = make_tree(make_sphere(5));
    const ObbTree outer = make_tree(scaled(make_sphere(5), 1.002));
    WideDescent descent{relative_pose(PosePair{})};
    std::size_t pauses = 0;
    std::size_t found = 0;
    for (descent.start(inner.view().wide, outer.view().wide); !descent.is_done();) {
        found += descent.next(1u << 22).size();
        pauses += descent.is_done() ? 0u : 1u;
    }
    EXPECT_GE(pauses, 1u);
    const auto expected = candidates_of(inner.view().wide, outer.view().wide, PosePair{}, 64);
    EXPECT_EQ(found, expected.size());
    // The descent begins anew.
    const std::uint64_t tests = descent.box_tests();
    descent.start(inner.view().wide, outer.view().wide);
    EXPECT_FALSE(descent.is_done());
    static_cast<void>(descent.next(1));
    EXPECT_GT(descent.box_tests(), tests);
}

TEST(WideDescent, GrowsForAllWaitingPairs) {
    // Needles through one point: every box of one body overlaps every box of the other.
    std::mt19937_64 random(3);
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < 40'000; ++i) {
        const Vec3 end = random_point(random, 1);
        corners.insert(corners.end(), {end, -end, end});
    }
    const ObbTree tree = make_tree(make_soup(std::move(corners)));
    const WideView view = tree.view().wide;
    WideDescent descent{relative_pose(PosePair{})};
    descent.start(view, view);
    std::vector<IdPair> found;
    while (found.size() < 300'000) {
        for (const Candidate& pair : descent.next(10'000)) {
            found.emplace_back(pair.a, pair.b);
        }
        ASSERT_FALSE(descent.is_done());
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
}

} // namespace

} // namespace cd::tests
