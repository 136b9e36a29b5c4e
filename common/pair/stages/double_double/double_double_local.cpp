#include "common/pair/stages/double_double/double_double_local.hpp"

#include "common/pair/poses/plain_poses.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

using PlainRow = LocalMap::PlainRow;

/// Returns row k of a quaternion's rotation if it provably keeps axis k or reverses it: a rotation
/// about the axis, or a half turn about a perpendicular axis. (Rounded entries of 0 or 1 would
/// prove nothing.)
std::optional<PlainRow> plain_row(const Quaternion& q, std::size_t k) {
    const std::array<double, 3> vector{q.x, q.y, q.z};
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    const auto column = static_cast<Eigen::Index>(k);
    if (vector[next] == 0 && vector[last] == 0) {
        return PlainRow{column, 1};
    }
    return q.w == 0 && vector[k] == 0 ? std::optional(PlainRow{column, -1}) : std::nullopt;
}

/// Returns row k of a matrix if at most one entry is nonzero, and that one is not tiny.
std::optional<PlainRow> plain_row(const Mat3& matrix, Eigen::Index k) {
    PlainRow row;
    int entries = 0;
    for (Eigen::Index column = 0; column < 3; ++column) {
        if (matrix(k, column) != 0) {
            row = {column, matrix(k, column)};
            ++entries;
        }
    }
    const bool is_exact = entries == 0 || std::abs(row.entry) >= double_double_length_least;
    return entries <= 1 && is_exact ? std::optional(row) : std::nullopt;
}

DoubleDoubleVec cross(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

} // namespace

LocalMap::LocalMap(const Pose& pose)
    : rows(double_double_rotation(pose)),
      translation(pose.translation()),
      largest(1),
      is_matrix(pose.kind() == Pose::Kind::Matrix) {
    if (is_matrix) {
        largest = pose.matrix().cwiseAbs().maxCoeff();
    }
    // A quaternion that permutes axes has entries 0, 1 and -1, apart from small roundings.
    const bool permutes = !is_matrix && permutes_axes(pose);
    const Mat3 nearest = permutes ? Mat3(pose.rotation().array().round()) : Mat3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        plain[k] = is_matrix  ? plain_row(pose.matrix(), row)
                   : permutes ? plain_row(nearest, row)
                              : plain_row(pose.quaternion(), k);
    }
}

double LocalMap::magnitude_of(const Vec3& x, const Vec3& offset) const {
    return 1.01 * (largest * x.cwiseAbs().sum() + offset.cwiseAbs().maxCoeff());
}

DoubleDoubleVec LocalMap::place(const Vec3& x, const Vec3& origin) const {
    DoubleDoubleVec result;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const DoubleDoubleVec& row = rows[k];
        result[k] = exact_sum(translation[axis], -origin[axis]) + row[0] * x[0] +
                    (row[1] * x[1] + row[2] * x[2]);
    }
    return result;
}

std::optional<DoubleDouble> LocalMap::exact_component(const Vec3& x, std::size_t k) const {
    if (!plain[k]) {
        return std::nullopt;
    }
    const double factor = x[plain[k]->column];
    DoubleDouble product;
    if (plain[k]->entry != 0 && factor != 0) {
        product = exact_product(plain[k]->entry, factor);
        if (product.low != 0 || std::abs(factor) < double_double_length_least) {
            return std::nullopt; // The product is not one double, or it may underflow.
        }
    }
    return exact_sum(product.high, translation[static_cast<Eigen::Index>(k)]);
}

std::optional<double>
LocalMap::nearest_component(const Vec3& x, const Vec3& origin, std::size_t k) const {
    if (!is_matrix) {
        return std::nullopt;
    }
    const auto axis = static_cast<Eigen::Index>(k);
    std::array<double, 8> terms{translation[axis], -origin[axis]};
    for (std::size_t j = 0; j < 3; ++j) {
        const double entry = rows[k][j].high;
        const double factor = x[static_cast<Eigen::Index>(j)];
        if (entry == 0 || factor == 0) {
            continue;
        }
        if (std::abs(entry) < double_double_length_least ||
            std::abs(factor) < double_double_length_least) {
            return std::nullopt; // The product's error may underflow.
        }
        const DoubleDouble product = exact_product(entry, factor);
        terms[2 + j] = product.high;
        terms[5 + j] = product.low;
    }
    return nearest_sum(terms);
}

LocalTriangle::LocalTriangle(const LocalMap& map, const Corners& given, const Vec3& origin) {
    const Vec3 offset = map.translation - origin;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = map.place(given[i], origin);
        for (std::size_t k = 0; k < 3; ++k) {
            world[i][k] = map.exact_component(given[i], k);
        }
        magnitude = std::max(magnitude, map.magnitude_of(given[i], offset));
        const Vec3 high(corners[i][0].high, corners[i][1].high, corners[i][2].high);
        least = i == 0 ? high : Vec3(least.cwiseMin(high));
        greatest = i == 0 ? high : Vec3(greatest.cwiseMax(high));
    }
    normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
}

} // namespace cd
