// The frames of wide nodes, encoded as three small numbers: a frame takes six bytes instead of 36.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace cd {

/// A unit quaternion (w, x, y, z) without its largest component, which is positive and follows from
/// the others. Kind 1 leaves out w, kind 2 x, kind 3 y, kind 4 z. Kind 0 is the body's own frame
/// and has no parts.
struct FrameCode {
    std::uint8_t kind = 0;
    std::array<std::int16_t, 3> parts{}; ///< From -32767 to 32767, in units of 1 / (32767 sqrt(2)).

    friend bool operator==(const FrameCode&, const FrameCode&) = default;
};

inline constexpr std::uint8_t frame_kinds = 5;

/// Decodes a frame: a rotation whose rows are orthonormal within `axes_error_max`. The bits are
/// equal on every host. Returns nothing for an unknown kind, and where the parts are so large that
/// the omitted component would not be the largest.
[[nodiscard]] std::optional<std::array<float, 9>> frame_of(const FrameCode& code);

/// Encodes `frame`, or `frame` with its third row negated, which bounds the same boxes. Each entry
/// changes by at most 1e-4. A frame from `frame_of` gets a code of exactly that frame. The rows are
/// orthonormal within `axes_error_max`.
[[nodiscard]] FrameCode code_of(const std::array<float, 9>& frame);

} // namespace cd
