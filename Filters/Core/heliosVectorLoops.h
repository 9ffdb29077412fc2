// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Compiler attributes for hot loops, to use the vector instructions of the machine.

#ifndef heliosVectorLoops_h
#define heliosVectorLoops_h

// Inlined into every caller.
#if defined(__GNUC__)
#define HELIOS_INLINE inline __attribute__((always_inline))
#else
#define HELIOS_INLINE inline
#endif

// Compiled for several instruction sets; without FMA, so results are byte-identical.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define HELIOS_CLONES __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define HELIOS_CLONES
#endif

#endif
