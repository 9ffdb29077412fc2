// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How functions of a few hot loops are compiled, so that they use the vectors of the machine.

#ifndef heliosVectorLoops_h
#define heliosVectorLoops_h

// Into each function that uses it.
#if defined(__GNUC__)
#define HELIOS_INLINE inline __attribute__((always_inline))
#else
#define HELIOS_INLINE inline
#endif

// The same operations with the vectors and masks the machine has; without FMA, so the same bytes.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define HELIOS_CLONES __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define HELIOS_CLONES
#endif

#endif
