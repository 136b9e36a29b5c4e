// Proves that the principal directions are orthonormal, diagonalise the matrix and come in
// ascending order, on random matrices and on equal, zero or nearly equal eigenvalues; and that bits
// do not depend on the SIMD target or the number of matrices.

#include "common/tree/build/build_eigen.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

Directions directions_of(const Mat3& m) {
    const SymmetricMatrix matrix{m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
    Directions directions;
    principal_directions({&matrix, 1}, {&directions, 1});
    return directions;
}

/// Makes a matrix with these eigenvalues in a random frame.
Mat3 turned(const Vec3& values, std::mt19937_64& random) {
    const Mat3 r = make_pose(random, 1.0).rotation();
    const Mat3 m = r * values.asDiagonal() * r.transpose();
    return 0.5 * (m + m.transpose());
}

void expect_principal(const Mat3& m) {
    const Directions directions = directions_of(m);
    Mat3 rows;
    rows << directions[0].transpose(), directions[1].transpose(), directions[2].transpose();
    EXPECT_LT((rows * rows.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-14);
    const Mat3 diagonal = rows * m * rows.transpose();
    const double size = m.cwiseAbs().maxCoeff();
    EXPECT_LE(std::abs(diagonal(0, 1)), 1e-9 * size);
    EXPECT_LE(std::abs(diagonal(0, 2)), 1e-9 * size);
    EXPECT_LE(std::abs(diagonal(1, 2)), 1e-9 * size);
    EXPECT_LE(diagonal(0, 0), diagonal(1, 1) + 1e-9 * size);
    EXPECT_LE(diagonal(1, 1), diagonal(2, 2) + 1e-9 * size);
}

TEST(BuildEigen, FindsDirectionsOfMatricesOfAnySpread) {
    std::mt19937_64 random(1);
    const std::vector<double> spread = {0, 1e-15, 1e-9, 1e-4, 0.3, 0.5, 1 - 1e-9, 1 - 1e-15, 1};
    for (const double low : spread) {
        for (const double middle : spread) {
            for (int round = 0; round < 20; ++round) {
                SCOPED_TRACE(testing::Message() << low << ' ' << middle << ' ' << round);
                expect_principal(turned({low, middle, 1}, random));
                expect_principal(turned({-low, middle, 1}, random));
            }
        }
    }
}

TEST(BuildEigen, ADiagonalMatrixGivesTheBodysAxes) {
    for (const Vec3& values : {Vec3(1, 0.5, 0.25),
                               Vec3(0.25, 1, 0.5),
                               Vec3(0, 0, 1),
                               Vec3(1, 1, 0),
                               Vec3(0, 0, 0),
                               Vec3(1, 1, 1)}) {
        SCOPED_TRACE(testing::Message() << values.transpose());
        const Mat3 m = values.asDiagonal();
        expect_principal(m);
        for (const Vec3& direction : directions_of(m)) {
            EXPECT_EQ(direction.cwiseAbs().maxCoeff(), 1);
            EXPECT_EQ(direction.cwiseAbs().sum(), 1);
        }
    }
}

TEST(BuildEigen, NonFiniteEntriesGiveTheBodysAxes) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double odd : {infinity, -infinity, std::nan("")}) {
        for (int i = 0; i < 3; ++i) {
            for (int k = i; k < 3; ++k) {
                Mat3 m = Mat3::Ones();
                m(i, k) = m(k, i) = odd;
                const Directions directions = directions_of(m);
                EXPECT_EQ(directions[0], Vec3::UnitX());
                EXPECT_EQ(directions[1], Vec3::UnitY());
                EXPECT_EQ(directions[2], Vec3::UnitZ());
            }
        }
    }
}

TEST(BuildEigen, EveryTargetAndNumberOfMatricesGetsTheSameBits) {
    std::mt19937_64 random(2);
    std::vector<SymmetricMatrix> matrices(37);
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        for (double& entry : matrices[i]) {
            // Some flat, some with equal values, some tiny and some huge.
            const double scale = i % 5 == 0 ? 1e-300 : i % 7 == 0 ? 1e300 : 1;
            entry = scale * (i % 6 == 0 ? 1 : static_cast<double>(random() >> 12) * 0x1p-52 - 0.5);
        }
    }
    std::vector<Directions> expected(matrices.size());
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        principal_directions({&matrices[i], 1}, {&expected[i], 1});
    }
    on_every_target([&](SimdTarget) {
        std::vector<Directions> found(matrices.size());
        principal_directions(matrices, found);
        for (std::size_t i = 0; i < matrices.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(found[i][k], expected[i][k]) << i;
            }
        }
    });
}

} // namespace

} // namespace cd::tests
