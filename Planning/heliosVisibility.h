// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Visibility matrix: which candidate sees which test point, as bits in an array of the candidates.

#ifndef heliosVisibility_h
#define heliosVisibility_h

#include "heliosStatus.h"
#include "vtkHeliosPlanningModule.h" // For export macro

#include <vtkType.h>

#include <cstdint>
#include <string>

class vtkPolyData;

namespace helios
{

/**
 * The point array Visibility of candidates, read only: tuple c is the row of candidate c, in words of
 * 64 bits; test point v is bit v % 64 of word v / 64. The bits after the last test point are zero.
 */
class VTKHELIOSPLANNING_EXPORT Visibility
{
public:
  /// Returns the number of words in a row.
  static vtkIdType GetRowLength(vtkIdType testPoints) { return (testPoints + 63) / 64; }

  /**
   * Refers to the array, which must outlive this. Errors: no array, another type or width, bits set
   * beyond the last test point.
   */
  Status Set(vtkPolyData* candidates, vtkIdType testPoints);

  vtkIdType GetNumberOfCandidates() const { return this->NumberOfCandidates; }
  vtkIdType GetNumberOfTestPoints() const { return this->NumberOfTestPoints; }
  vtkIdType GetRowLength() const { return this->RowLength; }

  const std::uint64_t* GetRow(vtkIdType candidate) const
  {
    return this->Words + candidate * this->RowLength;
  }

  bool IsVisible(vtkIdType candidate, vtkIdType testPoint) const
  {
    return this->GetRow(candidate)[testPoint / 64] >> (testPoint % 64) & 1u;
  }

  /// Calls visit(testPoint) for every test point a candidate sees, in ascending order.
  template <typename VisitT>
  void ForEach(vtkIdType candidate, VisitT visit) const
  {
    const std::uint64_t* row = this->GetRow(candidate);
    for (vtkIdType w = 0; w < this->RowLength; ++w)
    {
      for (std::uint64_t word = row[w]; word != 0; word &= word - 1)
      {
        visit(64 * w + __builtin_ctzll(word));
      }
    }
  }

  /// Returns the number of test points a candidate sees.
  vtkIdType GetSize(vtkIdType candidate) const;

private:
  const std::uint64_t* Words = nullptr;
  vtkIdType NumberOfCandidates = 0;
  vtkIdType NumberOfTestPoints = 0;
  vtkIdType RowLength = 0;
};

} // namespace helios

#endif
