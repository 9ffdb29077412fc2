// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Enumeration of all covers of few scans.

#ifndef heliosCoverTree_h
#define heliosCoverTree_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

/// The result of a search for covers.
enum class CoverAnswer
{
  Found,
  None,
  Unknown
};

/**
 * Enumerates the covers of at most a number of scans, each once. Branches on the point seen by the
 * fewest remaining candidates: each of these joins in turn, and is excluded afterwards. A branch
 * ends if more points than scans are left no two of which are seen by the same candidate, or if the
 * largest viewsheds left are too small.
 */
class VTKHELIOSPLANNING_EXPORT CoverTree
{
public:
  /// Receives a cover, not necessarily sorted; true: continue.
  using Visitor = std::function<bool(const Choice&)>;

  /// All points are to be seen; columns: the transpose of rows. Both must outlive this.
  CoverTree(const BitRows& rows, const BitRows& columns);

  /// Visits the covers of a number of scans. Found: the visitor ended the search. None: all were
  /// visited. Unknown: the work is used up.
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
  Visitor OnCover;
  StopTest Stop;
  std::int64_t* Work = nullptr;
  std::vector<int> Order; // points, those seen by the fewest first
  Words Free;             // scratch
  Words Seen;             // scratch
};

} // namespace helios

#endif
