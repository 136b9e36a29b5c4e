// Selects the targets that SIMD code is compiled for. Include it before any Highway header.
#pragma once

// Excludes SSSE3, which gains nothing over the baseline on current hosts; SVE, whose sizeless
// vectors cannot be members; and POWER and RISC-V, for lack of hosts to test on.
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_PPC8 | HWY_RVV)
