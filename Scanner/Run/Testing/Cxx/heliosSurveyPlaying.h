// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys that are run, and their output.

#ifndef heliosSurveyPlaying_h
#define heliosSurveyPlaying_h

#include "heliosSurveyFiles.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveyPlayer.h"

#include <string>
#include <vector>

namespace helios
{
namespace test
{

/// A line of a point file.
struct Point
{
  double X, Y, Z, Intensity, Width;
  long long Number, Returns, Pulse;
  std::string Part;
  long long Classification;
  double Time;
};

inline std::vector<Point> ReadPoints(const std::string& path)
{
  std::vector<Point> points;
  std::ifstream file(path);
  Point p;
  while (file >> p.X >> p.Y >> p.Z >> p.Intensity >> p.Width >> p.Number >> p.Returns >> p.Pulse >>
    p.Part >> p.Classification >> p.Time)
  {
    points.push_back(p);
  }
  return points;
}

inline std::vector<std::string> ReadLines(const std::string& path)
{
  std::vector<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

/// A player of a survey, with its output in the folder out.
struct Playing
{
  vtkNew<vtkHeliosSurveyPlayer> Player;
  vtkSmartPointer<ErrorObserver> Log = Observe(Player);

  Playing(const Files& files, const Reading& reading)
  {
    this->Player->SetSurvey(reading.Reader->GetSurvey());
    this->Player->SetOutputDirectory((files / "out").c_str());
  }

  void CheckFails(const std::vector<std::string>& messages)
  {
    CHECK_FALSE(this->Player->Run());
    INFO(this->Log->Errors);
    for (const std::string& message : messages)
    {
      INFO("missing: " << message);
      CHECK(this->Log->HasError(message));
      CHECK(this->Player->GetMessage().find(message) != std::string::npos);
    }
  }
};

} // namespace test
} // namespace helios

#endif
