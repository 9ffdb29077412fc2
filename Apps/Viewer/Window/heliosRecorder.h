// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Stills and videos of a render window.

#ifndef heliosRecorder_h
#define heliosRecorder_h

#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkOggTheoraWriter;
class vtkRenderWindow;
class vtkWindowToImageFilter;

namespace helios::viewer
{

/// Writes a PNG.
Status WriteStill(vtkRenderWindow* window, const std::string& fileName);

/// A video (.ogv), or a folder of frames (a name with one %d such as frame%04d.png).
class Recorder
{
public:
  Recorder();
  ~Recorder();

  Status Open(vtkRenderWindow* window, const std::string& fileName, double framesPerSecond);
  Status AddFrame();
  Status Close();

  bool IsOpen() const { return this->Opened; }
  const std::string& GetFileName() const { return this->FileName; }

private:
  bool IsVideo() const;

  std::string FileName;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkWindowToImageFilter> Grabber;
  vtkSmartPointer<vtkOggTheoraWriter> Video;
  bool Opened = false;
  int NumberOfFrames = 0;
};

} // namespace helios::viewer

#endif
