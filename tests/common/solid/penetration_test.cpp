// Proves that bodies that touch without a proper pair count as penetrating exactly if their
// interiors meet: solids on a lattice, checked in integers, in every axis orientation, under both
// kinds of poses, wound outward and inward, mirrored; and bodies that exercise each part of the
// rule.

#include "common/solid/penetration.hpp"

#include "common/search/contact_search.hpp"
#include "tests/support/lattice_solids.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace cd::tests {

namespace {

bool is_proper(const std::vector<ContactPair>& contacts) {
    return std::any_of(contacts.begin(), contacts.end(), [](const ContactPair& contact) {
        return contact.kind == PairClass::Proper;
    });
}

/// The relation of two bodies as found from their contacts.
enum class Found { Nothing, Proper, Touch, Penetrate };

Found found(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    const std::vector<ContactPair> contacts = contact_pairs(a, b, poses);
    if (contacts.empty() || is_proper(contacts)) {
        return contacts.empty() ? Found::Nothing : Found::Proper;
    }
    SettleStatistics statistics;
    return penetrates(a, b, poses, contacts, {}, statistics) ? Found::Penetrate : Found::Touch;
}

Found found(const Mesh& a, const Mesh& b, const Pose& pose_of_b = Pose{}) {
    const ObbTree tree_a = make_tree(a);
    const ObbTree tree_b = make_tree(b);
    const Found result = found(tree_a, tree_b, {Pose{}, pose_of_b});
    EXPECT_EQ(found(tree_b, tree_a, {pose_of_b, Pose{}}), result) << "the other way round";
    return result;
}

/// Makes a box between two corners with integer coordinates.
Mesh box_at(const Vec3& low, const Vec3& high, int grid = 1) {
    return translated(make_gridded_box(high - low, grid), 0.5 * (low + high));
}

struct Tally {
    int proper = 0;
    int touch = 0;
    int penetrate = 0;

    void add(Found found) {
        proper += found == Found::Proper ? 1 : 0;
        touch += found == Found::Touch ? 1 : 0;
        penetrate += found == Found::Penetrate ? 1 : 0;
    }
};

/// Makes a prism along y from the first to the last level, with edges at every level. The outline
/// is in x and z; the ends are fanned from its first point.
Mesh prism(const std::vector<std::array<double, 2>>& outline, const std::vector<double>& levels) {
    const auto around = static_cast<std::uint32_t>(outline.size());
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const double y : levels) {
        for (const auto& [x, z] : outline) {
            vertices.emplace_back(x, y, z);
        }
    }
    for (std::uint32_t from = 0; from + around < vertices.size(); from += around) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t next = (i + 1) % around;
            triangles.push_back({from + i, from + next, from + around + next});
            triangles.push_back({from + i, from + around + next, from + around + i});
        }
    }
    const auto last = static_cast<std::uint32_t>(vertices.size()) - around;
    for (std::uint32_t i = 1; i + 1 < around; ++i) {
        triangles.push_back({0, i + 1, i});
        triangles.push_back({last, last + i, last + i + 1});
    }
    return make_mesh(std::move(vertices), std::move(triangles));
}

/// Makes a slab from z = 0 to 1 with an edge along y at x = `bottom` below and x = `top` above.
Mesh slab(double bottom, double top) {
    return prism({{-20, 0}, {bottom, 0}, {20, 0}, {20, 1}, {top, 1}, {-20, 1}}, {0, 1, 3, 4});
}

/// Compares what two bodies' contacts say, whichever is A, with the truth, then counts it. Passes
/// over cubes that meet along an edge only, whose surface bounds no solid, and over bodies of
/// several components, which another test covers.
void expect_truth(
    const Mesh& a, const Mesh& b, const PosePair& poses, bool interiors_meet, Tally& tally) {
    const ObbTree tree_a = make_tree(a);
    const ObbTree tree_b = make_tree(b);
    for (const ObbTree* tree : {&tree_a, &tree_b}) {
        if (!tree->topology().is_closed() || tree->topology().component_triangles.size() != 1) {
            return;
        }
    }
    const Found result = found(tree_a, tree_b, poses);
    ASSERT_EQ(found(tree_b, tree_a, {poses.b, poses.a}), result);
    tally.add(result);
    if (result != Found::Nothing) {
        EXPECT_EQ(result != Found::Touch, interiors_meet);
    }
}

int from_1_to(std::mt19937_64& random, std::uint64_t most) {
    return static_cast<int>(1 + random() % most);
}

/// Combines the turn of a body whose coordinates were multiplied by 5 with a 3-4-5 turn, which then
/// keeps all numbers integer.
Pose turned_by_3_4_5(const LatticeTurn& turn, const Quaternion& by) {
    const Vec3 offset(turn.motion.offset[0], turn.motion.offset[1], turn.motion.offset[2]);
    const Vec3 moved = Pose::from_quaternion(by, Vec3::Zero()).apply(5 * offset);
    return Pose::from_quaternion(by * turn.quaternion, moved.array().round());
}

} // namespace

TEST(Penetration, CubesPenetrateExactlyWhereTheyShareACube) {
    Tally tally;
    for (SeededRandom random : seeds(1200)) {
        const CubeSolid a = random_cubes(random, from_1_to(random, 5), 2);
        const CubeSolid b = random_cubes(random, from_1_to(random, 5), from_1_to(random, 3));
        const LatticeMotion motion_a = random_motion(random, 2, true);
        const LatticeMotion motion_b = random_motion(random, 2, true);
        expect_truth(a.mesh,
                     b.mesh,
                     {motion_a.pose(), motion_b.pose()},
                     interiors_meet(a, motion_a, b, motion_b),
                     tally);
    }
    EXPECT_GT(tally.touch, 120);
    EXPECT_GT(tally.penetrate, 60);
    EXPECT_GT(tally.proper, 100);
}

TEST(Penetration, AnswersSurviveExactQuaternionTurns) {
    constexpr std::array<Quaternion, 4> turns{
        Quaternion{1, 0, 0, 0}, {2, 1, 0, 0}, {2, 0, 1, 0}, {2, 0, 0, -1}};
    Tally tally;
    for (SeededRandom random : seeds(800)) {
        const CubeSolid a = random_cubes(random, from_1_to(random, 4), 2);
        const CubeSolid b = random_cubes(random, from_1_to(random, 4), from_1_to(random, 2));
        const LatticeTurn turn_a = random_turn(random, 2);
        const LatticeTurn turn_b = random_turn(random, 2);
        const Quaternion& by = turns[random.seed % turns.size()];
        const PosePair poses{turned_by_3_4_5(turn_a, by), turned_by_3_4_5(turn_b, by)};
        expect_truth(scaled(a.mesh, 5),
                     scaled(b.mesh, 5),
                     poses,
                     interiors_meet(a, turn_a.motion, b, turn_b.motion),
                     tally);
    }
    EXPECT_GT(tally.touch, 80);
    EXPECT_GT(tally.penetrate, 30);
    EXPECT_GT(tally.proper, 30);
}

TEST(Penetration, TetrahedraPenetrateExactlyWhereNoPlaneIsBetween) {
    Tally tally;
    for (SeededRandom random : seeds(1500)) {
        Tetrahedron a = random_tetrahedron(random, 2);
        for (LatticePoint& corner : a.corners) {
            corner = {2 * corner[0], 2 * corner[1], 2 * corner[2]};
        }
        a.mesh = scaled(a.mesh, 2);
        const Tetrahedron b = random_relative(random, a);
        const LatticeMotion motion = random_motion(random, 1, true);
        expect_truth(a.mesh,
                     b.mesh,
                     {motion.pose(), motion.pose()},
                     interiors_meet(a, motion, b, motion),
                     tally);
    }
    EXPECT_GT(tally.touch, 120);
    EXPECT_GT(tally.penetrate, 200);
    EXPECT_GT(tally.proper, 120);
}

TEST(Penetration, StackedBoxesTouchWhateverTheirGridsAndWindings) {
    for (const int grid : {1, 2, 3, 5}) {
        for (const double shift : {0.0, 0.5, 1.0, 1.75}) {
            const Mesh lower = box_at(Vec3(0, 0, 0), Vec3(4, 4, 4), 4);
            const Mesh upper = box_at(Vec3(shift, 0, 4), Vec3(shift + 4, 4, 6), grid);
            for (const bool reverses : {false, true}) {
                EXPECT_EQ(found(lower, reverses ? reversed(upper) : upper), Found::Touch)
                    << grid << ' ' << shift;
                EXPECT_EQ(found(reversed(lower), reverses ? reversed(upper) : upper), Found::Touch);
            }
        }
    }
}

TEST(Penetration, BoxesOnASharedFaceEdgeOrCornerAreClassified) {
    const Mesh box = box_at(Vec3(0, 0, 0), Vec3(4, 4, 4), 4);
    EXPECT_EQ(found(box, box), Found::Penetrate) << "on itself";
    EXPECT_EQ(found(box, reversed(box)), Found::Penetrate) << "on itself, inside out";
    EXPECT_EQ(found(box, box_at(Vec3(1, 1, 0), Vec3(3, 3, 2))), Found::Penetrate) << "face";
    EXPECT_EQ(found(box, box_at(Vec3(0, 1, 0), Vec3(2, 3, 2))), Found::Penetrate) << "edge";
    EXPECT_EQ(found(box, box_at(Vec3(0, 0, 0), Vec3(2, 3, 1))), Found::Penetrate) << "corner";
    EXPECT_EQ(found(box, box_at(Vec3(4, 4, 0), Vec3(6, 6, 4))), Found::Touch) << "edge, outside";
    EXPECT_EQ(found(box, box_at(Vec3(4, 4, 4), Vec3(6, 6, 6))), Found::Touch) << "corner, outside";
    // The boxes cross along grid lines.
    EXPECT_EQ(found(box, box, translation_pose(1, 1, 1)), Found::Penetrate);
    EXPECT_EQ(found(box, box, translation_pose(2, 0, 0)), Found::Penetrate);
    EXPECT_EQ(found(box, box, translation_pose(4, 1, 2)), Found::Touch);
}

TEST(Penetration, APlateSlidAlongGridLinesIsFoundInAPieceOfItsTriangles) {
    const Mesh box = box_at(Vec3(0, 0, 0), Vec3(4, 4, 4), 4);
    // Only a sixteenth of the plate is in the box; the centroids of its large triangles are not.
    EXPECT_EQ(found(box, box_at(Vec3(3, 1, 1), Vec3(19, 2, 3))), Found::Penetrate);
    EXPECT_EQ(found(box, box_at(Vec3(4, 1, 1), Vec3(19, 2, 3))), Found::Touch);
}

TEST(Penetration, PiecesDecideWhereNoCentroidIsInside) {
    // A bar through the slab. The surfaces meet along four lines, two of them edges of the bar and
    // two of the slab; so every triangle extends beyond the inside part.
    const Mesh bar = prism({{1, 1}, {1, -10}, {2, -10}, {2, 0}, {2, 10}, {1, 10}}, {1, 3});
    EXPECT_EQ(found(slab(1, 2), bar), Found::Penetrate);
    EXPECT_EQ(found(slab(1, 2), bar, translation_pose(0, 0, 0.5)), Found::Proper);
    // The bar with a foot on which the slab rests.
    const Mesh foot =
        prism({{0, 0}, {0, 10}, {2, 10}, {2, 1}, {2, -10}, {-10, -10}, {-10, 0}}, {1, 3});
    EXPECT_EQ(found(slab(2, 0), foot), Found::Penetrate);
    EXPECT_EQ(found(slab(2, 0), foot, translation_pose(-10, 0, -10)), Found::Touch);
}

TEST(Penetration, ACornerAtTheCentroidHidesNothing) {
    // A box whose top is dented to the origin, where the dent meets a face's middle from inside.
    const Mesh dented = make_mesh({{-4, -4, -4},
                                   {4, -4, -4},
                                   {4, 4, -4},
                                   {-4, 4, -4},
                                   {-4, -4, 4},
                                   {4, -4, 4},
                                   {4, 4, 4},
                                   {-4, 4, 4},
                                   {0, 0, 0}},
                                  {{0, 2, 1},
                                   {0, 3, 2},
                                   {0, 1, 5},
                                   {0, 5, 4},
                                   {1, 2, 6},
                                   {1, 6, 5},
                                   {2, 3, 7},
                                   {2, 7, 6},
                                   {3, 0, 4},
                                   {3, 4, 7},
                                   {4, 5, 8},
                                   {5, 6, 8},
                                   {6, 7, 8},
                                   {7, 4, 8}});
    const Mesh within = make_mesh({{2, -1, 0}, {-1, 2, 0}, {-1, -1, 0}, {0, 0, -2}},
                                  {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
    EXPECT_EQ(found(dented, within), Found::Penetrate);
}

TEST(Penetration, ARidgeUnderAFaceDoesNotPierceIt) {
    // A roof whose ridge is at height 1, under the middle of a large box's bottom.
    const Mesh roof = make_mesh(
        {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, -1, 1}, {0, 1, 1}},
        {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {2, 3, 5}, {1, 2, 5}, {1, 5, 4}, {3, 0, 4}, {3, 4, 5}});
    const Mesh box = make_box(Vec3(8, 8, 2));
    EXPECT_EQ(found(roof, box, translation_pose(0.3, 0.2, 2)), Found::Touch);
    EXPECT_EQ(found(roof, box, translation_pose(0.3, 0.2, 1.75)), Found::Proper);
    // From inside, the roof reaches the box's top.
    EXPECT_EQ(found(roof, box, translation_pose(0.3, 0.2, 0)), Found::Penetrate);
    // A single corner under the face.
    const Mesh spike = make_mesh({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
    EXPECT_EQ(found(spike, box, translation_pose(0.3, 0.2, 2)), Found::Touch);
    EXPECT_EQ(found(spike, box, translation_pose(0.3, 0.2, 0)), Found::Penetrate);
}

TEST(Penetration, ABodyInANotchTouches) {
    const Mesh notched = cubes_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).mesh;
    const Mesh tetrahedron = make_mesh({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {1, 1, 1}},
                                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
    EXPECT_EQ(found(notched, tetrahedron), Found::Touch);
    EXPECT_EQ(found(notched, tetrahedron, translation_pose(-1, 0, 0)), Found::Penetrate);
    EXPECT_EQ(found(notched, cubes_at({{1, 1, 0}}).mesh), Found::Touch);
}

TEST(Penetration, CavitiesAndOtherComponentsCountByParity) {
    const Mesh outside = box_at(Vec3(0, 0, 0), Vec3(8, 8, 8), 2);
    const Mesh cavity = box_at(Vec3(2, 2, 2), Vec3(6, 6, 6), 2);
    const Mesh on_its_floor = box_at(Vec3(3, 3, 2), Vec3(4, 4, 3));
    const Mesh on_the_top = box_at(Vec3(3, 3, 8), Vec3(4, 4, 9));
    const Mesh under_its_floor = box_at(Vec3(3, 3, 1), Vec3(4, 4, 2));
    // With any winding of the components, the space between them is the solid.
    for (const Mesh& outer : {outside, reversed(outside)}) {
        for (const Mesh& inner : {cavity, reversed(cavity)}) {
            const Mesh hollow = join({outer, inner});
            EXPECT_EQ(found(hollow, on_its_floor), Found::Touch);
            EXPECT_EQ(found(hollow, cavity), Found::Touch) << "fills the cavity";
            EXPECT_EQ(found(hollow, on_the_top), Found::Touch);
            EXPECT_EQ(found(hollow, under_its_floor), Found::Penetrate);
            EXPECT_EQ(found(hollow, hollow), Found::Penetrate);
        }
    }
    const Mesh apart = translated(outside, Vec3(20, 0, 0));
    EXPECT_EQ(found(join({outside, apart}), on_the_top), Found::Touch);
    EXPECT_EQ(found(join({apart, outside}), join({apart, on_the_top})), Found::Penetrate);
    // Two overlapping components: on their common top nothing is known, beside it everything.
    const Mesh overlapping = join({outside, box_at(Vec3(1, 0, 0), Vec3(9, 8, 8), 3)});
    EXPECT_EQ(found(overlapping, on_the_top), Found::Touch);
}

TEST(Penetration, DegenerateTrianglesReachInAsTheSegmentsThatTheyAre) {
    const Mesh box = box_at(Vec3(0, 0, 0), Vec3(4, 4, 4), 4);
    const auto needle = [](const Vec3& from, const Vec3& to) {
        return make_mesh({from, to}, {Triangle{0, 0, 1}});
    };
    EXPECT_EQ(found(box, needle(Vec3(-8, 1.5, 1.25), Vec3(1, 1.5, 1.25))), Found::Penetrate);
    EXPECT_EQ(found(box, needle(Vec3(-8, 1.5, 1.25), Vec3(0, 1.5, 1.25))), Found::Touch);
    EXPECT_EQ(found(box, needle(Vec3(-8, 1.5, 4), Vec3(9, 1.25, 4))), Found::Touch) << "along";
    EXPECT_EQ(found(box, needle(Vec3(-1, 1, 3), Vec3(1, 1, 5))), Found::Touch) << "on an edge";
    EXPECT_EQ(found(box, needle(Vec3(-1, 1, 2), Vec3(2, 1, 5))), Found::Penetrate);
    EXPECT_EQ(found(box, needle(Vec3(1, 1, 4), Vec3(1, 1, 4))), Found::Touch) << "a point";
}

TEST(Penetration, FlattenedBodiesHaveNoInside) {
    const ObbTree box = make_tree(box_at(Vec3(0, 0, 0), Vec3(4, 4, 4), 2));
    const Pose flat = Pose::from_matrix(Vec3(1, 1, 0).asDiagonal(), Vec3(0, 0, 0));
    EXPECT_EQ(found(box, box, {flat, flat}), Found::Touch);
    EXPECT_EQ(found(box, box, {Pose{}, flat}), Found::Touch) << "on the bottom";
    EXPECT_EQ(found(box, box, {flat, Pose{}}), Found::Touch);
    // The flat body in the middle; its sides are lines on the other's sides.
    const Pose middle = Pose::from_matrix(Vec3(1, 1, 0).asDiagonal(), Vec3(0, 0, 2));
    EXPECT_EQ(found(box, box, {Pose{}, middle}), Found::Penetrate);
    EXPECT_EQ(found(box, box, {middle, Pose{}}), Found::Penetrate);
}

TEST(Penetration, IgnoredPairsDecideNothing) {
    const ObbTree box = make_tree(box_at(Vec3(0, 0, 0), Vec3(4, 4, 4), 4));
    const PosePair poses{Pose{}, translation_pose(1, 1, 1)};
    const auto count = static_cast<std::uint32_t>(box.mesh().triangles().size());
    const auto penetrates_but = [&](const std::vector<IgnoredRange>& ignored, const PosePair& at) {
        std::vector<ContactPair> left = contact_pairs(box, box, at);
        std::erase_if(left,
                      [&](const ContactPair& pair) { return is_ignored(ignored, pair.a, pair.b); });
        SettleStatistics statistics;
        return penetrates(box, box, at, left, ignored, statistics);
    };
    EXPECT_TRUE(penetrates_but({}, poses));
    EXPECT_FALSE(penetrates_but({{0, count, 0, count}}, poses));
    // Every triangle is ignored in some pair: no interior point is tested.
    EXPECT_FALSE(penetrates_but({{0, count, 0, 1}, {0, 1, 0, count}}, poses));
    // The remaining coplanar pairs still count.
    EXPECT_TRUE(penetrates_but({{0, count, 0, 1}, {0, 1, 0, count}}, PosePair{}));
}

} // namespace cd::tests
