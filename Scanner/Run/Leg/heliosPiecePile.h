// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Concatenates outputs of one scanner that come in pieces.

#ifndef heliosPiecePile_h
#define heliosPiecePile_h

#include "vtkHeliosScannerRunModule.h" // For export macro

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace helios
{

/// Data are copied a logarithmic number of times, and few pieces are kept.
class VTKHELIOSSCANNERRUN_EXPORT PiecePile
{
public:
  /// Adds a piece with the pulses after those of the last; it may change afterwards.
  void Add(vtkDataObject* piece);

  /// Concatenates all pieces.
  void Finish();

  /// All data, after Finish(); null before.
  vtkDataObject* Get() const { return this->Whole; }

private:
  struct Merged
  {
    vtkSmartPointer<vtkDataObject> Data;
    vtkIdType Pieces;
  };
  void JoinLast();

  std::vector<Merged> Groups;
  vtkSmartPointer<vtkDataObject> Whole;
};

} // namespace helios

#endif
