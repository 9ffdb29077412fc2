// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A plate that moves 1 m every 0.05 s, or deforms: its drawn position, with echoes on it.
#include "heliosSceneMover.h"

#include "heliosSceneView.h"
#include "heliosStepFiles.h"
#include "heliosTheme.h"
#include "heliosViewer.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace helios;
using namespace helios::viewer;

namespace
{

constexpr double Start = -10.0; // x of the plate's centre [m]

/// The flight, with a plate of 4 m beside it or below it instead of the step.
class MovingFiles : public StepFiles
{
public:
  MovingFiles(double y, const std::string& clock)
  {
    std::string corners;
    for (const auto& corner : { Vec3(-2, -2, 1), Vec3(2, -2, 1), Vec3(2, 2, 1), Vec3(-2, 2, 1) })
    {
      corners += "v " + std::to_string(Start + corner[0]) + " " + std::to_string(y + corner[1]) +
        " " + std::to_string(corner[2]) + "\n";
    }
    this->Write("plate.mtl", "newmtl car\nhelios_classification 6\n");
    this->Write("plate.obj", "mtllib plate.mtl\nusemtl car\n" + corners + "f 1 2 3 4\n");
    this->Replace("scene.xml", "<part id=\"plate\">",
      "<part id=\"plate\" " + clock +
        "><dmotion id=\"all\" loop=\"0\"><motion type=\"translation\" vec=\"1;0;0\"/></dmotion>");
    this->Options.Inputs = { (this->Folder / "survey.xml").string() };
    this->Options.Offscreen = true;
    this->Options.Still = (this->Folder / "still.png").string();
    this->Options.Width = 400;
    this->Options.Height = 300;
    this->Options.Camera = "top";
    this->Options.Words = false;
    this->Options.Fan = false;
    this->Options.EyeDome = false;
  }

  ViewerOptions Options;
};

constexpr double FramesPerSecond = 4.0;

/// The height of a corner of the plate that deforms at a place among its frames [m].
double GetHeight(int corner, double place)
{
  const double before = std::floor(place);
  const auto get = [](double frame) { return 0.1 * frame * frame; };
  const double rise = get(before) + (place - before) * (get(before + 1.0) - get(before));
  return 1.0 + (corner + 1) * rise;
}

/// The flight, with a plate that deforms: its corners rise, the faster the later in the file. The first
/// vertex is not used, the others not in their order.
class DeformingFiles : public MovingFiles
{
public:
  explicit DeformingFiles(const std::string& clock)
    : MovingFiles(30.0, clock)
  {
    for (int frame = 0; frame < 6; ++frame)
    {
      std::string text = "v 7 7 7\n";
      for (int corner = 0; corner < 4; ++corner)
      {
        text += "v " + std::to_string(GetX(corner)) + " " + std::to_string(GetY(corner)) + " " +
          std::to_string(GetHeight(corner, frame)) + "\n";
      }
      this->Write("plate_" + std::to_string(frame + 8) + ".obj", text + "f 4 3 2\nf 5 4 2\n");
    }
    this->Replace("scene.xml", "key=\"filepath\" value=\"plate.obj\"/>\n</filter>",
      R"(key="efilepath" value="plate_\d+\.obj"/></filter><filter type="frames">
<param key="framesPerSecond" value="4"/><param key="tStart" value="0.1"/></filter>)");
  }

  static double GetX(int corner) { return Start + (corner == 1 || corner == 2 ? 2.0 : -2.0); }
  static double GetY(int corner) { return 30.0 + (corner >= 2 ? 2.0 : -2.0); }
};

/// Returns the number of points that are corners of the plate moved by x, at a place among its frames.
int CountCorners(vtkPolyData* mesh, double x, double place)
{
  int found = 0;
  for (vtkIdType i = 0; i < 4 * mesh->GetNumberOfPoints(); ++i)
  {
    const auto corner = static_cast<int>(i % 4);
    const Vec3 wanted(
      DeformingFiles::GetX(corner) + x, DeformingFiles::GetY(corner), GetHeight(corner, place));
    found += (Vec3(mesh->GetPoint(i / 4)) - wanted).Norm() < 1e-6 ? 1 : 0;
  }
  return found;
}

/// Whether a position [m] has a colour in the picture.
bool HasColor(Viewer& viewer, const Vec3& place, const Rgb& color)
{
  const Vec3 local = place - viewer.GetOrigin();
  vtkRenderer* renderer = viewer.GetRenderer();
  renderer->SetWorldPoint(local[0], local[1], local[2], 1.0);
  renderer->WorldToDisplay();
  const double* at = renderer->GetDisplayPoint();
  const auto x = static_cast<int>(at[0]);
  const auto y = static_cast<int>(at[1]);
  vtkNew<vtkUnsignedCharArray> pixel;
  viewer.GetWindow()->GetPixelData(x, y, x, y, 0, pixel.Get(), 0);
  int off = 0;
  for (int k = 0; k < 3; ++k)
  {
    off = std::max(off, std::abs(pixel->GetValue(k) - color[static_cast<std::size_t>(k)]));
  }
  return off <= 3;
}

} // namespace

TEST_CASE("SceneMover: a part is drawn at its position at the displayed time")
{
  const std::string clock = GENERATE("dynTimeStep=\"0.05\"", "dynStep=\"100\""); // at 2 kHz
  MovingFiles files(30.0, clock);
  for (const double time : { 0.26, 0.76 })
  {
    CAPTURE(clock, time);
    files.Options.StartTime = time;
    Viewer viewer(files.Options);
    REQUIRE(viewer.Run() == 0);
    const double x = Start + std::floor(time / 0.05);
    const Rgb color = FindTheme("dark").Scene.Over(GetClassColor(6)); // below echoes
    CHECK(HasColor(viewer, { x, 30.0, 1.0 }, color));
    CHECK(HasColor(viewer, { x + 1.7, 31.7, 1.0 }, color));
    CHECK(HasColor(viewer, { x - 1.7, 28.3, 1.0 }, color));
    CHECK_FALSE(HasColor(viewer, { x + 2.5, 30.0, 1.0 }, color));
    CHECK_FALSE(HasColor(viewer, { x - 2.5, 30.0, 1.0 }, color));
  }
}

TEST_CASE("SceneMover: echoes lie on the part at their time, forwards and backwards")
{
  MovingFiles files(0.0, "dynTimeStep=\"0.05\"");
  Viewer viewer(files.Options);
  REQUIRE(viewer.Run() == 0);
  SceneView view(viewer.GetRenderer());
  REQUIRE(view.SetScene(viewer.GetSimulation()->GetScene()).IsOk());
  SceneMover mover(viewer.GetSurvey()->GetData(), viewer.GetSimulation()->GetScene());
  mover.SetView(view);
  const Cloud& cloud = viewer.GetCloud();
  int onPart = 0;
  int offPart = 0;
  double lowest = 1e9;
  double highest = -1e9;
  for (vtkIdType i = 0; i < cloud.GetNumberOfPoints(); ++i)
  {
    const vtkIdType row = i % 2 == 0 ? i : cloud.GetNumberOfPoints() - i;
    const Echo echo = cloud.GetEcho(row);
    if (echo.Part != 1)
    {
      continue;
    }
    mover.MoveTo(viewer.GetLegs(), echo.GpsTime);
    CHECK_FALSE(mover.MoveTo(viewer.GetLegs(), echo.GpsTime)); // unchanged
    double bounds[6];
    view.GetMovingMesh()->GetPoints()->GetBounds(bounds);
    const double x = echo.Position[0];
    (x > bounds[0] - 0.3 && x < bounds[1] + 0.3 ? onPart : offPart) += 1; // a footprint is 0.5 m
    lowest = std::min(lowest, bounds[0]);
    highest = std::max(highest, bounds[0]);
  }
  CHECK(onPart > 100);
  CHECK(offPart == 0);
  CHECK(lowest == Approx(Start - 2.0));
  CHECK(highest == Approx(Start - 2.0 + 19.0)); // the last of 20 steps in a second
}

TEST_CASE("SceneMover: continuous motion is drawn between two steps")
{
  MovingFiles files(30.0, "dynTimeStep=\"0.5\" motion=\"continuous\"");
  for (const double time : { 0.0, 0.2, 0.85, 1e9 }) // the last is beyond the end
  {
    files.Options.StartTime = time;
    Viewer viewer(files.Options);
    REQUIRE(viewer.Run() == 0);
    double bounds[6];
    viewer.GetSceneView()->GetMovingMesh()->GetPoints()->GetBounds(bounds);
    CHECK(bounds[0] == Approx(Start - 2.0 + viewer.GetClock().GetTime() / 0.5));
    CHECK(viewer.GetClock().GetTime() == Approx(std::min(time, viewer.GetClock().GetEnd())));
  }
}

TEST_CASE("SceneMover: a part follows its trajectory, and carries one that turns")
{
  MovingFiles files(0.0, "dynTimeStep=\"0.25\" motion=\"continuous\" mount=\"car\"");
  files.Replace("scene.xml", "type=\"translation\" vec=\"1;0;0\"",
    "type=\"rotation\" axis=\"0;0;1\" angle=\"45\" selfMode=\"true\"");
  files.Write("car.obj", "v 0 -1 2\nv 1 -1 2\nv 1 1 2\nv 0 1 2\nf 1 2 3 4\n");
  files.Write(
    "car.csv", "# t,roll,pitch,yaw,x,y,z\n0,0,0,0,5000,5e6,0\n1,0,0,0,5000,5000020.5,0\n");
  files.Replace("scene.xml", "</scene>", R"(<part id="car"><filter type="objloader">
<param type="string" key="filepath" value="car.obj"/></filter><trajectory file="car.csv" tIndex="0"
 rollIndex="1" pitchIndex="2" yawIndex="3" xIndex="4" yIndex="5" zIndex="6"/></part></scene>)");
  files.Options.StartTime = 0.5;
  Viewer viewer(files.Options);
  REQUIRE(viewer.Run() == 0);
  vtkPolyData* mesh = viewer.GetSceneView()->GetMovingMesh();
  REQUIRE(mesh->GetNumberOfPoints() == 8); // the plate first
  const Vec3 corner(mesh->GetPoint(0)); // was at (-12, -2, 1), turned by 90 degrees about (-10, 0)
  CHECK(corner[0] == Approx(5000.0 - 8.0));
  CHECK(std::abs(corner[1] - (5000010.25 - 2.0)) < 1e-6); // not rounded to floats
  CHECK(corner[2] == Approx(1.0));
  const Vec3 car(mesh->GetPoint(4));
  CHECK(car[0] == Approx(5000.0));
  CHECK(std::abs(car[1] - 5000009.25) < 1e-6);
  double bounds[6]; // the first view has the parts where they are at the start
  SceneMover mover(viewer.GetSurvey()->GetData(), viewer.GetSimulation()->GetScene());
  REQUIRE(mover.GetBounds(viewer.GetLegs().front(), bounds));
  CHECK(bounds[0] == Approx(-60.0)); // the ground
  CHECK(bounds[1] == Approx(5001.0));
}

TEST_CASE("SceneMover: a part that deforms has its shape at the displayed time")
{
  const double step = GENERATE(0.0, 0.3);
  DeformingFiles files(
    step > 0.0 ? "dynTimeStep=\"0.3\"" : "dynTimeStep=\"0.5\" motion=\"continuous\"");
  Viewer viewer(files.Options);
  REQUIRE(viewer.Run() == 0);
  SceneView& view = *viewer.GetSceneView();
  SceneMover mover(viewer.GetSurvey()->GetData(), viewer.GetSimulation()->GetScene(),
    viewer.GetSimulation()->GetFrames());
  mover.SetView(view);
  for (const double time : { 0.85, 0.4, 0.0, 0.95 }) // forwards and backwards
  {
    CAPTURE(step, time);
    REQUIRE(mover.MoveTo(viewer.GetLegs(), time));
    CHECK_FALSE(mover.MoveTo(viewer.GetLegs(), time)); // unchanged
    const double steps = step > 0.0 ? std::floor(time / step) : time / 0.5;
    const double seen = step > 0.0 ? steps * step : time;
    CHECK(view.GetMovingMesh()->GetNumberOfPoints() == 4);
    CHECK(CountCorners(view.GetMovingMesh(), steps, FramesPerSecond * (seen + 0.1)) == 4);
  }
  double bounds[6];
  REQUIRE(mover.GetBounds(viewer.GetLegs().front(), bounds));
  CHECK(bounds[5] == Approx(GetHeight(3, 0.4)));
}

TEST_CASE("SceneMover: parts of the same frames deform where they are")
{
  DeformingFiles files("motion=\"continuous\"");
  files.Replace("scene.xml",
    R"(<dmotion id="all" loop="0"><motion type="translation" vec="1;0;0"/></dmotion>)", "");
  files.Replace("scene.xml", "</scene>", R"(<part motion="continuous"><filter type="objloader">
<param key="efilepath" value="plate_\d+\.obj"/></filter><filter type="frames">
<param key="framesPerSecond" value="4"/></filter><filter type="translate">
<param key="offset" value="20;0;0"/></filter></part></scene>)");
  for (const double time : { 0.2, 0.9 })
  {
    files.Options.StartTime = time;
    Viewer viewer(files.Options);
    REQUIRE(viewer.Run() == 0);
    vtkPolyData* mesh = viewer.GetSceneView()->GetMovingMesh();
    REQUIRE(mesh);
    const double shown = viewer.GetClock().GetTime();
    CHECK(shown == Approx(time));
    CHECK(mesh->GetNumberOfPoints() == 8);
    CHECK(CountCorners(mesh, 0.0, FramesPerSecond * (shown + 0.1)) == 4);
    CHECK(CountCorners(mesh, 20.0, FramesPerSecond * shown) == 4);
  }
}

TEST_CASE("SceneMover: a scene at rest is not modified")
{
  StepFiles files;
  ViewerOptions options;
  options.Inputs = { (files.Folder / "survey.xml").string() };
  options.Offscreen = true;
  options.Still = (files.Folder / "still.png").string();
  Viewer viewer(options);
  REQUIRE(viewer.Run() == 0);
  CHECK_FALSE(viewer.GetSceneView()->GetMovingMesh());
  SceneMover mover(viewer.GetSurvey()->GetData(), viewer.GetSceneView()->GetScene());
  mover.SetView(*viewer.GetSceneView());
  double bounds[6];
  CHECK_FALSE(mover.GetBounds(viewer.GetLegs().front(), bounds));
  CHECK_FALSE(mover.MoveTo(viewer.GetLegs(), 0.5));
}
