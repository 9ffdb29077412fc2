// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds the distance between a patch and its decimation.

#ifndef heliosPatchVerifier_h
#define heliosPatchVerifier_h

#include "heliosMeshDecimation.h"
#include "heliosSurfaceDistance.h"

#include <vector>

namespace helios
{

/**
 * Bounds the distance of each triangle from the other surface, in both directions, in parallel. For
 * successive decimations of the same patch only possible changes are measured: triangles whose
 * bounds came from triangles that no longer exist.
 */
class PatchVerifier
{
public:
  /// Throws Stopped, here and later, if the stop check returns true.
  PatchVerifier(const Patch& patch, double limit, StopCheck& check);

  /// Returns whether both directions are within the limit.
  bool Verify(const DecimatedPatch& mesh);

  /// Returns the largest bound, after Verify returned true.
  double GetDistance() const;

  /// Returns the triangles of the patch where the limit is exceeded, after Verify returned false.
  const std::vector<vtkIdType>& GetBadTriangles() const { return this->Bad; }

private:
  using Result = SurfaceDistance::Result;

  bool NeedsCheck(const Result& result) const;
  void Check(const std::vector<vtkIdType>& which, const std::vector<Triangle>& from,
    const SurfaceDistance& to, const std::vector<vtkIdType>& hints, std::vector<Result>& results);
  void CheckThere(const DecimatedPatch& mesh);
  void CheckBack();

  const Patch& Source;
  double Limit;
  StopCheck& Stop;
  std::vector<Triangle> Before;
  SurfaceDistance Surface; ///< surface of the patch

  // One entry per triangle of the patch. Results refer to triangles by the same index.
  std::vector<Triangle> After;      ///< its state after decimation
  std::vector<vtkIdType> Places;    ///< in the decimation; -1: removed
  std::vector<unsigned char> IsNew; ///< removed, added or changed since the last time
  std::vector<Result> There, Back;
  std::vector<vtkIdType> Bad;
};

} // namespace helios

#endif
