// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The blocks that the scanner of this process computes.

#ifndef heliosScannerBlocks_h
#define heliosScannerBlocks_h

#include "heliosBlockSource.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <cstddef>

namespace helios
{

class LegScanner;

class ScannerBlocks : public BlockSource
{
public:
  /// Uses a scanner that stays, and is set up for the leg of each piece.
  ScannerBlocks(LegScanner& scanner, vtkIdType piecesPerBlock)
    : Scanner(scanner)
    , PiecesPerBlock(piecesPerBlock)
  {
  }

  vtkIdType GetPiecesPerBlock() const override { return this->PiecesPerBlock; }
  bool Compute(const LegPlan& plan, vtkIdType piece, vtkIdType count) override;
  LegPiece Collect(const LegOutputs& outputs) override;
  void Count(ScanCounts& counts) override;

private:
  vtkSmartPointer<vtkDataObject> CopyOutput(int port, std::size_t channel) const;

  LegScanner& Scanner;
  vtkIdType PiecesPerBlock;
};

} // namespace helios

#endif
