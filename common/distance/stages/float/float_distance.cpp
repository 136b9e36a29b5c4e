#include "common/distance/stages/float/float_distance.hpp"

#include "common/core/check.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/pair/stages/float/float_pair_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double u_float = 0x1p-24; // Unit roundoff of floats.
constexpr float infinity = std::numeric_limits<float>::infinity();

static_assert(sizeof(NearVerdict) == sizeof(std::uint8_t));

/// Computes the constants of near_pair_kernel.cpp.
NearPairErrors errors_of(const FloatPairPose& pose, double error_scale) {
    const double of_rounding = 1.01 * 25 * u_float * error_scale;
    NearPairErrors errors;
    errors.of_a = static_cast<float>(of_rounding + 1.01 * double{pose.weight_a});
    errors.of_b = static_cast<float>(of_rounding + 1.01 * double{pose.weight_b});
    errors.of_d = static_cast<float>(of_rounding + 1.01 * u_float * error_scale);
    errors.of_corner = pose.weight_error;
    return errors;
}

NearPairLimit limit_of(double d) {
    constexpr double most = std::numeric_limits<float>::max();
    const auto nearest = static_cast<float>(std::min(d, most));
    NearPairLimit limit{nearest, nearest};
    if (double{nearest} < d) {
        limit.raised = std::nextafter(nearest, infinity);
    } else if (double{nearest} > d) {
        limit.lowered = std::nextafter(nearest, 0.0F);
    }
    return limit;
}

} // namespace

FloatDistance::FloatDistance(const PosePair& poses, double error_scale)
    : pose_(float_pair_pose(poses, error_scale)), errors_(errors_of(pose_, error_scale)) {
    // With |R'R - I| at most 3 s in the spectral norm, A's pose changes lengths by less than 2 s.
    const double skew = relative_pose({Pose(), poses.a}).skew;
    is_usable_ = pose_.is_usable && skew < 0x1p-31;
    // Runs before the kernel's first call, so that a forced target takes effect.
    static_cast<void>(simd_target());
}

template <class Triangles>
void FloatDistance::decide(const Triangles& a,
                           const Triangles& b,
                           std::span<const Candidate> candidates,
                           double d,
                           std::span<NearVerdict> verdicts) const {
    CD_CHECK(candidates.size() == verdicts.size());
    if (!is_usable_ || candidates.empty()) {
        std::fill(verdicts.begin(), verdicts.end(), NearVerdict::Unknown);
        return;
    }
    const FloatPairBody body_a = float_pair_body(a);
    const FloatPairBody body_b = float_pair_body(b);
    decide_near_in_floats(
        {pose_, errors_, body_a, body_b, &candidates.front().a, candidates.size()},
        limit_of(d),
        reinterpret_cast<std::uint8_t*>(verdicts.data()));
}

template <class Triangles>
void FloatDistance::bound(const Triangles& a,
                          const Triangles& b,
                          std::span<const Candidate> candidates,
                          std::span<float> lower,
                          std::span<float> upper) const {
    CD_CHECK(candidates.size() == lower.size());
    CD_CHECK(candidates.size() == upper.size());
    if (!is_usable_ || candidates.empty()) {
        std::fill(lower.begin(), lower.end(), 0.0F);
        std::fill(upper.begin(), upper.end(), infinity);
        return;
    }
    const FloatPairBody body_a = float_pair_body(a);
    const FloatPairBody body_b = float_pair_body(b);
    bound_distances_in_floats(
        {pose_, errors_, body_a, body_b, &candidates.front().a, candidates.size()},
        lower.data(),
        upper.data());
}

template void FloatDistance::decide(const TriangleSpan&,
                                    const TriangleSpan&,
                                    std::span<const Candidate>,
                                    double,
                                    std::span<NearVerdict>) const;
template void FloatDistance::decide(const TriangleBlocks&,
                                    const TriangleBlocks&,
                                    std::span<const Candidate>,
                                    double,
                                    std::span<NearVerdict>) const;
template void FloatDistance::bound(const TriangleSpan&,
                                   const TriangleSpan&,
                                   std::span<const Candidate>,
                                   std::span<float>,
                                   std::span<float>) const;
template void FloatDistance::bound(const TriangleBlocks&,
                                   const TriangleBlocks&,
                                   std::span<const Candidate>,
                                   std::span<float>,
                                   std::span<float>) const;

} // namespace cd
