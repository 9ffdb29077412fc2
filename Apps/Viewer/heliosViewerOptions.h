// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the command line of the viewer says.

#ifndef heliosViewerOptions_h
#define heliosViewerOptions_h

#include <string>
#include <vector>

namespace helios
{

struct ViewerOptions
{
  std::vector<std::string> Inputs; ///< a survey, clouds, runs, scenes
  std::vector<std::string> Assets; ///< folders
  int Width = 1280;                ///< [pixels]
  int Height = 800;
  bool Offscreen = false;
  bool HasSpeed = false; ///< one was given
  bool FullSpeed = true; ///< as fast as it computes
  double Speed = 1.0;    ///< of time, where not FullSpeed
  bool Paused = false;
  double StartTime = -1.0; ///< [s] that is shown first; negative: the start
  std::string Camera = "free";
  std::string CameraScript; ///< file of key frames
  std::string ColorBy = "height";
  double PointSize = 2.0;
  bool EyeDome = true;
  bool Fan = true;
  bool Words = true;    ///< over the picture
  std::string Record;   ///< video or frames
  double Seconds = 0.0; ///< of the recording; 0: 10, or until the user ends it
  double FramesPerSecond = 25.0;
  std::string Still;               ///< a picture of the end
  std::string State;               ///< a JSON file that says what is shown
  std::string Save = "survey.xml"; ///< where a survey made by hand is saved
  long long Seed = -1;
  bool Noise = true;
};

/// What came of reading a command line.
enum class OptionsResult
{
  Go,
  Done, ///< help or version was printed
  Wrong ///< the reason is on standard error
};

OptionsResult ReadOptions(int argc, char** argv, ViewerOptions& options);

} // namespace helios

#endif
