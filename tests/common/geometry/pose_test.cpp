// Proves that the bounds of rounded rotations and relative poses hold against exact rationals, for
// both kinds of poses, matrices that are not quite rigid and quaternions of any norm; and that the
// bounds are tight enough to be useful.
#include "common/geometry/pose.hpp"

#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace cd::tests {

namespace {

constexpr std::array<std::size_t, 3> three{0, 1, 2};

Rational at(const Mat3& m, std::size_t row, std::size_t column) {
    return Rational(m(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
}

/// Expects the three bounds of a relative pose to hold.
void expect_bounds_hold(const PosePair& poses) {
    const RelativePose relative = relative_pose(poses);
    const ExactMat inverse_a = inverse(exact_rotation(poses.a));
    const ExactMat rotation = inverse_a * exact_rotation(poses.b);
    const ExactMat gram = transposed(rotation) * rotation;
    const ExactVec translation = inverse_a * (exact(poses.b.translation()) +
                                              scaled(Rational(-1), exact(poses.a.translation())));
    const ExactVec rounded = exact(relative.translation);
    for (const std::size_t i : three) {
        for (const std::size_t j : three) {
            EXPECT_LE(abs(Rational(rotation[i][j] - at(relative.rotation, i, j))),
                      Rational(relative.rotation_error));
            EXPECT_LE(abs(Rational(gram[i][j] - (i == j ? 1 : 0))), Rational(relative.skew));
        }
        EXPECT_LE(abs(Rational(translation[i] - rounded[i])), Rational(relative.translation_error));
    }
}

Pose bent(std::mt19937_64& random, const Pose& pose, double amount) {
    Mat3 matrix = pose.rotation();
    for (int i = 0; i < 9; ++i) {
        matrix(i / 3, i % 3) += uniform(random, -amount, amount);
    }
    return Pose::from_matrix(matrix, pose.translation());
}

Pose with_norm(const Pose& pose, double factor) {
    const Quaternion& q = pose.quaternion();
    return Pose::from_quaternion({factor * q.w, factor * q.x, factor * q.y, factor * q.z},
                                 pose.translation());
}

} // namespace

TEST(Pose, AProductOfQuaternionsRotatesByTheRightOneFirst) {
    const Quaternion about_x{1, 1, 0, 0}; // By 90 degrees.
    const Quaternion about_z{1, 0, 0, 1};
    const Vec3 point = Pose::from_quaternion(about_z * about_x, Vec3::Zero()).apply({0, 1, 0});

    // About x the point goes to (0, 0, 1), which a turn about z keeps.
    EXPECT_LE((point - Vec3(0, 0, 1)).norm(), 1e-15);
}

TEST(Pose, RotationIsWithinItsErrorForQuaternionsOfAnyNorm) {
    for (const double factor : {1.0, 1e-150, 1e150, 0x1p-1060, 0x1p1000}) {
        std::mt19937_64 random(3);
        for (int round = 0; round < 20; ++round) {
            const Pose pose = with_norm(make_pose(random, 1), factor);
            const Mat3 rounded = pose.rotation();
            const ExactMat exact = exact_rotation(pose);
            for (const std::size_t i : three) {
                for (const std::size_t j : three) {
                    EXPECT_LE(abs(Rational(exact[i][j] - at(rounded, i, j))),
                              Rational(pose.rotation_error()))
                        << factor;
                }
            }
        }
    }
}

TEST(Pose, AMatrixStaysWhatItWasGivenAs) {
    Mat3 matrix;
    matrix << 1, 1e-17, 0, 0, 1, 0.1, 0, 0, 1;
    const Pose pose = Pose::from_matrix(matrix, {1, 2, 3});

    EXPECT_EQ(pose.matrix(), matrix);
    EXPECT_EQ(pose.rotation(), matrix);
    EXPECT_EQ(pose.rotation_error(), 0);
    EXPECT_FALSE(pose == Pose::from_matrix(Mat3::Identity(), {1, 2, 3}));
}

TEST(Pose, KindsAreDifferentPosesEvenWhereTheyRotateAlike) {
    EXPECT_FALSE(Pose() == Pose::from_quaternion({1, 0, 0, 0}, Vec3::Zero()));
    EXPECT_FALSE(Pose::from_quaternion({2, 0, 0, 0}, Vec3::Zero()) ==
                 Pose::from_quaternion({1, 0, 0, 0}, Vec3::Zero()));
}

TEST(Pose, IsNotFiniteWithOneBadNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(Pose().is_finite());
    EXPECT_FALSE(translation_pose(0, nan, 0).is_finite());
    EXPECT_FALSE(Pose::from_quaternion({1, 0, 0, nan}, Vec3::Zero()).is_finite());
    EXPECT_FALSE(Pose::from_matrix(Mat3::Constant(HUGE_VAL), Vec3::Zero()).is_finite());
}

TEST(RelativePose, BoundsHoldForEveryKindOfPair) {
    using Maker = std::function<Pose(std::mt19937_64&)>;
    const std::vector<Maker> makers{
        [](auto& r) { return make_pose(r, 2); },
        [](auto& r) { return make_matrix_pose(r, 1e7); },
        [](auto& r) { return with_norm(make_pose(r, 0.1), uniform(r, 1e-8, 1e8)); },
        [](auto& r) { return bent(r, make_pose(r, 5), 1e-5); },
        [](auto& r) { return bent(r, make_pose(r, 5), 1e-12); },
        [](auto&) { return Pose(); },
    };
    for (std::size_t a = 0; a < makers.size(); ++a) {
        for (std::size_t b = 0; b < makers.size(); ++b) {
            for (std::uint64_t seed = 0; seed < 8; ++seed) {
                SCOPED_TRACE(testing::Message() << a << " " << b << " seed " << seed);
                std::mt19937_64 random(seed);
                const Pose pose_a = makers[a](random);
                expect_bounds_hold({pose_a, makers[b](random)});
            }
        }
    }
}

TEST(RelativePose, InvertsAMatrixThatIsNotQuiteRigid) {
    std::mt19937_64 random(1);
    const Pose a = bent(random, make_pose(random, 1), 1e-5);
    const RelativePose relative = relative_pose({a, make_pose(random, 1)});

    // The bounds cover rounding only, not the error of using the transpose as inverse.
    EXPECT_LE(relative.rotation_error, 1e-12);
    EXPECT_LE(relative.translation_error, 1e-12);
    EXPECT_LE(relative.skew, 3e-4);
    EXPECT_GE(relative.skew, 1e-6);
}

TEST(RelativePose, OfOnePoseForBothIsTheIdentityWithinItsBound) {
    std::mt19937_64 random(2);
    const Pose pose = make_pose(random, 100);
    const RelativePose relative = relative_pose({pose, pose});

    EXPECT_LE((relative.rotation - Mat3::Identity()).cwiseAbs().maxCoeff(),
              relative.rotation_error);
    EXPECT_EQ(relative.translation, Vec3(0, 0, 0));
    EXPECT_EQ(relative.skew, 0);
}

TEST(RelativePose, PromisesNothingForWhatIsFarFromRigid) {
    const Pose flat = Pose::from_matrix(Mat3::Zero(), Vec3::Zero());
    const Pose huge = Pose::from_matrix(Mat3::Constant(1e200), Vec3::Zero());
    for (const Pose& pose : {flat, huge}) {
        const RelativePose relative = relative_pose({pose, Pose()});
        EXPECT_EQ(relative.rotation_error, HUGE_VAL);
        EXPECT_EQ(relative.translation_error, HUGE_VAL);
        EXPECT_EQ(relative.skew, HUGE_VAL);
    }
    const double largest = std::numeric_limits<double>::max();
    const RelativePose apart =
        relative_pose({translation_pose(-largest, 0, 0), translation_pose(largest, 0, 0)});
    EXPECT_EQ(apart.translation_error, HUGE_VAL);
}

} // namespace cd::tests
