// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Command line options of the viewer.

#ifndef heliosViewerOptions_h
#define heliosViewerOptions_h

#include <string>
#include <vector>

namespace helios::viewer
{

struct ViewerOptions
{
  std::vector<std::string> Inputs; ///< a survey, clouds, runs, scenes
  std::vector<std::string> Assets; ///< folders
  std::vector<std::string> Plugins;
  int Width = 1280; ///< [pixels]
  int Height = 800;
  bool Offscreen = false;
  bool HasSpeed = false; ///< one was set
  bool FullSpeed = true; ///< run as fast as possible
  double Speed = 1.0;    ///< speed of time, where not FullSpeed
  bool Paused = false;
  double StartTime = -1.0; ///< [s] first shown time; negative: the start
  std::string Camera = "free";
  std::string CameraScript; ///< file of key frames
  std::string ColorBy = "height";
  double PointSize = 2.0;
  bool EyeDome = true;
  bool Fan = true;
  bool Words = true; ///< over the picture
  std::string Theme = "dark";
  std::string Record;   ///< video or frames
  double Seconds = 0.0; ///< length of the recording; 0: 10, or until stopped
  double FramesPerSecond = 25.0;
  std::string Still;               ///< a picture at the end
  std::string State;               ///< a JSON file of the viewer state
  std::string Save = "survey.xml"; ///< file name for the edited survey
  long long Seed = -1;
  bool Noise = true;
};

/// Result of parsing a command line.
enum class OptionsResult
{
  Go,
  Done, ///< help or version was printed
  Wrong ///< the reason is on standard error
};

OptionsResult ReadOptions(int argc, char** argv, ViewerOptions& options);

} // namespace helios::viewer

#endif
