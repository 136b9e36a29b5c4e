// Proves that spheres never leave out a pair of subtrees with triangles within the distance, and
// that they leave out most pairs of bodies that are near each other in few places.
#include "common/motion/pair_spheres.hpp"

#include "common/search/contact_search.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace cd::tests {

namespace {

std::vector<Subtree> parts_of(const ObbTree& tree, std::uint32_t depth, SubtreeForm form) {
    std::vector<Subtree> parts;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        parts.push_back(extract_subtree(tree, node, form));
    }
    return parts;
}

/// All pairs of parts of two bodies.
class Parts {
  public:
    Parts(const ObbTree& a, const ObbTree& b, std::uint32_t depth, SubtreeForm form)
        : a_(parts_of(a, depth, form)), b_(parts_of(b, depth, form)) {
        for (const Subtree& one : a_) {
            for (const Subtree& other : b_) {
                pairs_.push_back({one.view(), other.view()});
            }
        }
    }
    [[nodiscard]] const std::vector<SubtreePair>& pairs() const { return pairs_; }

  private:
    std::vector<Subtree> a_;
    std::vector<Subtree> b_;
    std::vector<SubtreePair> pairs_;
};

const Pose still = moved_pose(Vec3::Zero()); // As motions have it: a quaternion.

Pose moved_to(double x, double y, double z) {
    return moved_pose(Vec3(x, y, z));
}

bool are_within(const SubtreePair& pair, const PosePair& poses, double distance) {
    return make_search(pair.a, pair.b, poses, {}, {.clearance = distance})
               ->any_near(pair.a, pair.b) != Nearness::Far;
}

} // namespace

TEST(PairSpheres, LeaveOutNoPairWithinTheDistance) {
    std::uint64_t within = 0;
    std::uint64_t left_out = 0;
    std::uint64_t all = 0;
    for (SeededRandom random : seeds(40)) {
        const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        const ObbTree a = make_tree(scaled(make_sphere(2), size));
        const ObbTree b = make_tree(scaled(make_triangle_soup(random, 40), size));
        const Parts parts(a, b, 4, random() % 2 == 0 ? SubtreeForm::Wide : SubtreeForm::Binary);
        PairSpheres spheres(parts.pairs());
        const PosePair poses{make_pose(random, 0.1 * size), make_pose(random, 3 * size)};
        const double distance = uniform(random, 0, 0.5) * size;
        spheres.place(poses, distance);
        for (std::size_t i = 0; i < parts.pairs().size(); ++i) {
            const bool is_within = are_within(parts.pairs()[i], poses, distance);
            EXPECT_TRUE(!is_within || spheres.may_be_within(i));
            within += is_within ? 1 : 0;
            left_out += spheres.may_be_within(i) ? 0 : 1;
            ++all;
        }
    }
    EXPECT_GT(within, 50u);
    EXPECT_GT(left_out, all / 2);
}

TEST(PairSpheres, SpheresThatMeetInOnePointAreNotLeftOut) {
    const ObbTree box = make_tree(make_box({1, 1, 1}));
    const SubtreePair pair{box.view(), box.view()};
    PairSpheres spheres({&pair, 1});
    const double gap = 0.5; // The corners of two boxes on a diagonal.
    const double x = 1 + gap / std::sqrt(3.0);
    spheres.place({still, moved_to(x, x, x)}, gap * (1 + 0x1p-50));
    EXPECT_TRUE(spheres.may_be_within(0));
    spheres.place({still, moved_to(x + 4, x + 4, x + 4)}, gap);
    EXPECT_FALSE(spheres.may_be_within(0));
}

TEST(PairSpheres, NothingIsLeftOutWhereNothingIsProven) {
    const ObbTree box = make_tree(make_box({1, 1, 1}));
    const SubtreePair pair{box.view(), box.view()};
    PairSpheres spheres({&pair, 1});
    const Pose stretched = Pose::from_matrix(2 * Mat3::Identity(), Vec3(100, 0, 0));
    spheres.place({still, stretched}, 1);
    EXPECT_TRUE(spheres.may_be_within(0)) << "a matrix that is not rigid";
    spheres.place({still, moved_to(1e300, 0, 0)}, 1);
    EXPECT_TRUE(spheres.may_be_within(0)) << "numbers overflow";
    spheres.place({still, moved_to(100, 0, 0)}, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(spheres.may_be_within(0));
    spheres.place({still, moved_to(100, 0, 0)}, 1);
    EXPECT_FALSE(spheres.may_be_within(0));
}

} // namespace cd::tests
