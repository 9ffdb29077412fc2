// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Concatenates outputs of one scanner that come in pieces.

#ifndef heliosPieceBuffer_h
#define heliosPieceBuffer_h

#include "vtkHeliosScannerRunModule.h" // For export macro

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace helios
{

/// Data are copied a logarithmic number of times, and few pieces are kept.
class VTKHELIOSSCANNERRUN_EXPORT PieceBuffer
{
public:
  /// Adds a piece whose pulses follow the last one's; it may change afterwards.
  void Add(vtkDataObject* piece);

  /// Concatenates all pieces.
  void Finish();

  /// Returns all data, after Finish(); null before.
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
