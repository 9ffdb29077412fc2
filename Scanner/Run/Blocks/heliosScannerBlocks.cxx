// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScannerBlocks.h"

#include "heliosLegScanner.h"
#include "heliosScanCounts.h"

namespace helios
{

//------------------------------------------------------------------------------
bool ScannerBlocks::Compute(const LegPlan&, vtkIdType piece, vtkIdType count)
{
  return this->Scanner.Update(static_cast<int>(piece), static_cast<int>(count));
}

//------------------------------------------------------------------------------
void ScannerBlocks::Count(ScanCounts& counts)
{
  this->Scanner.Count(counts);
  this->Scanner.ReleaseOutput();
}

//------------------------------------------------------------------------------
LegPiece ScannerBlocks::Collect(const LegOutputs& outputs)
{
  LegPiece piece;
  for (const LegOutput& output : outputs)
  {
    piece.push_back(helios::CollectPiece(
      output, [this](int port, std::size_t channel) { return this->CopyOutput(port, channel); }));
  }
  return piece;
}

//------------------------------------------------------------------------------
/// A shallow copy of the output of the scanner, which may then be released.
vtkSmartPointer<vtkDataObject> ScannerBlocks::CopyOutput(int port, std::size_t channel) const
{
  using Data = vtkSmartPointer<vtkDataObject>;
  const bool isJoint = channel == LegOutput::AllChannels;
  const Data data =
    isJoint ? this->Scanner.GetOutput(port) : Data(this->Scanner.GetOutput(port, channel));
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

} // namespace helios
