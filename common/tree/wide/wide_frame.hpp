// The frames of wide nodes, each named by three small numbers: a frame costs six bytes, not 36.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace cd {

/// A unit quaternion without one of its components, which is the positive root that is left: kind 1
/// lacks the first of w, x, y, z, kind 4 the last. Kind 0 is the body's own frame, without parts.
struct FrameCode {
    std::uint8_t kind = 0;
    std::array<std::int16_t, 3> parts{}; ///< From -32767 to 32767, of 1 / sqrt(2).

    friend bool operator==(const FrameCode&, const FrameCode&) = default;
};

inline constexpr std::uint8_t frame_kinds = 5;

/// The frame that has this code: a rotation whose rows are orthonormal within `axes_error_max`. The
/// same bits on every host. Nothing for an unknown kind, and where the parts are too large for what
/// they leave out to be the largest component.
[[nodiscard]] std::optional<std::array<float, 9>> frame_of(const FrameCode& code);

/// The code of a frame close to this one, or to this one with its third row turned round, which
/// bounds the same boxes: within 1e-4 in each entry. A frame that `frame_of` made gets a code of
/// exactly that frame. The rows are orthonormal within `axes_error_max`.
[[nodiscard]] FrameCode code_of(const std::array<float, 9>& frame);

} // namespace cd
