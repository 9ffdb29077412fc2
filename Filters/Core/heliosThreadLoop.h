// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Loops on all threads, from which loops within another one's are kept away.

#ifndef heliosThreadLoop_h
#define heliosThreadLoop_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkSMPTools.h>
#include <vtkType.h>

namespace helios
{

/**
 * While it exists, the loops of its thread run on this thread alone. A thread that waits for a loop
 * on all threads may begin another piece of a loop around it, and so find its own state half changed:
 * work within such a loop, such as on a pulse, has one of these around loops of its own.
 */
class VTKHELIOSFILTERSCORE_EXPORT OneThreadScope
{
public:
  OneThreadScope();
  ~OneThreadScope();
  OneThreadScope(const OneThreadScope&) = delete;
  void operator=(const OneThreadScope&) = delete;

  /// Returns whether the thread has one.
  static bool IsOn();
};

/// Calls work(begin, end) for pieces of [first, last), on all threads unless a OneThreadScope is on.
template <typename WorkT>
void LoopOnThreads(vtkIdType first, vtkIdType last, WorkT work)
{
  if (last - first <= 1 || OneThreadScope::IsOn())
  {
    work(first, last);
    return;
  }
  vtkSMPTools::For(first, last, 1, work);
}

} // namespace helios

#endif
