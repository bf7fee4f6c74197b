// A function compiled for several instruction sets, of which the best is chosen when the program starts. Its loops over lanes become
// vector instructions; contraction is off (CMakeLists.txt), so that all give the same bits.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define AIRLIGHT_EVERY_PROCESSOR __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define AIRLIGHT_EVERY_PROCESSOR
#endif

/// Into such a loop, always.
#define AIRLIGHT_INLINE inline __attribute__((always_inline))
