// How far the bodies of a motion can move against each other in a part of the time.
//
// Write q(tau), c(tau) for a body's path (body_path.hpp), q' = q1 - q0 and c' = c1 - c0 for the
// constant rates, and w = Im(q' conj(q0)). Since Im(q' conj(q(tau))) = w at every tau, the angular
// velocity in the world is omega(tau) = 2 w / n(tau), with n(tau) = |q(tau)|^2. Its direction is
// constant. r is the radius of a body: no vertex is farther from the origin of its coordinates. D =
// c_B - c_A and D' = c'_B - c'_A.
//
// A cell is [j, j + 1] / 2^k with the middle tau_c and the half width h = 2^-(k + 1). Let s = tau -
// tau_c. Then n = n_c + n' s + |q'|^2 s^2 with n' = 2 q(tau_c).q'. Let n_low be its least value in
// the cell: n_c - n'^2 / (4 |q'|^2) if the lowest point is inside, else the lower end. So |omega|
// is at most 2 |w| / n_low, and differs from its value at tau_c by at most
//     eps = 2 |w| h (|n'| + h |q'|^2) / (n_low n_c).
//
// Let x' and y' be points of A and B in the world. Three ways to bound how fast they move against
// each other, each for the whole cell:
// - World: |d(y' - x')/dtau| <= |D'| + max|omega_A| r_A + max|omega_B| r_B.
// - A's frame, where x' rests: the velocity of y' is, up to a rotation,
//       D' - omega_A x D + (omega_B - omega_A) x (y' - c_B).
//   D(tau) = D(tau_c) + s D' and omega_A(tau) = omega_A(tau_c) + (at most eps_A). So its length is
//   at most, with all values at tau_c,
//       |D' - omega_A x D| + eps_A (|D| + h |D'|) + |omega_A| h |D'|
//           + (|omega_B - omega_A| + eps_A + eps_B) r_B.
// - B's frame: the same with A and B exchanged.
// So the distance of the two points at any tau of the cell differs from their distance at tau_c by
// at most M, which is h times the least of the three speeds, or half of M of the cell that contains
// this one and is twice as wide, since a bound of speed for a cell holds for its parts.
//
// Roundings, with u = 2^-53. Keys are on a grid (key_grid.hpp), so c', q', q(tau_c) and c(tau_c)
// have no error, and D and D' err by u relatively. n_c errs by 4 u relatively, n_low by 16 u, since
// n >= 1/4 for norms of keys of at least sqrt(1/2) and turns below 180 degrees. What cancels:
// - w errs by at most 7 u |q'| |q0| in length, so omega by 7 u O, with O = 4 |q'| / n_low, since
//   |q0| < 2. |omega| <= O as well.
// - n' errs by 8 u |q'| |q(tau_c)|; so eps errs, beside relative errors, by at most 60 u O.
// - omega_B - omega_A errs by 8 u (O_A + O_B), and omega_A x D by 12 u O_A |D|.
// |D'| is at most |D' - omega_A x D| + O_A |D|, and O at most 32. So the errors are at most
// relative ones and 2000 u (O_A + O_B) (|D| + r), in A's frame with r = r_B. The bounds below add
// 2^-40 times that product, and the factor 1 + 2^-40 covers relative errors, which are below 1100 u
// in all.
//
// Underflow: components of w are 0 or at least 2^-105, so no product with them underflows but those
// with r and D, which lose at most 2^-1074. Squares of components of D and D' lose as much; so
// their lengths lose at most 2^-535. All factors of lengths are below 2^8: the term 2^-500 covers
// this. Overflow gives infinity or NaN, and never lowers M.
#pragma once

#include "common/motion/body_path.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// The part [index, index + 1] / 2^level of a motion's time.
struct TimeCell {
    unsigned level = 0;
    std::uint32_t index = 0;

    [[nodiscard]] double middle() const;
    [[nodiscard]] double half_width() const;
};

/// The radii of both bodies (`body_radius`), in the job's unit.
struct BodyRadii {
    double a = 0;
    double b = 0;
};

/// Returns an upper bound on the distance of each vertex from the origin of the body's coordinates.
/// It depends on the vertices alone, and is within 2^-50 of the largest distance unless that is
/// below 2^-500. Infinite where squares overflow.
[[nodiscard]] double body_radius(std::span<const Vec3> vertices);

/// Returns the bound M of a cell, in the job's unit, as a function of its arguments that is the
/// same on every host. `bound_of_parent` is M of the cell of the next lower level that contains it;
/// infinity if there is none. The paths are within a grid that has the cell's middle.
[[nodiscard]] double cell_bound(const BodyPath& a,
                                const BodyPath& b,
                                const BodyRadii& radii,
                                const TimeCell& cell,
                                double bound_of_parent);

/// Returns an upper bound on how far a vertex of a body is, at any time of its path, from where it
/// is at tau = 1/2, in the job's unit: |c'| / 2 and what it turns. M of the whole motion of two
/// bodies is at most the sum of their bounds, within 2^-40 of that. Infinite where numbers
/// overflow; never NaN. The path has exact poses at tau = 1/2.
[[nodiscard]] double movement_bound(const BodyPath& path, double radius);

} // namespace cd
