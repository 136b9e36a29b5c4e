#include "common/motion/key_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cd {

namespace {

constexpr int bits_of_number = 52;

/// Returns an exact quotient by 2^exponent; no integer if numbers are far below the grid.
double in_steps(double number, int exponent) {
    return std::ldexp(number, -exponent);
}

bool is_on_grid(double number, int step_exponent, unsigned bits) {
    const double steps = in_steps(number, step_exponent);
    return std::abs(steps) <= std::ldexp(1.0, bits_of_number - static_cast<int>(bits)) &&
           steps == std::nearbyint(steps);
}

/// Returns the nearest multiple of 2^step_exponent, ties to even.
double nearest_on_grid(double number, int step_exponent) {
    return std::ldexp(std::nearbyint(in_steps(number, step_exponent)), step_exponent);
}

std::array<double, 4> components(const Quaternion& q) {
    return {q.w, q.x, q.y, q.z};
}

} // namespace

bool KeyGrid::holds(const Pose& key) const {
    const int turn_step = static_cast<int>(bits) - bits_of_number;
    const auto turn = components(key.quaternion());
    const Vec3& position = key.translation();
    return std::ranges::all_of(turn, [&](double x) { return is_on_grid(x, turn_step, bits); }) &&
           std::ranges::all_of(position,
                               [&](double x) { return is_on_grid(x, exponent + turn_step, bits); });
}

Pose KeyGrid::rounded(const Pose& key) const {
    const int turn_step = static_cast<int>(bits) - bits_of_number;
    const auto turn = [&](double x) { return nearest_on_grid(x, turn_step); };
    const auto place = [&](double x) { return nearest_on_grid(x, exponent + turn_step); };
    const Quaternion& q = key.quaternion();
    const Vec3& c = key.translation();
    return Pose::from_quaternion({turn(q.w), turn(q.x), turn(q.y), turn(q.z)},
                                 {place(c.x()), place(c.y()), place(c.z())});
}

int grid_exponent(const Vec3& position) {
    int exponent = KeyGrid::exponent_min;
    for (const double coordinate : position) {
        int each = 0;
        const double fraction = std::frexp(coordinate, &each);
        // 2^n itself is no greater than 2^n; frexp says 1/2 and n + 1.
        const bool is_power = std::abs(fraction) == 0.5;
        if (coordinate != 0) {
            exponent = std::max(exponent, is_power ? each - 1 : each);
        }
    }
    return exponent;
}

} // namespace cd
