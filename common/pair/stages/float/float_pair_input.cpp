#include "common/pair/stages/float/float_pair_input.hpp"

#include <cmath>
#include <cstddef>

namespace cd {

namespace {

constexpr double u = 0x1p-53;       // Unit roundoff of doubles.
constexpr double u_float = 0x1p-24; // Unit roundoff of floats.

static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
static_assert(sizeof(Candidate) == 2 * sizeof(std::uint32_t));
static_assert(offsetof(Candidate, a) == 0);
static_assert(sizeof(BlockCorners) == 4 * sizeof(std::uint8_t));
static_assert(block_size == 16);

/// Bounds the spectral norm of M, whose entries err by `entry_error`. The norm's square is at most
/// the largest row sum of |M'M|.
double norm_bound(const Mat3& matrix, double entry_error) {
    const Mat3 squared = matrix.transpose() * matrix;
    const double largest = squared.cwiseAbs().rowwise().sum().maxCoeff();
    return 1.0001 * std::sqrt(largest) + 3 * entry_error;
}

void set_rotation(const RelativePose& relative, FloatPairPose& pose) {
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const double entry = relative.rotation(static_cast<int>(row), static_cast<int>(column));
            pose.rotation[3 * row + column] = static_cast<float>(entry);
            pose.columns[column][row] = pose.columns[column][row + 4] = entry;
        }
        pose.columns[3][row] = pose.columns[3][row + 4] =
            relative.translation[static_cast<int>(row)];
    }
}

} // namespace

FloatPairBody float_pair_body(const TriangleSpan& span) {
    FloatPairBody body;
    body.kind = FloatPairBody::Kind::Mesh;
    body.doubles = span.vertices.empty() ? nullptr : span.vertices.front().data();
    body.triangles = span.triangles.empty() ? nullptr : span.triangles.front().data();
    return body;
}

FloatPairBody float_pair_body(const TriangleBlocks& blocks) {
    FloatPairBody body;
    body.kind = blocks.doubles.empty() ? FloatPairBody::Kind::FloatBlocks
                                       : FloatPairBody::Kind::DoubleBlocks;
    body.floats = blocks.floats.data();
    body.doubles = blocks.doubles.data();
    body.vertex_begin = blocks.vertex_begin.data();
    body.corners = blocks.corners.empty() ? nullptr : blocks.corners.front().data();
    body.reach = blocks.reach;
    return body;
}

FloatPairPose float_pair_pose(const PosePair& poses, double bound_scale) {
    const RelativePose relative = relative_pose(poses);
    FloatPairPose pose;
    set_rotation(relative, pose);
    const double entry = relative.rotation.cwiseAbs().maxCoeff();
    const double translation = relative.translation.cwiseAbs().maxCoeff();
    pose.point_error_reach = 5.26 * (relative.rotation_error + 4.01 * u * entry);
    pose.point_error = 1.76 * (relative.translation_error + 2.01 * u * translation) + 0x1p-140;

    const double turn = norm_bound(relative.rotation.cwiseAbs(), relative.rotation_error);
    // Bounds the ratio of an edge of B to its rotated image.
    const RelativePose back = relative_pose({poses.b, poses.a});
    const double stretch = norm_bound(back.rotation, back.rotation_error);
    const double of_rounding = 1.02 * u_float;
    const double of_arithmetic = 2.75 * u_float;
    pose.weight_a = static_cast<float>(bound_scale * (of_rounding + of_arithmetic));
    pose.weight_b =
        static_cast<float>(bound_scale * (5.02 * turn * stretch * of_rounding + of_arithmetic));
    pose.weight_d = pose.weight_a;
    pose.weight_error = static_cast<float>(bound_scale * 1.02);
    // These comparisons fail for NaN. With larger entries no bound would be useful.
    pose.is_usable = turn < 0x1p20 && stretch < 0x1p20 && turn * stretch < 0x1p10 &&
                     3 * relative.rotation_error < turn * u_float / 1024 &&
                     pose.point_error_reach < 0x1p-10 && pose.point_error < 0x1p20;
    return pose;
}

} // namespace cd
