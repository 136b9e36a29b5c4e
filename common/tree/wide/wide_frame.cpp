#include "common/tree/wide/wide_frame.hpp"

#include "common/tree/build/build_fit.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

using Axes = std::array<float, 9>;
using Quaternion = std::array<double, 4>; ///< w, x, y, z.

constexpr double part_unit = 0x1.6a09e667f3bcdp-1 / 32767;
/// The largest component's square is at least 1/4; this bound allows for the rounding of the parts.
constexpr double largest_square_min = 0.2499;

Axes rows_of(const Quaternion& q) {
    const auto& [w, x, y, z] = q;
    const std::array<double, 9> rows{1 - 2 * (y * y + z * z),
                                     2 * (x * y - w * z),
                                     2 * (x * z + w * y),
                                     2 * (x * y + w * z),
                                     1 - 2 * (x * x + z * z),
                                     2 * (y * z - w * x),
                                     2 * (x * z - w * y),
                                     2 * (y * z + w * x),
                                     1 - 2 * (x * x + y * y)};
    Axes axes{};
    std::transform(rows.begin(), rows.end(), axes.begin(), [](double entry) {
        return static_cast<float>(entry);
    });
    return axes;
}

double determinant(const std::array<double, 9>& m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/// Returns the quaternion of the rotation `m`, multiplied by four times its component `largest`. A
/// large component causes no cancellation. Shepperd, Quaternion from Rotation Matrix (1978).
Quaternion times_component(const std::array<double, 9>& m, std::size_t largest) {
    switch (largest) {
    case 0:
        return {1 + m[0] + m[4] + m[8], m[7] - m[5], m[2] - m[6], m[3] - m[1]};
    case 1:
        return {m[7] - m[5], 1 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6]};
    case 2:
        return {m[2] - m[6], m[1] + m[3], 1 - m[0] + m[4] - m[8], m[5] + m[7]};
    default:
        return {m[3] - m[1], m[2] + m[6], m[5] + m[7], 1 - m[0] - m[4] + m[8]};
    }
}

FrameCode code_without(const std::array<double, 9>& rotation, std::size_t largest) {
    const Quaternion q = times_component(rotation, largest);
    double squares = 0;
    for (const double component : q) {
        squares += component * component;
    }
    FrameCode code;
    code.kind = static_cast<std::uint8_t>(largest + 1);
    std::size_t part = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i != largest) {
            const double parts = std::nearbyint(q[i] / std::sqrt(squares) / part_unit);
            code.parts[part++] = static_cast<std::int16_t>(std::clamp(parts, -32767.0, 32767.0));
        }
    }
    return code;
}

} // namespace

std::optional<Axes> frame_of(const FrameCode& code) {
    if (code.kind == 0) {
        return body_axes;
    }
    if (code.kind >= frame_kinds) {
        return std::nullopt;
    }
    Quaternion q{};
    const std::size_t largest = code.kind - std::size_t{1};
    double rest = 1;
    std::size_t part = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i != largest) {
            q[i] = part_unit * static_cast<double>(code.parts[part++]);
            rest -= q[i] * q[i];
        }
    }
    if (!(rest >= largest_square_min)) {
        return std::nullopt;
    }
    q[largest] = std::sqrt(rest);
    return rows_of(q);
}

FrameCode code_of(const Axes& frame) {
    if (frame == body_axes) {
        return {};
    }
    std::array<double, 9> rotation{};
    std::copy(frame.begin(), frame.end(), rotation.begin());
    if (determinant(rotation) < 0) {
        for (std::size_t i = 6; i < 9; ++i) {
            rotation[i] = -rotation[i];
        }
    }
    // If the two largest components are nearly equal, rounding may have left out either one, and
    // the two codes' frames differ. If this frame has a code, the code leaves out one of these two.
    std::array<double, 4> diagonal{};
    std::size_t largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        diagonal[i] = times_component(rotation, i)[i];
        largest = diagonal[i] > diagonal[largest] ? i : largest;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        if (diagonal[i] > 0.99) {
            const FrameCode code = code_without(rotation, i);
            if (frame_of(code) == frame) {
                return code;
            }
        }
    }
    return code_without(rotation, largest);
}

} // namespace cd
