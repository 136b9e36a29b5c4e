#include "common/pair/numbers/orientation.hpp"

#include "common/pair/numbers/dyadic.hpp"

#include <cmath>
#include <cstddef>

namespace cd {

namespace {

int exact_orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    const auto difference = [&c](const PlanePoint& point, std::size_t axis) {
        return to_dyadic(point[axis]) - to_dyadic(c[axis]);
    };
    const Dyadic determinant =
        difference(a, 0) * difference(b, 1) - difference(a, 1) * difference(b, 0);
    return determinant.mantissa.sign();
}

} // namespace

int orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    const double left = (a[0] - c[0]) * (b[1] - c[1]);
    const double right = (a[1] - c[1]) * (b[0] - c[0]);
    const double determinant = left - right;
    const double bound = 0x1p-51 * (std::abs(left) + std::abs(right)) + 0x1p-1000;
    if (std::abs(determinant) > bound) {
        return determinant > 0 ? 1 : -1;
    }
    return exact_orientation(a, b, c);
}

} // namespace cd
