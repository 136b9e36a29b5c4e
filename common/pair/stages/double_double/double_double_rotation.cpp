#include "common/pair/stages/double_double/double_double_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cd {

namespace {

/// Computes M(q) / q.q, with errors in terms of e = double_double_error. A power of two scales the
/// quaternion. An entry of M sums at most four products whose magnitudes add up to at most n = q.q;
/// the products err by e n and each of three sums by e n. Likewise n errs by 4 e n, and the
/// division by 2 e. So an entry, which is at most 1, errs by 10 e.
DoubleDoubleMatrix rotation_of(const Quaternion& q) {
    const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double w = std::ldexp(q.w, -exponent);
    const double x = std::ldexp(q.x, -exponent);
    const double y = std::ldexp(q.y, -exponent);
    const double z = std::ldexp(q.z, -exponent);
    const DoubleDouble ww = exact_product(w, w);
    const DoubleDouble xx = exact_product(x, x);
    const DoubleDouble yy = exact_product(y, y);
    const DoubleDouble zz = exact_product(z, z);
    const auto twice = [](double l, double r) { return exact_product(2 * l, r); };
    DoubleDoubleMatrix rows{
        DoubleDoubleVec{ww + xx - yy - zz, twice(x, y) - twice(w, z), twice(x, z) + twice(w, y)},
        DoubleDoubleVec{twice(x, y) + twice(w, z), ww - xx + yy - zz, twice(y, z) - twice(w, x)},
        DoubleDoubleVec{twice(x, z) - twice(w, y), twice(y, z) + twice(w, x), ww - xx - yy + zz}};
    const DoubleDouble n = ww + xx + yy + zz;
    for (DoubleDoubleVec& row : rows) {
        for (DoubleDouble& entry : row) {
            entry = entry / n;
        }
    }
    return rows;
}

} // namespace

DoubleDoubleMatrix double_double_rotation(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return rotation_of(pose.quaternion());
    }
    DoubleDoubleMatrix rows;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            rows[i][j].high =
                pose.matrix()(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
    }
    return rows;
}

} // namespace cd
