// Proves that the batched double stage returns only true answers, on every kind of hard pair and on
// those that a search or a turn's axis brings to the bounds; that smaller bounds fail; and that
// answers are equal on every SIMD target, in any batch and order.
#include "common/pair/stages/double_batch/double_triangle_pairs.hpp"

#include "common/pair/poses/plain_poses.hpp"
#include "tests/common/pair/pair_batch.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/proven_class.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cd::tests {

namespace {

using Decided = std::optional<PairClass>;

Decided decided(const PosedPair& c, double bound_scale = 1) {
    DoubleTrianglePairs pairs(plain_poses(c.poses), bound_scale);
    pairs.add(c.a, c.b);
    pairs.decide();
    return pairs.decided(0);
}

/// Decides one pair eight times, with its corners in other orders.
std::vector<Decided> decided_in_all_orders(const PosedPair& c) {
    DoubleTrianglePairs pairs(plain_poses(c.poses));
    for (std::size_t i = 0; i < DoubleTrianglePairs::pairs_max; ++i) {
        const auto order = [](const Corners& t, std::size_t first, bool is_mirrored) {
            return Corners{t[first % 3],
                           t[(first + (is_mirrored ? 2 : 1)) % 3],
                           t[(first + (is_mirrored ? 1 : 2)) % 3]};
        };
        pairs.add(order(c.a, i % 3, i % 2 == 0), order(c.b, i / 3, i % 4 < 2));
    }
    pairs.decide();
    std::vector<Decided> all;
    for (std::size_t i = 0; i < DoubleTrianglePairs::pairs_max; ++i) {
        all.push_back(pairs.decided(i));
    }
    return all;
}

Proofs proofs_with(PosedPair (*make)(std::mt19937_64&), double bound_scale) {
    return proofs_of(make, [&](const PosedPair& c) { return decided(c, bound_scale); });
}

/// Both lie in a plane perpendicular to an axis, about which both may be turned. A corner of B is
/// nearly on an edge of A, or is a corner of A; B is beyond that edge.
PosedPair in_one_plane(std::mt19937_64& random) {
    const auto axis = static_cast<int>(random() % 3);
    PosedPair c{random_corners(random, 1), random_corners(random, 1), {}};
    const double height = c.a[0][axis];
    for (Corners* corners : {&c.a, &c.b}) {
        for (Vec3& corner : *corners) {
            corner[axis] = height;
        }
    }
    // The edge is long, so that differences of corners round.
    const Vec3 place = c.a[0];
    const Vec3 along = c.a[1] - place;
    const bool shares_corner = random() % 3 == 0;
    if (!shares_corner) {
        c.a[0] = place - uniform(random, 0, 30) * along;
        c.a[1] = place + uniform(random, 0, 30) * along;
    }
    const auto side = [&](const Vec3& x) { return along.cross(x - c.a[0])[axis]; };
    for (Vec3& corner : c.b) {
        corner = side(corner) * side(c.a[2]) > 0 ? Vec3(2 * place - corner) : corner;
    }
    c.b[random() % 3] = place;
    if (random() % 2 == 0) {
        const auto turn = [&] {
            Quaternion q{uniform(random, 0.1, 1), 0, 0, 0};
            (axis == 0 ? q.x : axis == 1 ? q.y : q.z) = uniform(random, -1, 1);
            return Pose::from_quaternion(q, Vec3::Zero());
        };
        c.poses = {turn(), turn()};
        const Mat3 a_to_b = c.poses.b.rotation().transpose() * c.poses.a.rotation();
        for (Vec3& corner : c.b) {
            corner = a_to_b * corner;
            corner[axis] = height;
        }
    }
    return c;
}

} // namespace

TEST(ManyInDoubles, OnlyProveWhatIsTrueOfHardPairsInAnyOrder) {
    int proven = 0;
    int proven_one_by_one = 0;
    for (const auto& [name, make] : pair_makers()) {
        for (std::uint64_t seed = 3000; seed < 3040; ++seed) {
            SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
            std::mt19937_64 random(seed);
            const PosedPair c = make(random);
            const PairClass expected = oracle_class(c.a, c.b, c.poses);
            for (const Decided& found : decided_in_all_orders(c)) {
                ASSERT_EQ(found.value_or(expected), expected);
            }
            proven += decided(c) ? 1 : 0;
            proven_one_by_one += proven_in_double(c.poses, c.a, c.b) ? 1 : 0;
        }
    }
    EXPECT_GT(proven, proven_one_by_one * 3 / 4);
}

TEST(ManyInDoubles, TheirBoundsAreNeeded) {
    EXPECT_EQ(proofs_with(nearly_touching, 1).wrong, 0);
    EXPECT_GT(proofs_with(nearly_touching, 0.03).wrong, 10);
}

TEST(ManyInDoubles, TiesAlongTheAxisOfATurnAreProvenAndOnlyThose) {
    const Proofs proofs = proofs_with(turned_about_an_axis, 1);
    EXPECT_EQ(proofs.wrong, 0);
    EXPECT_GT(proofs.of_contact, 1000);
    EXPECT_GT(proofs_with(turned_about_an_axis, 0.03).wrong, 10);
}

TEST(ManyInDoubles, ContactsInOnePlaneAreProvenAndOnlyThose) {
    const Proofs proofs = proofs_with(in_one_plane, 1);
    EXPECT_EQ(proofs.wrong, 0);
    EXPECT_GT(proofs.of_contact, 1000);
    EXPECT_GT(proofs_with(in_one_plane, 0.03).wrong, 10);
}

TEST(ManyInDoubles, TinyAndHugeValuesAreNotTakenForZero) {
    expect_zero_is_not_assumed(in_one_plane, [](const PosedPair& c) { return decided(c); });
}

TEST(ManyInDoubles, EveryTargetGivesTheSameAnswersInAnyBatch) {
    std::mt19937_64 random(19);
    for (int round = 0; round < 400; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        PosedPair c = round % 2 == 0 ? in_one_plane(random) : turned_about_an_axis(random);
        std::vector<PosedPair> all{c};
        while (all.size() < DoubleTrianglePairs::pairs_max) {
            all.push_back(in_one_plane(random));
            all.back().poses = c.poses;
        }
        std::vector<Decided> alone;
        for (const PosedPair& each : all) {
            alone.push_back(decided(each));
        }
        on_every_target([&](SimdTarget) {
            DoubleTrianglePairs pairs(plain_poses(c.poses));
            for (const PosedPair& each : all) {
                pairs.add(each.a, each.b);
            }
            pairs.decide();
            for (std::size_t i = 0; i < all.size(); ++i) {
                ASSERT_EQ(pairs.decided(i), alone[i]) << "pair " << i;
            }
        });
    }
}

} // namespace cd::tests
