#include "tests/support/brink_boxes.hpp"

#include "common/tree/node_check.hpp"
#include "tests/support/shapes.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

/// Columns: directions in world space from the centre of a box to its faces.
Mat3 edges_in_world(const ObbNode& node, const Pose& pose) {
    Mat3 edges;
    for (int k = 0; k < 3; ++k) {
        const auto row = 3 * static_cast<std::size_t>(k);
        const Vec3 axis(node.axes[row], node.axes[row + 1], node.axes[row + 2]);
        edges.col(k) = static_cast<double>(node.half[static_cast<std::size_t>(k)]) * axis;
    }
    return pose.rotation() * edges;
}

Vec3 center_of_node(const ObbNode& node) {
    return {node.center[0], node.center[1], node.center[2]};
}

/// Returns the corner of a parallelepiped farthest along `direction`, relative to its centre.
Vec3 support(const Mat3& edges, const Vec3& direction) {
    Vec3 corner = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        corner += (edges.col(k).dot(direction) < 0 ? -1.0 : 1.0) * edges.col(k);
    }
    return corner;
}

} // namespace

std::array<float, 9> crooked_axes(std::mt19937_64& random) {
    const Mat3 turn = random() % 4 == 0 ? Mat3(Mat3::Identity()) : make_pose(random, 1).rotation();
    ObbNode node;
    node.half = {1, 1, 1};
    for (std::size_t i = 0; i < 9; ++i) {
        node.axes[i] = static_cast<float>(turn(static_cast<int>(i / 3), static_cast<int>(i % 3)));
    }
    while (!is_valid_box(node)) {
        node.axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    }
    for (int step = 0; step < 60; ++step) {
        ObbNode next = node;
        float& entry = next.axes[random() % 9];
        const float small = random() % 2 == 0 ? 0x1p-26F : -0x1p-26F;
        const float nudged = entry + small;
        entry = nudged != entry ? nudged : std::nextafter(entry, entry + small * 0x1p10F);
        if (is_valid_box(next)) {
            node = next;
        }
    }
    return node.axes;
}

ObbNode crooked_node(std::mt19937_64& random, double size, double offset) {
    ObbNode node;
    node.axes = crooked_axes(random);
    for (std::size_t k = 0; k < 3; ++k) {
        node.center[k] = uniform(random, -offset, offset);
        const double flat = random() % 4 == 0 ? 1e-7 : 1;
        node.half[k] = static_cast<float>(flat * size * uniform(random, 0.1, 1));
    }
    return node;
}

Pose with_translation(const Pose& pose, const Vec3& translation) {
    return pose.kind() == Pose::Kind::Matrix
               ? Pose::from_matrix(pose.matrix(), translation)
               : Pose::from_quaternion(pose.quaternion(), translation);
}

Pose any_pose(std::mt19937_64& random, double offset) {
    const Pose turned = make_pose(random, offset);
    const Quaternion& q = turned.quaternion();
    Mat3 matrix = turned.rotation();
    switch (random() % 5) {
    case 0:
        return with_translation(Pose{}, turned.translation());
    case 1:
        matrix << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        break;
    case 2: {
        const double norm = uniform(random, 0.999, 1.001);
        return Pose::from_quaternion({norm * q.w, norm * q.x, norm * q.y, norm * q.z},
                                     turned.translation());
    }
    case 3: {
        // R'R = I + 2 S + S S for a symmetric S.
        const double skew = std::ldexp(1.0, -13 - static_cast<int>(random() % 40));
        const Vec3 s = random_point(random, 0.4 * skew);
        const Vec3 d = random_point(random, 0.4 * skew);
        Mat3 stretch;
        stretch << 1 + d.x(), s.x(), s.y(), s.x(), 1 + d.y(), s.z(), s.y(), s.z(), 1 + d.z();
        matrix = matrix * stretch;
        break;
    }
    default:
        break;
    }
    return Pose::from_matrix(matrix, turned.translation());
}

PosePair
touching_poses(std::mt19937_64& random, const ObbNode& a, const ObbNode& b, double offset) {
    PosePair poses{any_pose(random, offset), any_pose(random, offset)};
    if (random() % 4 == 0) {
        poses.b = poses.a; // Parallel edges.
    }
    const Mat3 edges_a = edges_in_world(a, poses.a);
    const Mat3 edges_b = edges_in_world(b, poses.b);
    // The two touch, and this direction separates them: a face normal of A or B, or a cross product
    // of edges.
    Vec3 direction;
    const int i = static_cast<int>(random() % 3);
    const int k = static_cast<int>(random() % 3);
    switch (random() % 3) {
    case 0:
        direction = edges_a.col(i).cross(edges_a.col((i + 1) % 3));
        break;
    case 1:
        direction = edges_b.col(i).cross(edges_b.col((i + 1) % 3));
        break;
    default:
        direction = edges_a.col(i).cross(edges_b.col(k));
        break;
    }
    if (!(direction.norm() > 0)) {
        direction = edges_a.col(0);
    }
    direction.normalize();
    if (random() % 2 == 0) {
        direction = -direction;
    }
    // Move B in the contact plane as far as its supporting edge or face reaches.
    Vec3 between = support(edges_a, direction) + support(edges_b, direction);
    for (const Mat3& edges : {edges_a, edges_b}) {
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 edge = edges.col(axis);
            if (std::abs(edge.dot(direction)) <= 1e-12 * edge.norm()) {
                between += uniform(random, -2, 2) * edge;
            }
        }
    }
    const Vec3 center_a = poses.a.apply(center_of_node(a));
    const Vec3 center_b = poses.b.apply(center_of_node(b));
    Vec3 translation = poses.b.translation() + (center_a + between - center_b);
    // Shift by a few ulps either way.
    for (int axis = 0; axis < 3; ++axis) {
        const double step =
            std::nextafter(std::abs(translation[axis]), std::numeric_limits<double>::infinity()) -
            std::abs(translation[axis]);
        translation[axis] += static_cast<double>(static_cast<int>(random() % 7) - 3) * step;
    }
    poses.b = with_translation(poses.b, translation);
    return poses;
}

} // namespace cd::tests
