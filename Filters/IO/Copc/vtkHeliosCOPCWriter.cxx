// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCOPCWriter.h"

#include "heliosCopcFile.h"
#include "heliosPartFile.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include <filesystem>
#include <utility>

vtkStandardNewMacro(vtkHeliosCOPCWriter);

namespace
{

/// Ending of the file that Close() makes, before it has its name.
constexpr const char* OctreeEnding = ".octree";

} // namespace

//------------------------------------------------------------------------------
vtkHeliosCOPCWriter::vtkHeliosCOPCWriter()
{
  this->SetWriteCompressed(true);
}

//------------------------------------------------------------------------------
void vtkHeliosCOPCWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LeavesPart: " << this->LeavesPart << "\n"
     << indent << "Progress: " << this->Progress << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosCOPCWriter::Open()
{
  if (this->GetWriteWaveforms() || !this->GetWriteCompressed())
  {
    vtkErrorMacro(<< (this->FileName ? this->FileName : "the file") << ": COPC has "
                  << (this->GetWriteWaveforms()
                         ? "no waveforms; switch WriteWaveforms off, or write LAZ"
                         : "compressed points only; switch WriteCompressed on, or write LAS"));
    return false;
  }
  return this->Superclass::Open();
}

//------------------------------------------------------------------------------
void vtkHeliosCOPCWriter::SetOnProgress(std::function<bool(double)> onProgress)
{
  this->OnProgress = std::move(onProgress);
}

//------------------------------------------------------------------------------
bool vtkHeliosCOPCWriter::Report(double share)
{
  this->Progress = share;
  this->InvokeEvent(vtkCommand::ProgressEvent, &this->Progress);
  this->IsAborted = this->IsAborted || (this->OnProgress && !this->OnProgress(share));
  return !this->IsAborted;
}

//------------------------------------------------------------------------------
bool vtkHeliosCOPCWriter::FinishFile()
{
  if (this->CountOnly)
  {
    return this->Superclass::FinishFile();
  }
  this->IsAborted = false;
  const std::string made = this->GetOpenName() + OctreeEnding;
  helios::CopcFile file([this](double share) { return this->Report(share); });
  const helios::Status status = file.Write(this->GetOpenName() + helios::PartEnding, made);
  if (!status.IsOk())
  {
    if (status.Message() != helios::CopcFile::Stopped)
    {
      this->FailFile(status.Message());
    }
    this->vtkHeliosStreamWriter::Abandon();
    return false;
  }
  if (!this->ReplaceBy(made + helios::PartEnding))
  {
    return false;
  }
  this->NumberOfBytes = this->GetFileSize();
  if (!this->LeavesPart)
  {
    this->RemovePart();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosCOPCWriter::RemovePart()
{
  std::error_code ignored;
  if (this->FileName && std::filesystem::exists(this->FileName, ignored))
  {
    helios::RemoveFile(this->FileName + std::string(helios::PartEnding));
  }
}
