#include "web/server/page_values.hpp"

namespace cd {

std::array<double, 12> pose_rows(const Pose& pose) {
    std::array<double, 12> rows{};
    const Mat3 rotation = pose.rotation();
    for (int row = 0; row < 3; ++row) {
        const auto begin = static_cast<std::size_t>(4 * row);
        for (int column = 0; column < 3; ++column) {
            rows[begin + static_cast<std::size_t>(column)] = rotation(row, column);
        }
        rows[begin + 3] = pose.translation()[row];
    }
    return rows;
}

std::array<double, 7> key_numbers(const Pose& pose) {
    const Quaternion& q = pose.quaternion();
    const Vec3& c = pose.translation();
    return {q.w, q.x, q.y, q.z, c.x(), c.y(), c.z()};
}

void PoseRows::add(const PosePair& poses) {
    if (poses_each == 2) {
        const auto a = pose_rows(poses.a);
        numbers.insert(numbers.end(), a.begin(), a.end());
    }
    const auto b = pose_rows(poses.b);
    numbers.insert(numbers.end(), b.begin(), b.end());
}

} // namespace cd
