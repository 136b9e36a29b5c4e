// The targets that SIMD code is compiled for. Include it before anything of Highway.
#pragma once

// Left out: SSSE3, which saves nothing over the baseline on a host of today; SVE, because vectors
// without a size cannot be members; all of POWER and RISC-V, which nobody could try.
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_PPC8 | HWY_RVV)
