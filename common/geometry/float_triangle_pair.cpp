#include "common/geometry/float_triangle_pair.hpp"

#include "common/core/check.hpp"
#include "common/geometry/simd_target.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr double u = 0x1p-53;       // Unit roundoff of doubles,
constexpr double u_float = 0x1p-24; // and of floats.

static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
static_assert(sizeof(Candidate) == 2 * sizeof(std::uint32_t));
static_assert(offsetof(Candidate, a) == 0);
static_assert(sizeof(FloatVerdict) == sizeof(std::uint8_t));

FloatPairBody body_of(const TriangleSpan& span) {
    return {span.vertices.empty() ? nullptr : span.vertices.front().data(),
            span.triangles.empty() ? nullptr : span.triangles.front().data()};
}

/// The constants of float_pair_kernel.cpp, each raised a little for the roundings here.
FloatPairPose make_pose(const PosePair& poses, double bound_scale) {
    const RelativePose relative = relative_pose(poses);
    FloatPairPose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            pose.rotation[static_cast<std::size_t>(3 * row + column)] =
                relative.rotation(row, column);
        }
        pose.translation[static_cast<std::size_t>(row)] = relative.translation[row];
    }
    const double entry = relative.rotation.cwiseAbs().maxCoeff();
    const double row_sum = relative.rotation.cwiseAbs().rowwise().sum().maxCoeff();
    const double reach = relative.translation.cwiseAbs().maxCoeff();
    pose.point_error_reach = 3.03 * (relative.rotation_error + 4.01 * u * entry);
    pose.point_error = 1.01 * (relative.translation_error + 2.01 * u * reach) + 0x1p-140;
    // How much longer than an edge of B the rotated one can be, and how much shorter.
    const RelativePose back = relative_pose({poses.b, poses.a});
    const double edge_error = 5.01 * u * row_sum + 3.01 * relative.rotation_error;
    const double edge_stretch =
        1.01 * (back.rotation.cwiseAbs().rowwise().sum().maxCoeff() + 3 * back.rotation_error);

    pose.size_weight = static_cast<float>(bound_scale * (11.45 + 4.02) * u_float);
    pose.error_weight = static_cast<float>(bound_scale * 4.01);
    pose.underflow = 0x1p-100F;
    // No comparison here holds of NaN. With entries that large no bound would be of any use.
    pose.is_usable = row_sum < 0x1p20 && edge_error * edge_stretch < u_float / 1024 &&
                     pose.point_error_reach < 0x1p-10 && pose.point_error < 0x1p20;
    return pose;
}

} // namespace

FloatTrianglePair::FloatTrianglePair(const PosePair& poses, double bound_scale)
    : pose_(make_pose(poses, bound_scale)) {
    // Before the kernel's first call, so that a setting of the target is heeded.
    static_cast<void>(simd_target());
}

void FloatTrianglePair::classify(const TriangleSpan& a,
                                 const TriangleSpan& b,
                                 std::span<const Candidate> candidates,
                                 std::span<FloatVerdict> verdicts) const {
    CD_CHECK(candidates.size() == verdicts.size());
    if (!pose_.is_usable || candidates.empty()) {
        std::fill(verdicts.begin(), verdicts.end(), FloatVerdict::Unknown);
        return;
    }
    classify_in_floats(pose_,
                       body_of(a),
                       body_of(b),
                       &candidates.front().a,
                       candidates.size(),
                       reinterpret_cast<std::uint8_t*>(verdicts.data()));
}

void FloatTrianglePair::classify(const TriangleBlocks& a,
                                 const TriangleBlocks& b,
                                 std::span<const Candidate> candidates,
                                 std::span<FloatVerdict> verdicts) const {
    CD_CHECK(candidates.size() == verdicts.size());
    constexpr std::size_t at_once = 64;
    std::array<Vec3, 3 * at_once> vertices_a;
    std::array<Vec3, 3 * at_once> vertices_b;
    std::array<Triangle, at_once> triangles;
    std::array<Candidate, at_once> own;
    for (std::uint32_t i = 0; i < at_once; ++i) {
        triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
        own[i] = {i, i};
    }
    for (std::size_t first = 0; first < candidates.size(); first += at_once) {
        const auto some = candidates.subspan(first, std::min(at_once, candidates.size() - first));
        for (std::size_t i = 0; i < some.size(); ++i) {
            std::ranges::copy(a.corners_at(some[i].a), &vertices_a[3 * i]);
            std::ranges::copy(b.corners_at(some[i].b), &vertices_b[3 * i]);
        }
        classify(TriangleSpan{vertices_a, triangles},
                 TriangleSpan{vertices_b, triangles},
                 std::span(own).first(some.size()),
                 verdicts.subspan(first, some.size()));
    }
}

} // namespace cd
