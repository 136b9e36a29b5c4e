#include "client/import/gltf/gltf_transforms.hpp"

#include <cmath>

namespace cd {

namespace {

double nearest_float(double number) {
    return static_cast<double>(static_cast<float>(number));
}

/// The rotation of a quaternion of any length. Divides by the squared length, so that a quarter
/// turn given in floats is exact.
Eigen::Matrix3d rotation_of(double x, double y, double z, double w) {
    const double s = 2 / (x * x + y * y + z * z + w * w);
    Eigen::Matrix3d r;
    r << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), //
        s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),  //
        s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y);
    return r;
}

} // namespace

Result<Eigen::Matrix4d> to_matrix(const GltfTransform& transform) {
    const auto& q = transform.rotation;
    const Eigen::Matrix3d rotation = rotation_of(
        nearest_float(q[0]), nearest_float(q[1]), nearest_float(q[2]), nearest_float(q[3]));
    if (!rotation.allFinite()) {
        return Error{ErrorCode::BadInput, "its rotation is no quaternion of a length above zero"};
    }
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        matrix.block<3, 1>(0, axis) = nearest_float(transform.scale[i]) * rotation.col(axis);
        matrix(axis, 3) = nearest_float(transform.translation[i]);
    }
    return matrix;
}

Result<Eigen::Matrix4d> to_parent(const GltfNode& node) {
    if (!node.matrix) {
        return to_matrix(node.transform);
    }
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) { // The last row stays 0 0 0 1.
            matrix(row, column) =
                nearest_float((*node.matrix)[static_cast<std::size_t>(4 * column + row)]);
        }
    }
    return matrix;
}

} // namespace cd
