// Separating axes of two boxes: Gottschalk, Lin, Manocha, OBBTree (1996), section 5. Why a "no" is
// a proof:
//
// Write x for a point of A's box, y for one of B's, in their own bodies' coordinates; F and G for
// the frames of the two nodes (rows, floats, exact numbers), c and d for their centres, R and t for
// the true relative pose. With alpha = F (x - c) and beta = G (y - d), |alpha_i| <= ha_i and
// |beta_k| <= hb_k by the contract of ObbNode. If x and y are the same point of the world,
// x = R y + t, then exactly
//     alpha = T + N beta,   N = F R G^-1,   T = F (R d + t - c),
// and for every functional L:  L.T = L.alpha - sum_k (L.n_k) beta_k, n_k the columns of N. So
//     |L.T| <= sum_i |L_i| ha_i + sum_k |L.n_k| hb_k
// holds for every touching pair; L is taken from the computed M ~ N, as it is, without rounding.
//
// Bounds, all in the spectral norm (which bounds every entry), u = 2^-53, e = axes_error_max,
// r = rotation_error, s = skew <= 2^-10:
// (1) |F F' - I| and |G G' - I| <= 3 e, |R'R - I| <= 3 s.
// (2) |M - N| <= eta = 3.01 (r + e) + 32 u: the entries of the rotation err by r (3 r in norm),
//     G' in place of G^-1 gives |G^-1| |G G' - I| <= 3.001 e, and the two products of three round.
// (3) The squares of the singular values of N lie within tau = 6.1 e + 3.01 s of 1.
// Then, for the axes
//     of A:   L = e_i:        L.n_k = N_ik, within eta of M_ik;
//     of B:   L = m_j:        L.n_k = (M'N)_jk, within tau + 1.01 eta of the identity;
//     e_i x m_j (never normalised, so parallel edges cannot reject by accident):
//                             L.m_j = 0; for the third axis l of B beside j and k, L.m_k is a
//                             cofactor of M: the singular values of the cofactors are products of
//                             two of M, which stay within 1.53 tau + 3.05 eta of M's own, so
//                             |L.m_k| is as close to |M_il|; n_k in place of m_k adds 1.01 eta.
// Thus all |L.n_k| stay within 1.53 tau + 4.1 eta <= 22 e + 5 s + 13 r + 160 u of the values in the
// classical test: `frame_error_` times the sum of hb covers it. Rounding the sums on the right
// costs less than 8 u (sum ha + sum hb).
//
// T: v = R d + t - c is computed with an error of at most r |d|_1 + (translation error) +
// 6 u (1.01 |d|_1 + |t|_1 + |c|_1) in each component; F multiplies this by at most 1.74, rounds by
// 3 u |v|_1; L multiplies by at most 1.75 and rounds the same way. Together at most
// 4 (r |d|_1 + translation error) + 48 u (|d|_1 + |t|_1 + |c|_1).
//
// Reach: if the points are not the same but x = R y + t + z with |z| <= reach, then alpha has the
// additional term F z, and L.T differs by L.(F z). All |L| are below 1.006 and |F| below 1 + 2 e,
// so 1.01 times the reach covers it.
//
// Distance: with the same z, each axis of A gives |(F z)_i| >= gap_i, what |T_i| exceeds the right
// side by, and so |F z|^2 >= the sum of the squares of the positive gaps. Each axis of B gives
// |m_j.(F z)| >= gap_j, and the sum of their squares is at most |M|^2 |F z|^2. As |F| is below
// 1 + 2 e and |M| below 1.006, a 1.01th of the root of each sum is at most |z|.
//
// Underflow is far below frame_error_ times the least half size of a node. A comparison with NaN or
// with an infinite bound does not reject. Centres of B beyond 2^1000 get an infinite bound; then T
// can overflow only if it really is beyond 2^1000, and finite half sizes are below 2^128.
#include "common/tree/box_test.hpp"

#include "common/tree/build/build_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double skew_max = 0x1p-10;    ///< Largest skew for which the bounds of this file hold.
constexpr double underflow = 0x1p-1000; ///< Exceeds everything that can be lost to underflow.
constexpr double center_max = 0x1p1000; ///< Beyond this, intermediate sums may overflow.

double size_of(const std::array<double, 3>& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

} // namespace

BoxTest::BoxTest(const RelativePose& b_to_a, double error_scale, double reach)
    : reach_(1.01 * reach), rounding_(error_scale * unit_roundoff) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            rotation_[3 * i + k] = b_to_a.rotation(static_cast<int>(i), static_cast<int>(k));
        }
        translation_[i] = b_to_a.translation[static_cast<int>(i)];
    }
    translation_size_ = size_of(translation_);
    rotation_error_ = error_scale * b_to_a.rotation_error;
    translation_error_ = error_scale * b_to_a.translation_error;
    frame_error_ = error_scale * (22 * axes_error_max + 5 * b_to_a.skew +
                                  13 * b_to_a.rotation_error + 256 * unit_roundoff);
    if (!(b_to_a.skew <= skew_max) || !(b_to_a.rotation_error <= skew_max)) {
        frame_error_ = infinity;
    }
}

PosedBox BoxTest::pose(const ObbNode& b) const {
    PosedBox posed;
    for (std::size_t i = 0; i < 3; ++i) {
        const double* row = &rotation_[3 * i];
        for (std::size_t k = 0; k < 3; ++k) {
            const float* axis = &b.axes[3 * k];
            posed.axes[3 * k + i] = row[0] * static_cast<double>(axis[0]) +
                                    row[1] * static_cast<double>(axis[1]) +
                                    row[2] * static_cast<double>(axis[2]);
        }
        posed.center[i] =
            row[0] * b.center[0] + row[1] * b.center[1] + row[2] * b.center[2] + translation_[i];
        posed.half[i] = static_cast<double>(b.half[i]);
    }
    const double center_size = size_of(b.center);
    posed.error = frame_error_ * (posed.half[0] + posed.half[1] + posed.half[2]) +
                  4 * (rotation_error_ * center_size + translation_error_) +
                  48 * rounding_ * (center_size + translation_size_) + reach_;
    if (!(center_size + translation_size_ < center_max)) {
        posed.error = infinity;
    }
    return posed;
}

Aabb BoxTest::bounds(const Corners& b) const {
    Aabb box;
    double size = 0;
    for (const Vec3& corner : b) {
        const std::array<double, 3> c = {corner.x(), corner.y(), corner.z()};
        box.add(
            {rotation_[0] * c[0] + rotation_[1] * c[1] + rotation_[2] * c[2] + translation_[0],
             rotation_[3] * c[0] + rotation_[4] * c[1] + rotation_[5] * c[2] + translation_[1],
             rotation_[6] * c[0] + rotation_[7] * c[1] + rotation_[8] * c[2] + translation_[2]});
        size = std::max(size, size_of(c));
    }
    // The error is that of T at the head of this file, without F; growing the box rounds once more.
    double error = rotation_error_ * size + translation_error_ +
                   12 * rounding_ * (size + translation_size_) + reach_ + underflow;
    if (!(size + translation_size_ < center_max) || !(frame_error_ < infinity)) {
        error = infinity;
    }
    return {box.min - Vec3::Constant(error), box.max + Vec3::Constant(error)};
}

/// Returns what errors and the reach add to each side of a comparison.
double BoxTest::margin_of(const ObbNode& a, const PosedBox& b) const {
    const double halves = static_cast<double>(a.half[0]) + static_cast<double>(a.half[1]) +
                          static_cast<double>(a.half[2]);
    return b.error + 48 * rounding_ * size_of(a.center) + 8 * rounding_ * halves;
}

bool BoxTest::may_overlap(const ObbNode& a, const PosedBox& b) const {
    std::array<double, 3> ha;
    std::array<double, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
        ha[i] = static_cast<double>(a.half[i]);
        v[i] = b.center[i] - a.center[i];
    }
    const std::array<double, 3>& hb = b.half;
    const double margin = margin_of(a, b);

    std::array<double, 3> t;
    std::array<std::array<double, 3>, 3> m;
    std::array<std::array<double, 3>, 3> abs_m;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<double, 3> row = {static_cast<double>(a.axes[3 * i]),
                                           static_cast<double>(a.axes[3 * i + 1]),
                                           static_cast<double>(a.axes[3 * i + 2])};
        t[i] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
        double reach = ha[i] + margin;
        for (std::size_t k = 0; k < 3; ++k) {
            const double* axis = &b.axes[3 * k];
            m[i][k] = row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2];
            abs_m[i][k] = std::abs(m[i][k]);
            reach += abs_m[i][k] * hb[k];
        }
        if (std::abs(t[i]) > reach) {
            return false;
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double distance = std::abs(t[0] * m[0][k] + t[1] * m[1][k] + t[2] * m[2][k]);
        const double reach =
            ha[0] * abs_m[0][k] + ha[1] * abs_m[1][k] + ha[2] * abs_m[2][k] + hb[k] + margin;
        if (distance > reach) {
            return false;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t i1 = i == 2 ? 0 : i + 1;
        const std::size_t i2 = i == 0 ? 2 : i - 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t k1 = k == 2 ? 0 : k + 1;
            const std::size_t k2 = k == 0 ? 2 : k - 1;
            const double distance = std::abs(t[i2] * m[i1][k] - t[i1] * m[i2][k]);
            const double reach = ha[i1] * abs_m[i2][k] + ha[i2] * abs_m[i1][k] +
                                 hb[k1] * abs_m[i][k2] + hb[k2] * abs_m[i][k1] + margin;
            if (distance > reach) {
                return false;
            }
        }
    }
    return true;
}

double BoxTest::least_distance(const ObbNode& a, const PosedBox& b) const {
    std::array<double, 3> t{};
    std::array<std::array<double, 3>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const auto axis = static_cast<double>(a.axes[3 * i + j]);
            t[i] += axis * (b.center[j] - a.center[j]);
            for (std::size_t k = 0; k < 3; ++k) {
                m[i][k] += axis * b.axes[3 * k + j];
            }
        }
    }
    const double margin = margin_of(a, b);
    double along_a = 0; // Sums of the squares of gaps.
    double along_b = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double distance_b = 0;
        double reach_a = static_cast<double>(a.half[i]) + margin;
        double reach_b = b.half[i] + margin;
        for (std::size_t k = 0; k < 3; ++k) {
            distance_b += t[k] * m[k][i];
            reach_a += std::abs(m[i][k]) * b.half[k];
            reach_b += std::abs(m[k][i]) * static_cast<double>(a.half[k]);
        }
        // A comparison with NaN leaves 0.
        const double gap_a = std::max(0.0, std::abs(t[i]) - reach_a);
        const double gap_b = std::max(0.0, std::abs(distance_b) - reach_b);
        along_a += gap_a * gap_a;
        along_b += gap_b * gap_b;
    }
    return std::sqrt(std::max(along_a, along_b)) / 1.01;
}

} // namespace cd
