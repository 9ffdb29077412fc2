// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Camera positions, for a platform of known positions.
#include "heliosCameraRig.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

using helios::Vec3;
using helios::viewer::CameraMode;
using helios::viewer::CameraRig;
using helios::viewer::GetCameraModeName;

namespace
{

struct Rig
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  CameraRig Camera{ Renderer };

  Rig()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(400, 200);
    this->Window->AddRenderer(this->Renderer);
    const double bounds[6] = { -50.0, 50.0, -20.0, 20.0, 0.0, 30.0 };
    this->Camera.SetBounds(bounds);
    this->Camera.Reset();
  }

  Vec3 Eye() const { return Vec3(this->Renderer->GetActiveCamera()->GetPosition()); }
  Vec3 Focus() const { return Vec3(this->Renderer->GetActiveCamera()->GetFocalPoint()); }
};

void CheckNear(const Vec3& a, const Vec3& b)
{
  CAPTURE(a[0], a[1], a[2], b[0], b[1], b[2]);
  CHECK((a - b).Norm() < 1e-9);
}

/// A temporary file of key frames.
struct Script
{
  std::string Name = (std::filesystem::temp_directory_path() / "vtkHeliosScriptXXXXXX").string();

  explicit Script(const std::string& text)
  {
    const int file = ::mkstemp(this->Name.data());
    REQUIRE(file >= 0);
    ::close(file);
    std::ofstream(this->Name) << text;
  }
  ~Script() { std::filesystem::remove(this->Name); }
};

} // namespace

TEST_CASE("CameraRig: top and side views show the whole cloud", "[Viewer]")
{
  Rig rig;
  vtkCamera* camera = rig.Renderer->GetActiveCamera();
  rig.Camera.SetMode(CameraMode::Top);
  CheckNear(rig.Focus(), Vec3(0.0, 0.0, 15.0));
  CHECK(rig.Eye()[2] > 30.0);
  CHECK(camera->GetParallelProjection());
  CHECK(camera->GetViewUp()[1] == 1.0);
  CHECK(2.0 * camera->GetParallelScale() * 2.0 >= 100.0); // twice as wide as high
  rig.Camera.SetMode(CameraMode::Side);
  CHECK(rig.Eye()[1] < -20.0);
  CHECK(camera->GetViewUp()[2] == 1.0);
  rig.Camera.SetMode(CameraMode::Free);
  CHECK_FALSE(camera->GetParallelProjection());
}

namespace
{

/// The box of points in the window, x0 x1 y0 y1 in fractions of its size.
std::vector<double> FindPicture(vtkRenderer* renderer, const std::vector<Vec3>& points)
{
  std::vector<double> box{ 1e9, -1e9, 1e9, -1e9 };
  for (const Vec3& p : points)
  {
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    const double x = renderer->GetDisplayPoint()[0] / renderer->GetSize()[0];
    const double y = renderer->GetDisplayPoint()[1] / renderer->GetSize()[1];
    box = { std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y) };
  }
  return box;
}

} // namespace

TEST_CASE("CameraRig: the first view fills the part of the window between the panels", "[Viewer]")
{
  Rig rig;
  const std::vector<std::vector<Vec3>> clouds = {
    { { -50, -20, 0 }, { 50, -20, 0 }, { 50, 20, 30 }, { -50, 20, 5 } }, // wide
    { { 0, 0, 0 }, { 2, 0, 90 }, { 0, 3, 45 } },                         // high
    { { 1000, 1000, 0 }, { 1001, 1003, 0.5 } }                           // far from the centre
  };
  const double bottom = 0.05, top = 0.1;
  rig.Camera.SetMargins(bottom, top);
  for (const auto& points : clouds)
  {
    rig.Camera.SetPoints(points);
    for (const CameraMode mode : { CameraMode::Free, CameraMode::Top, CameraMode::Side })
    {
      rig.Camera.SetMode(mode);
      rig.Camera.Reset();
      const auto box = FindPicture(rig.Renderer, points);
      CAPTURE(points.size(), GetCameraModeName(mode), box[0], box[1], box[2], box[3]);
      const double width = box[1] - box[0], height = (box[3] - box[2]) / (1.0 - bottom - top);
      CHECK(std::max(width, height) == Approx(0.94).margin(0.01));
      CHECK(box[0] >= 0.0);
      CHECK(box[1] <= 1.0);
      CHECK(box[2] >= bottom);
      CHECK(box[3] <= 1.0 - top);
      CHECK(0.5 * (box[0] + box[1]) == Approx(0.5).margin(0.1)); // middle of the nearer corners
      CHECK(0.5 * (box[2] + box[3]) == Approx(0.5 * (bottom + 1.0 - top)).margin(0.1));
    }
  }
}

TEST_CASE("CameraRig: follow mode keeps the view angle that the user set", "[Viewer]")
{
  Rig rig;
  rig.Camera.SetMode(CameraMode::Follow);
  CameraRig::Subject subject;
  subject.Platform.Position = Vec3(0.0, 0.0, 40.0);
  rig.Camera.Update(0.04, &subject);
  CHECK(rig.Eye()[1] < 0.0); // behind: forward is y
  CHECK(rig.Eye()[2] > 40.0);
  rig.Renderer->GetActiveCamera()->Azimuth(30.0);
  const Vec3 eye = rig.Eye();
  const Vec3 focus = rig.Focus();
  subject.Platform.Position = Vec3(3.0, 7.0, 41.0);
  rig.Camera.Update(0.04, &subject);
  CheckNear(rig.Eye() - eye, Vec3(3.0, 7.0, 1.0));
  CheckNear(rig.Focus() - focus, Vec3(3.0, 7.0, 1.0));
}

TEST_CASE("CameraRig: scanner view looks at the current echoes", "[Viewer]")
{
  Rig rig;
  rig.Camera.SetMode(CameraMode::Scanner);
  CameraRig::Subject subject;
  subject.Scanner.Position = Vec3(1.0, 2.0, 3.0);
  rig.Camera.Update(0.04, &subject);
  Vec3 ahead = rig.Focus() - rig.Eye();
  ahead.Normalize();
  CheckNear(rig.Eye(), Vec3(1.0, 2.0, 3.0));
  CheckNear(ahead, Vec3(0.0, 1.0, 0.0));
  subject.HasTarget = true;
  subject.Target = Vec3(1.0, 2.0, -97.0);
  for (int i = 0; i < 200; ++i)
  {
    rig.Camera.Update(0.04, &subject);
  }
  ahead = rig.Focus() - rig.Eye();
  ahead.Normalize();
  CHECK(ahead[2] < -0.999);
  CHECK(Vec3(rig.Renderer->GetActiveCamera()->GetViewUp())[1] > 0.99); // forward
}

TEST_CASE("CameraRig: orbit mode takes one minute per revolution", "[Viewer]")
{
  Rig rig;
  rig.Camera.SetMode(CameraMode::Orbit);
  const Vec3 eye = rig.Eye() - rig.Focus();
  rig.Camera.Update(30.0, nullptr);
  const Vec3 half = rig.Eye() - rig.Focus();
  CheckNear(half, Vec3(-eye[0], -eye[1], eye[2]));
  rig.Camera.Update(30.0, nullptr);
  CheckNear(rig.Eye() - rig.Focus(), eye);
}

TEST_CASE("CameraRig: key frames are in world coordinates", "[Viewer]")
{
  Rig rig;
  rig.Camera.SetOrigin(Vec3(500000.0, 5400000.0, 100.0));
  const Script script(R"([{"time": 0, "position": [500000, 5400000, 200],
 "focalPoint": [500000, 5400010, 100]},
 {"time": 10, "position": [500100, 5400000, 200], "focalPoint": [500100, 5400010, 100]}])");
  rig.Camera.SetMode(CameraMode::Script);
  CHECK(rig.Camera.ReadScript(script.Name).IsOk());
  rig.Camera.Update(10.0, nullptr);
  CheckNear(rig.Eye(), Vec3(100.0, 0.0, 100.0));
  CheckNear(rig.Focus(), Vec3(100.0, 10.0, 0.0));
}

TEST_CASE("CameraRig: bad key frames are errors", "[Viewer]")
{
  Rig rig;
  CHECK(rig.Camera.ReadScript("/none.json").Message().find("cannot be read") != std::string::npos);
  const auto read = [&rig](const char* text)
  { return rig.Camera.ReadScript(Script(text).Name).Message(); };
  CHECK(read("[{").find("is not JSON") != std::string::npos);
  CHECK(read("[]").find("has no key frames") != std::string::npos);
  CHECK(read("{}").find("has no key frames") != std::string::npos);
  CHECK(read(R"([{"time": 0, "position": [0, 0], "focalPoint": [0, 0, 0]}])")
          .find("key frame 0 is not") != std::string::npos);
  CHECK(read(R"([{"time": 0, "position": [0, 1e10, 0], "focalPoint": [0, 0, 0]}])")
          .find("with numbers within 1e9") != std::string::npos);
  const std::string deep(5000, '[');
  CHECK(read(deep.c_str()).find("is not JSON: Exceeded stackLimit") != std::string::npos);
}
