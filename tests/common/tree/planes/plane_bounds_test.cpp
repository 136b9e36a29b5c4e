// Proves that planes part only what is apart: in exact terms along the plane's own normal, and on
// bodies that touch at the brink. Also proves that the margins and eps are needed: with smaller
// ones planes part what touches.
#include "common/search/wide_search.hpp"
#include "common/tree/planes/plane_kernel.hpp"
#include "common/tree/planes/plane_proof.hpp"
#include "common/tree/planes/support_points.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/touching_bodies.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

/// The slow twin of `separate`: computes in rational numbers, from all vertices, how far apart two
/// bodies are along a normal in A's coordinates.
Rational exact_gap(const Mesh& a, const Mesh& b, const PosePair& poses, const PlaneNormal& normal) {
    const ExactVec n{Rational(normal[0]), Rational(normal[1]), Rational(normal[2])};
    // n (Ra^-1 (Rb y + tb - ta)) = w (Rb y + tb - ta) with w = Ra^-T n.
    const ExactVec w = transposed(inverse(exact_rotation(poses.a))) * n;
    const ExactVec m = transposed(exact_rotation(poses.b)) * w;
    const ExactVec offset =
        exact(poses.b.translation()) + scaled(Rational(-1), exact(poses.a.translation()));
    std::optional<Rational> last;
    for (const Vec3& vertex : a.vertices()) {
        const Rational reach = dot(n, exact(vertex));
        last = last && *last > reach ? *last : reach;
    }
    std::optional<Rational> first;
    for (const Vec3& vertex : b.vertices()) {
        const Rational reach = dot(m, exact(vertex));
        first = first && *first < reach ? *first : reach;
    }
    return *first + dot(w, offset) - *last;
}

/// Two trees with support points.
struct PlaneTrees {
    explicit PlaneTrees(const TouchingBodies& bodies)
        : a(make_tree(bodies.a)), b(make_tree(bodies.b)) {
        a.prepare_planes();
        b.prepare_planes();
    }

    ObbTree a;
    ObbTree b;
};

/// Tries to part the two roots; returns the normal if it can.
std::optional<PlaneNormal>
parted(const WideView& a, const WideView& b, const PosePair& poses, double error_scale) {
    const PlanePose pose = plane_pose(relative_pose(poses), a.support, b.support, error_scale);
    PlaneNormal normal = first_normal(pose);
    return separate(pose, PlaneBody(a), 0, PlaneBody(b), 0, 8, normal) > 0 ? std::optional(normal)
                                                                           : std::nullopt;
}

struct Counts {
    std::size_t parted = 0;
    std::size_t wrong = 0; ///< Parted, but not apart along the plane's normal.
};

/// Calls `work` with bodies of a category, their wide trees and the generator.
template <class Work>
void for_each_touching(std::size_t category, std::uint64_t rounds, const Work& work) {
    for (SeededRandom random : seeds(rounds)) {
        const TouchingBodies bodies = make_touching(category, random);
        const PlaneTrees trees(bodies);
        const WideView a = trees.a.view().wide;
        const WideView b = trees.b.view().wide;
        if (!a.nodes.empty() && !b.nodes.empty()) {
            work(bodies, a, b, random);
        }
    }
}

Counts part_all(std::size_t category, std::uint64_t rounds, double error_scale) {
    Counts counts;
    for_each_touching(category,
                      rounds,
                      [&](const TouchingBodies& bodies,
                          const WideView& a,
                          const WideView& b,
                          const SeededRandom&) {
                          if (const auto normal = parted(a, b, bodies.poses, error_scale)) {
                              ++counts.parted;
                              counts.wrong +=
                                  exact_gap(bodies.a, bodies.b, bodies.poses, *normal) <= 0 ? 1 : 0;
                          }
                      });
    return counts;
}

/// Moves B outwards, in the world.
PosePair moved_by(const TouchingBodies& bodies, double length) {
    return {bodies.poses.a,
            Pose::from_matrix(bodies.poses.b.rotation(),
                              bodies.poses.b.translation() + length * bodies.outwards)};
}

/// Parts bodies at some distance, and asks whether the plane's proof holds nearer, down to where
/// they nearly touch.
Counts hold_all(std::size_t category, std::uint64_t rounds, double error_scale) {
    Counts counts;
    for_each_touching(
        category,
        rounds,
        [&](const TouchingBodies& bodies,
            const WideView& a,
            const WideView& b,
            SeededRandom& random) {
            const auto plane_at = [&](const PosePair& poses) {
                return plane_pose(relative_pose(poses), a.support, b.support, error_scale);
            };
            std::uniform_real_distribution<double> digits(1, 6);
            const double gap =
                std::pow(10, -digits(random)) * (a.support.radius + b.support.radius);
            const PlanePose apart = plane_at(moved_by(bodies, gap));
            PlaneNormal normal = first_normal(apart);
            const float slack = separate(apart, PlaneBody(a), 0, PlaneBody(b), 0, 8, normal);
            if (!(slack > 0)) {
                return;
            }
            const PlaneProof proof(apart, PlaneBody(b), 0, normal, slack);
            for (const double share : {0.0, 1e-4, 0.1, 0.5, 1.0}) {
                PosePair nearer = moved_by(bodies, share * gap);
                if (random() % 2 == 0) {
                    const double sine = 1e-3 * gap / b.support.radius;
                    const Quaternion turn{1, sine, -sine, 0.5 * sine};
                    const Mat3 turned = Pose::from_quaternion(turn, Vec3::Zero()).rotation();
                    nearer.b =
                        Pose::from_matrix(turned * nearer.b.rotation(), nearer.b.translation());
                }
                if (proof.holds(plane_at(nearer), normal)) {
                    ++counts.parted;
                    counts.wrong += exact_gap(bodies.a, bodies.b, nearer, normal) <= 0 ? 1 : 0;
                }
            }
        });
    return counts;
}

TEST(PlaneBounds, AProofThatHoldsLeavesAGapInExactTerms) {
    std::size_t held = 0;
    for (std::size_t category = 0; category < touching_categories; ++category) {
        SCOPED_TRACE(touching_category(category));
        const Counts counts = hold_all(category, raised(40), 1);
        EXPECT_EQ(counts.wrong, 0u);
        held += counts.parted;
    }
    EXPECT_GT(held, 300u);
}

TEST(PlaneBounds, ProofsWithoutMarginsHoldWhereBodiesTouch) {
    std::size_t wrong = 0;
    for (std::size_t category = 0; category < touching_categories; ++category) {
        wrong += hold_all(category, 40, 0).wrong;
    }
    EXPECT_GT(wrong, 5u);
}

TEST(PlaneBounds, NoProofOutlivesItsTree) {
    ObbTree small = make_tree(make_sphere(3));
    ObbTree large = make_tree(scaled(make_sphere(3), 2));
    small.prepare_planes();
    large.prepare_planes();
    TreeView a = small.view();
    std::vector<WideNode> nodes(a.wide.nodes.begin(), a.wide.nodes.end());
    ASSERT_EQ(nodes.size(), large.view().wide.nodes.size());
    a.wide.nodes = nodes;
    const PosePair poses{Pose{}, Pose::from_matrix(Mat3::Identity(), Vec3(2.5, 0, 0))};
    WideSearch search(poses);
    for (int i = 0; i < 3; ++i) {
        search.restart(poses);
        EXPECT_FALSE(search.any(a, small.view()));
    }
    // Another tree at the same address.
    a = large.view();
    std::ranges::copy(a.wide.nodes, nodes.begin());
    a.wide.nodes = nodes;
    search.restart(poses);
    EXPECT_TRUE(search.any(a, small.view()));
}

TEST(PlaneBounds, EveryPlaneLeavesAGapInExactTerms) {
    on_every_target([](SimdTarget) {
        for (std::size_t category = 0; category < touching_categories; ++category) {
            SCOPED_TRACE(touching_category(category));
            EXPECT_EQ(part_all(category, raised(12), 1).wrong, 0u);
        }
    });
}

/// Returns all pairs of a node's children, or the node itself if it is a leaf, with another's.
std::vector<WidePair> pairs_below(const WideView& a, const WideView& b) {
    const auto below = [](const WideNode& root) {
        return root.is_leaf ? std::pair(0u, 1u) : std::pair(root.first, root.first + root.count);
    };
    const auto [first_a, end_a] = below(a.nodes[0]);
    const auto [first_b, end_b] = below(b.nodes[0]);
    std::vector<WidePair> pairs;
    for (std::uint32_t i = first_a; i < end_a; ++i) {
        for (std::uint32_t k = first_b; k < end_b; ++k) {
            pairs.push_back({i, k});
        }
    }
    return pairs;
}

TEST(PlaneBounds, SiblingsArePartedTogetherAsEachPairAlone) {
    constexpr std::uint32_t steps = 2;
    std::size_t parted_at_once = 0;
    std::size_t parted_later = 0;
    std::size_t left = 0;
    on_every_target([&](SimdTarget) {
        for (std::size_t category = 0; category < touching_categories; ++category) {
            SCOPED_TRACE(touching_category(category));
            const auto compare = [&](const TouchingBodies& bodies,
                                     const WideView& a,
                                     const WideView& b,
                                     const SeededRandom&) {
                const auto plane_with = [&](double error_scale) {
                    return plane_pose(
                        relative_pose(bodies.poses), a.support, b.support, error_scale);
                };
                const PlanePose pose = plane_with(1);
                const PlaneNormal first = first_normal(pose);
                const PlaneBody body_a(a);
                const PlaneBody body_b(b);
                // `separate` may round a point's reach otherwise, by far less than a margin.
                const auto parts = [&](WidePair pair, double error_scale) {
                    PlaneNormal normal = first;
                    return separate(
                               plane_with(error_scale), body_a, pair.a, body_b, pair.b, 1, normal) >
                           0;
                };
                const std::vector<WidePair> pairs = pairs_below(a, b);
                std::vector<PlaneTrial> trials(pairs.size());
                separate_siblings(pose, body_a, body_b, pairs, steps, first, trials);
                for (std::size_t i = 0; i < pairs.size(); ++i) {
                    const WidePair pair = pairs[i];
                    if (parts(pair, 1.1)) {
                        EXPECT_TRUE(trials[i].is_apart);
                    } else if (!parts(pair, 0.9)) {
                        const bool are_leaves = a.nodes[pair.a].is_leaf && b.nodes[pair.b].is_leaf;
                        PlaneNormal normal = first;
                        const bool expected =
                            !are_leaves &&
                            separate(pose, body_a, pair.a, body_b, pair.b, steps, normal) > 0;
                        EXPECT_EQ(trials[i].is_apart, expected);
                        EXPECT_EQ(trials[i].normal, normal);
                        ++(expected ? parted_later : left);
                        continue;
                    }
                    parted_at_once += trials[i].is_apart && trials[i].normal == first ? 1 : 0;
                }
            };
            for_each_touching(category, raised(8), compare);
        }
    });
    EXPECT_GT(parted_at_once, 1000u);
    EXPECT_GT(parted_later, 100u);
    EXPECT_GT(left, 1000u);
}

TEST(PlaneBounds, SmallerMarginsPartWhatTouches) {
    std::size_t wrong = 0;
    std::size_t wrong_by_a_hundredth = 0;
    for (std::size_t category = 0; category < touching_categories; ++category) {
        wrong += part_all(category, 25, 0).wrong;
        wrong_by_a_hundredth += part_all(category, 25, 0.01).wrong;
    }
    EXPECT_GT(wrong, 20u);
    EXPECT_GT(wrong_by_a_hundredth, 5u);
}

TEST(PlaneBounds, ASmallerEpsPartsWhatTouches) {
    std::size_t wrong = 0;
    std::size_t parted_with_eps = 0;
    const Mesh mesh = make_sphere(3);
    ObbTree tree = make_tree(mesh);
    tree.prepare_planes();
    WideView without = tree.view().wide;
    std::vector<SupportSet> sets(without.support.sets.begin(), without.support.sets.end());
    ASSERT_GT(sets[0].eps, 0);
    for (SupportSet& set : sets) {
        set.eps = 0;
    }
    without.support.sets = sets;
    for (SeededRandom random : seeds(100)) {
        // The spheres overlap, but by less than eps, so the hulls of their support points
        // can be apart.
        const Pose turned = make_pose(random, 1);
        const Vec3 direction = turned.translation().normalized();
        const PosePair poses{Pose{}, Pose::from_quaternion(turned.quaternion(), 1.99 * direction)};
        parted_with_eps += parted(tree.view().wide, tree.view().wide, poses, 1) ? 1 : 0;
        if (const auto normal = parted(without, without, poses, 1)) {
            wrong += exact_gap(mesh, mesh, poses, *normal) <= 0 ? 1 : 0;
        }
    }
    EXPECT_EQ(parted_with_eps, 0u);
    EXPECT_GT(wrong, 50u);
}

TEST(PlaneBounds, BodiesThatAreApartByFarMoreThanTheMarginAreParted) {
    for (std::size_t category = 0; category < 4 * 4; ++category) {
        SCOPED_TRACE(touching_category(category));
        for (SeededRandom random : seeds(20)) {
            TouchingBodies bodies = make_touching(category, random);
            const PlaneTrees trees(bodies);
            const WideView a = trees.a.view().wide;
            const WideView b = trees.b.view().wide;
            const double gap = 0.2 * (a.support.radius + b.support.radius);
            bodies.poses.b = Pose::from_matrix(
                bodies.poses.b.rotation(), bodies.poses.b.translation() + gap * bodies.outwards);
            EXPECT_TRUE(parted(a, b, bodies.poses, 1)) << "seed " << random.seed;
        }
    }
}

TEST(PlaneBounds, NothingIsPartedUnderPosesThatAreFarFromRigid) {
    ObbTree tree = make_tree(make_sphere(2));
    tree.prepare_planes();
    const WideView view = tree.view().wide;
    const Mat3 large = 1.1 * Mat3::Identity();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const Pose& pose : {Pose::from_matrix(large, Vec3(5, 0, 0)),
                             Pose::from_matrix(Mat3::Identity(), Vec3(infinite, 0, 0)),
                             Pose::from_matrix(Mat3::Identity(), Vec3(1e300, 0, 0))}) {
        EXPECT_FALSE(parted(view, view, {Pose{}, pose}, 1));
        EXPECT_FALSE(parted(view, view, {pose, Pose{}}, 1));
    }
}

TEST(PlaneBounds, SearchesWithPlanesFindWhatSearchesWithoutFind) {
    std::uint64_t contacts = 0;
    std::uint64_t free = 0;
    on_every_target([&](SimdTarget) {
        for (std::size_t category = 0; category < touching_categories; ++category) {
            SCOPED_TRACE(touching_category(category));
            for (SeededRandom random : seeds(8)) {
                const TouchingBodies bodies = make_touching(category, random);
                const PlaneTrees with(bodies);
                const ObbTree a = make_tree(bodies.a);
                const ObbTree b = make_tree(bodies.b);
                WideSearch planes(bodies.poses);
                WideSearch boxes(bodies.poses);
                if (a.view().wide.nodes.empty() || b.view().wide.nodes.empty()) {
                    continue;
                }
                boxes.collect(a.view(), b.view());
                planes.collect(with.a.view(), with.b.view());
                boxes.contacts().sort();
                planes.contacts().sort();
                ASSERT_EQ(planes.contacts().pairs(), boxes.contacts().pairs());
                const bool touches = boxes.contacts().count() > 0;
                // The first call dives, the second one begins with planes unless they touch.
                EXPECT_EQ(planes.any(with.a.view(), with.b.view()), touches);
                EXPECT_EQ(planes.any(with.a.view(), with.b.view()), touches);
                contacts += touches ? 1 : 0;
                free += touches ? 0 : 1;
            }
        }
    });
    EXPECT_GT(contacts, 40u);
    EXPECT_GT(free, 40u);
}

} // namespace

} // namespace cd::tests
