// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The beams of a scan, with what intercepts them.

#ifndef heliosFoliageBeams_h
#define heliosFoliageBeams_h

#include "heliosFoliageInput.h"
#include "heliosPose.h"
#include "heliosStatus.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace helios
{

/// A part of a beam that is intercepted.
struct FoliageHit
{
  double Range;  // along the beam [m]
  double Energy; // share of the pulse, [0..1]
  double Weight; // 0: no plant, it only ends the path; else 1, or 1 / |cos| of the incidence
};

class FoliageColumns;

/// Beams with their hits, sorted by range; fixed once built.
class FoliageBeams
{
public:
  Status Build(const FoliageInput& input);

  vtkIdType GetNumberOfBeams() const { return static_cast<vtkIdType>(this->First.size()) - 1; }
  Vec3 GetOrigin(vtkIdType beam) const { return Vec3(this->Origins->GetPointer(3 * beam)); }
  Vec3 GetDirection(vtkIdType beam) const { return Vec3(this->Directions->GetPointer(3 * beam)); }
  const FoliageHit* BeginHits(vtkIdType beam) const
  {
    return this->Hits.data() + this->First[static_cast<std::size_t>(beam)];
  }
  const FoliageHit* EndHits(vtkIdType beam) const
  {
    return this->Hits.data() + this->Ends[static_cast<std::size_t>(beam)];
  }

private:
  /// Rows of a cloud by the key of their beam.
  struct Groups
  {
    std::vector<std::int64_t> Keys; // sorted
    std::vector<vtkIdType> Rows;    // in that order
  };

  static void Sort(Groups& groups);
  static Status GroupByPulse(vtkPolyData* cloud, const char* what, Groups& groups);
  static Status GroupEchoes(vtkPolyData* echoes, Groups& groups);
  Status SetPulses(const FoliageInput& input, const Groups& groups);
  Status MakePulses(const FoliageInput& input, const Groups& groups);
  Status FindRows(vtkPolyData* pulses, const Groups& groups);
  Status SetOrigins(const FoliageInput& input, const Groups& groups);
  void AddHits(const FoliageColumns& columns, const Groups& groups, vtkIdType beam);
  void AddSubRays(const FoliageColumns& columns, const Groups& groups, const Groups& echoes,
    const std::vector<std::size_t>& echoFirst, vtkIdType beam);

  vtkSmartPointer<vtkDoubleArray> Origins;
  vtkSmartPointer<vtkDoubleArray> Directions; // unit vectors
  std::vector<std::size_t> First;             // per beam, its first hit; one more at the end
  std::vector<std::size_t> Ends;              // per beam, after its last hit
  std::vector<FoliageHit> Hits;
};

} // namespace helios

#endif
