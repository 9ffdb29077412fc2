// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRecorder.h"

#include "heliosPartFile.h"
#include "heliosSignals.h"
#include "heliosStatus.h"

#include <vtkImageData.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

/// Returns an error if the folder of a file does not exist.
Status CheckFolder(const std::string& fileName)
{
  const fs::path folder = fs::path(fileName).parent_path();
  std::error_code error;
  return folder.empty() || fs::is_directory(folder, error)
    ? Status()
    : Status::Error(
        fileName + ": the folder " + folder.string() + " does not exist; create it first");
}

bool HasExtension(const std::string& fileName, const char* extension)
{
  return fs::path(fileName).extension() == extension;
}

/// Gives a file that is complete its final name; or removes it.
bool FinishFile(const std::string& fileName, bool isComplete)
{
  const std::string part = fileName + PartEnding;
  std::error_code error;
  isComplete ? fs::rename(part, fileName, error) : static_cast<void>(fs::remove(part, error));
  SetUnfinished(part, false);
  return isComplete && !error;
}

Status WriteImage(vtkAlgorithmOutput* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  const auto size = static_cast<std::size_t>(bytes->GetNumberOfValues());
  return WriteUnsynced(
    fileName, std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)), size));
}

} // namespace

//------------------------------------------------------------------------------
Status WriteStill(vtkRenderWindow* window, const std::string& fileName)
{
  if (!HasExtension(fileName, ".png"))
  {
    return Status::Error(fileName + ": stills are PNG; give a name that ends in .png");
  }
  const Status status = CheckFolder(fileName);
  if (!status.IsOk())
  {
    return status;
  }
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  return WriteImage(grabber->GetOutputPort(), fileName);
}

//------------------------------------------------------------------------------
Recorder::Recorder() = default;

//------------------------------------------------------------------------------
Recorder::~Recorder()
{
  static_cast<void>(this->Close()); // nobody can be told
}

//------------------------------------------------------------------------------
bool Recorder::IsVideo() const
{
  return HasExtension(this->FileName, ".ogv");
}

//------------------------------------------------------------------------------
Status Recorder::Open(vtkRenderWindow* window, const std::string& fileName, double framesPerSecond)
{
  this->FileName = fileName;
  const bool isSequence = std::regex_match(fileName, std::regex("[^%]*%0?[1-9]?d[^%]*[.]png"));
  if (!this->IsVideo() && !isSequence)
  {
    return Status::Error(fileName +
      ": give a name that ends in .ogv (Ogg Theora), or one with %04d that ends in "
      ".png for one picture per frame");
  }
  const Status status = CheckFolder(fileName);
  if (!status.IsOk())
  {
    return status;
  }
  this->Window = window;
  this->Grabber->SetInput(window);
  this->Grabber->ReadFrontBufferOff();
  this->NumberOfFrames = 0;
  if (this->IsVideo())
  {
    this->Video = vtkSmartPointer<vtkOggTheoraWriter>::New();
    this->Video->SetInputConnection(this->Grabber->GetOutputPort());
    RemoveFile(fileName + PartEnding); // it may be a link
    SetUnfinished(fileName + PartEnding, true);
    this->Video->SetFileName((fileName + PartEnding).c_str());
    this->Video->SetRate(static_cast<int>(std::lround(framesPerSecond)));
    this->Video->SetQuality(2);
    this->Video->Start();
    if (this->Video->GetError())
    {
      FinishFile(fileName, false);
      return Status::Error(
        fileName + ": cannot be written; check the free space and permissions of its folder");
    }
  }
  this->Opened = true;
  return {};
}

//------------------------------------------------------------------------------
Status Recorder::AddFrame()
{
  this->Grabber->Modified();
  Status status;
  if (this->Video)
  {
    this->Video->Write();
    status = this->Video->GetError()
      ? Status::Error(this->FileName + ": a frame cannot be written; is the disk full?")
      : Status();
  }
  else
  {
    std::vector<char> name(this->FileName.size() + 32);
    std::snprintf(name.data(), name.size(), this->FileName.c_str(), this->NumberOfFrames);
    status = WriteImage(this->Grabber->GetOutputPort(), name.data());
  }
  this->NumberOfFrames += status.IsOk() ? 1 : 0;
  return status;
}

//------------------------------------------------------------------------------
Status Recorder::Close()
{
  const bool hadVideo = this->Opened && this->Video;
  this->Opened = false;
  if (!hadVideo)
  {
    return {};
  }
  this->Video->End();
  const bool isGood = !this->Video->GetError();
  this->Video = nullptr;
  return FinishFile(this->FileName, isGood)
    ? Status()
    : Status::Error(this->FileName + ": cannot be finished; is the disk full?");
}

} // namespace helios::viewer
