// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged camera scripts and runs give a message that names the file, or cameras and points.
#include "heliosCameraRig.h"
#include "heliosCloud.h"
#include "heliosCloudReader.h"
#include "heliosMutation.h"
#include "heliosStatus.h"
#include "heliosTempFolder.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>

using namespace helios;
using namespace helios::viewer;

namespace
{

const std::string Frames = R"([{"time": 0, "position": [500000, 5400000, 200],
 "focalPoint": [500000, 5400010, 100]}, {"time": 5.5, "position": [500050, 5400000, 2e2],
 "focalPoint": [500100, 5400010, 100], "viewUp": [0, 0, 1]},
 {"time": 10, "position": [500100, 5400000, 200], "focalPoint": [500100, 5400010, 100]}])";
const std::string Summary =
  R"({"versions": {"vtkHelios": "0.1"}, "legs": [{"leg": 0, "points": 2, "files":
 [{"name": "leg000_points.xyz", "records": 2, "bytes": 92}, {"name": "leg000_trajectory.txt",
 "records": 2, "bytes": 60}]}]})";
const std::string Points = "1 2 3 0.5 4 1 1 7 floor 2 0.5\n2 3 4 0.25 4 1 2 8 wall 6 0.75\n";
const std::string Way = "0 0 10 0 0 0 90\n5 0 10 1 0 0 90\n";

void Write(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

/// A text in enough brackets to overflow a recursive reader.
std::string Nest(const std::string& text, int depth)
{
  const auto n = static_cast<std::size_t>(depth);
  return std::string(n, '[') + text + std::string(n, ']');
}

std::string Damage(Mutator& mutate, const std::string& text, int i)
{
  return i % 20 == 19 ? Nest(text, 100 * i) : i % 2 == 0 ? mutate.ChangeNumber(text) : mutate(text);
}

} // namespace

TEST_CASE("ViewerMutations: damaged camera scripts give an error or cameras", "[Viewer][mutation]")
{
  TempFolder folder;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  Mutator mutate(20207);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < GetNumberOfMutations(); ++i)
  {
    const std::string text = Damage(mutate, Frames, i);
    Write(folder / "a.json", text);
    INFO("case " << i << "\n" << text.substr(0, 1000));
    CameraRig rig(renderer);
    rig.SetMode(CameraMode::Script);
    const Status status = rig.ReadScript(folder / "a.json");
    (status.IsOk() ? goodCount : errorCount) += 1;
    REQUIRE((status.IsOk() || status.Message().find("a.json") != std::string::npos));
    for (int step = 0; step < 3 && status.IsOk(); ++step)
    {
      rig.Update(2.5, nullptr);
      const double* eye = renderer->GetActiveCamera()->GetPosition();
      REQUIRE((std::isfinite(eye[0]) && std::isfinite(eye[1]) && std::isfinite(eye[2])));
    }
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 10);
}

TEST_CASE("ViewerMutations: damaged runs give an error or points", "[Viewer][mutation]")
{
  TempFolder folder;
  const std::string names[] = { "run_summary.json", "leg000_points.xyz", "leg000_trajectory.txt" };
  const std::string texts[] = { Summary, Points, Way };
  Mutator mutate(20208);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < GetNumberOfMutations(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      Write(folder / names[k], texts[k]);
    }
    const int which = i % 5 < 3 ? 0 : i % 5 - 2;
    const std::string text = Damage(mutate, texts[which], i);
    Write(folder / names[which], text);
    INFO("case " << i << ", " << names[which] << "\n" << text.substr(0, 1000));
    Cloud cloud;
    CloudReader reader;
    const Status status = reader.Read(folder / "", cloud);
    (status.IsOk() ? goodCount : errorCount) += 1;
    REQUIRE((!status.IsOk() || cloud.GetNumberOfPoints() > 0));
    for (vtkIdType p = 0; p < cloud.GetNumberOfPoints(); ++p)
    {
      const Echo echo = cloud.GetEcho(p);
      REQUIRE((std::isfinite(echo.Position[0]) && std::isfinite(echo.Position[1]) &&
        std::isfinite(echo.Position[2])));
    }
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 10);
}

TEST_CASE("ViewerMutations: a file name with a leg number out of range", "[Viewer]")
{
  TempFolder folder;
  Write(folder / "leg99999999999999999999_points.xyz", Points);
  Cloud cloud;
  CloudReader reader;
  CHECK(reader.Read(folder / "leg99999999999999999999_points.xyz", cloud).IsOk());
  CHECK(cloud.GetNumberOfPoints() == 2);
}
