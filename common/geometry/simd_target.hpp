// Which instructions the SIMD code uses on this host, and a way to force others.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace cd {

/// Best first. Every target gives the same bits.
enum class SimdTarget : std::uint8_t { Avx512, Avx2, Sse4, Neon, Scalar };

/// "avx512", "avx2", "sse4", "neon", "scalar".
[[nodiscard]] std::string_view to_text(SimdTarget target);

/// Those that this program was compiled for and that this processor runs, best first; never empty.
[[nodiscard]] std::span<const SimdTarget> available_simd_targets();

/// The one in use: at first that which the environment variable CD_SIMD names, or else the best.
[[nodiscard]] SimdTarget simd_target();

/// Uses the target of that name in the whole process from now on; "auto" is the best one. Errors:
/// BadInput naming those available; the target then stays as it was. Safe at any time, since every
/// target gives the same answers.
[[nodiscard]] Status force_simd_target(std::string_view name);

/// An error where CD_SIMD names no target of this host, which `simd_target` passes over. For
/// programs to call when they start.
[[nodiscard]] Status check_simd_environment();

} // namespace cd
