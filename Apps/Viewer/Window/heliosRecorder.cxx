// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRecorder.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <vector>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

/// Returns why a file cannot be created there, or an empty string.
std::string CheckFolder(const std::string& fileName)
{
  const fs::path folder = fs::path(fileName).parent_path();
  std::error_code error;
  return folder.empty() || fs::is_directory(folder, error)
    ? ""
    : fileName + ": the folder " + folder.string() + " does not exist; create it first";
}

bool HasExtension(const std::string& fileName, const char* extension)
{
  return fs::path(fileName).extension() == extension;
}

std::string WriteImage(vtkAlgorithmOutput* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError ? ""
                                                         : fileName +
      ": cannot be written: " + vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
}

} // namespace

//------------------------------------------------------------------------------
std::string WriteStill(vtkRenderWindow* window, const std::string& fileName)
{
  if (!HasExtension(fileName, ".png"))
  {
    return fileName + ": stills are PNG; give a name that ends in .png";
  }
  const std::string problem = CheckFolder(fileName);
  if (!problem.empty())
  {
    return problem;
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
  this->Close();
}

//------------------------------------------------------------------------------
bool Recorder::IsVideo() const
{
  return HasExtension(this->FileName, ".ogv");
}

//------------------------------------------------------------------------------
std::string Recorder::Open(
  vtkRenderWindow* window, const std::string& fileName, double framesPerSecond)
{
  this->FileName = fileName;
  const bool isSequence = std::regex_match(fileName, std::regex("[^%]*%0?[1-9]?d[^%]*[.]png"));
  if (!this->IsVideo() && !isSequence)
  {
    return fileName +
      ": give a name that ends in .ogv (Ogg Theora), or one with %04d that ends in "
      ".png for one picture per frame";
  }
  const std::string problem = CheckFolder(fileName);
  if (!problem.empty())
  {
    return problem;
  }
  this->Window = window;
  this->Grabber->SetInput(window);
  this->Grabber->ReadFrontBufferOff();
  this->NumberOfFrames = 0;
  if (this->IsVideo())
  {
    this->Video = vtkSmartPointer<vtkOggTheoraWriter>::New();
    this->Video->SetInputConnection(this->Grabber->GetOutputPort());
    this->Video->SetFileName(fileName.c_str());
    this->Video->SetRate(static_cast<int>(std::lround(framesPerSecond)));
    this->Video->SetQuality(2);
    this->Video->Start();
    if (this->Video->GetError())
    {
      return fileName + ": cannot be written; check the free space and permissions of its folder";
    }
  }
  this->Opened = true;
  return {};
}

//------------------------------------------------------------------------------
std::string Recorder::AddFrame()
{
  this->Grabber->Modified();
  std::string problem;
  if (this->Video)
  {
    this->Video->Write();
    problem = this->Video->GetError()
      ? this->FileName + ": a frame cannot be written; is the disk full?"
      : "";
  }
  else
  {
    std::vector<char> name(this->FileName.size() + 32);
    std::snprintf(name.data(), name.size(), this->FileName.c_str(), this->NumberOfFrames);
    problem = WriteImage(this->Grabber->GetOutputPort(), name.data());
  }
  this->NumberOfFrames += problem.empty() ? 1 : 0;
  return problem;
}

//------------------------------------------------------------------------------
std::string Recorder::Close()
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
  return isGood ? "" : this->FileName + ": cannot be finished; is the disk full?";
}

} // namespace helios::viewer
