// The instruction sets that the lanes are compiled for: the compiler's baseline, SSE4, AVX2, AVX-512; Neon on Arm. What lies
// between those gains nothing here. Included before anything of Highway.
#pragma once

// The fallback is one lane. Of Highway's emulated vectors each operation is a loop, for which clang takes minutes a file.
#if !defined(HWY_BROKEN_EMU128)
#define HWY_BROKEN_EMU128 1
#endif

#if !defined(HWY_DISABLED_TARGETS)
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
