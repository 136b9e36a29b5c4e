// Selects the instruction set of the SIMD code on this host.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace cd {

/// Instruction sets, best first. Every target gives the same bits.
enum class SimdTarget : std::uint8_t { Avx512, Avx2, Sse4, Neon, Scalar };

/// Returns "avx512", "avx2", "sse4", "neon" or "scalar".
[[nodiscard]] std::string_view to_text(SimdTarget target);

/// Lists the compiled targets that this processor supports, best first. Never empty.
[[nodiscard]] std::span<const SimdTarget> available_simd_targets();

/// Returns the target in use: at first the one that CD_SIMD (environment) names, or the best.
[[nodiscard]] SimdTarget simd_target();

/// Switches the whole process to the named target; "auto" is the best one. An error leaves the
/// target unchanged. A switch is safe at any time, since all targets give the same answers.
/// Errors: BadInput naming the available targets.
[[nodiscard]] Status force_simd_target(std::string_view name);

/// Checks the environment variable CD_SIMD, at a program's start. Errors: BadInput if it names no
/// target of this host; `simd_target` ignores such a name.
[[nodiscard]] Status check_simd_environment();

} // namespace cd
