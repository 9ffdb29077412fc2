// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Proves how far a patch and what was made of it are apart.

#ifndef heliosPatchVerifier_h
#define heliosPatchVerifier_h

#include "heliosMeshDecimation.h"
#include "heliosSurfaceDistance.h"

#include <vector>

namespace helios
{

/**
 * Bounds the distance of each triangle from the other surface, in both directions, in parallel. Of
 * one decimation after another of the same patch it measures only what could have changed:
 * triangles whose bounds came from triangles that are no more.
 */
class PatchVerifier
{
public:
  /// Throws Stopped, here and later, where it is told to stop.
  PatchVerifier(const Patch& patch, double limit, StopCheck& check);

  /// Whether both directions are within the limit.
  bool Verify(const DecimatedPatch& mesh);

  /// The largest bound, after Verify returned true.
  double GetDistance() const;

  /// The triangles of the patch where the limit is exceeded, after Verify returned false.
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
  SurfaceDistance Surface; ///< of the patch

  // By triangle of the patch. Results name triangles by that, too.
  std::vector<Triangle> After;      ///< what became of it
  std::vector<vtkIdType> Places;    ///< in the decimation; -1: taken out
  std::vector<unsigned char> IsNew; ///< taken out, put in or changed since the last time
  std::vector<Result> There, Back;
  std::vector<vtkIdType> Bad;
};

} // namespace helios

#endif
