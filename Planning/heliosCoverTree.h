// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// All covers of few scans, one after the other.

#ifndef heliosCoverTree_h
#define heliosCoverTree_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

/// What a search for covers ends with.
enum class CoverAnswer
{
  Found,
  None,
  Unknown
};

/**
 * Goes through the covers of at most so many scans, each once: of the point that fewest can still
 * see, one after the other of those who see it joins, and is out when it had its turn. A branch
 * ends where more points than scans are left of which no two are seen by the same candidate, or
 * where the largest viewsheds left are too small.
 */
class VTKHELIOSPLANNING_EXPORT CoverTree
{
public:
  /// Takes a cover, which need not be sorted; true: go on.
  using Visitor = std::function<bool(const Choice&)>;

  /// All points are to be seen; columns: the problem's rows, transposed. Both must outlive this.
  CoverTree(const BitRows& rows, const BitRows& columns);

  /// Found: the visitor has had enough. None: it has had all. Unknown: after so much work.
  CoverAnswer Visit(
    int count, const Visitor& visitor, std::int64_t& work, const StopTest& stop = {});

private:
  bool Branch(int left, const Words& missing, Words isOut);
  bool Finish(const Words& missing, const Words& isOut);
  bool Follow(int candidate, int left, const Words& missing, const Words& isOut);
  int FindRarest(int left, const Words& missing, const Words& isOut);
  bool IsOn() const { return *this->Work > 0 && !(this->Stop && this->Stop()); }

  BitRows Rows;
  BitRows Columns;
  int Largest = 0;
  Choice Chosen;
  Visitor Take;
  StopTest Stop;
  std::int64_t* Work = nullptr;
  std::vector<int> Order; // points, those first that fewest see
  Words Free;             // scratch
  Words Seen;             // scratch
};

} // namespace helios

#endif
