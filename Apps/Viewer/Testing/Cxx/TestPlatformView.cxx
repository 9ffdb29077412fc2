// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Platforms and scanners drawn from model files: known squares at known pixels.
#include "heliosPlatformView.h"

#include "heliosMaterialColors.h"
#include "heliosStepFiles.h"
#include "heliosViewer.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <vtkPolyData.h>

#include <cstdlib>

using namespace helios;
using namespace helios::viewer;

namespace
{

/// A square of 2 m centred at (x, y), at a height.
std::string MakeSquare(double x, double y, double z)
{
  std::string text;
  for (const auto& corner : { Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0) })
  {
    text += "v " + std::to_string(x + corner[0]) + " " + std::to_string(y + corner[1]) + " " +
      std::to_string(z) + "\n";
  }
  return text;
}

ModelData MakeModel(const StepFiles& files, const std::string& name)
{
  const std::string path = (files.Folder / name).string();
  const bool isThere = std::filesystem::exists(path);
  return { name, "assets.xml:2: model=\"" + name + "\"", isThere ? path : "" };
}

bool IsNear(const Rgb& a, const Rgb& b)
{
  return std::abs(a[0] - b[0]) <= 2 && std::abs(a[1] - b[1]) <= 2 && std::abs(a[2] - b[2]) <= 2;
}

/// A folder with a body of roof at x = 3 m and glass at y = 6 m, and a separate head at y = 2 m.
class ModelStage : public StepFiles
{
public:
  ModelStage()
  {
    this->Write("body.mtl", "newmtl roof\nnewmtl glass\n");
    this->Write("body.obj",
      "mtllib body.mtl\n" + MakeSquare(3, 0, 0) + MakeSquare(0, 6, 0) +
        "usemtl roof\nf 1 2 3 4\nusemtl glass\nf 5 6 7 8\n");
    this->Write("head.obj", MakeSquare(0, 2, 0) + "f 1 2 3 4\n");
    this->Leg.Model = MakeModel(*this, "body.obj");
    this->Leg.ScannerModel = MakeModel(*this, "head.obj");
    this->Leg.Mount.Position = Vec3(-4, 0, 0);
    this->Leg.EndTime = 10.0;
  }

  void Show(const Pose& platform, double time)
  {
    static_cast<void>(this->View.ReadModels({ this->Leg }));
    this->View.Place(this->Leg, platform, time);
    this->Picture.Render();
  }

  Stage Picture;
  SimulatedLeg Leg;
  PlatformView View{ this->Picture.Renderer, Vec3(0, 0, 0) };
};

const Quaternion Level(1.0, 0.0, 0.0, 0.0);
const Vec3 Up(0.0, 0.0, 1.0);
constexpr Rgb Roof = { 176, 88, 70 };
constexpr Rgb Glass = { 128, 164, 188 };

} // namespace

TEST_CASE("PlatformView: a platform is drawn from its model file, in its own frame")
{
  ModelStage stage;
  stage.Show({ Vec3(0, 0, 0), Level }, 0.0);
  CHECK(IsNear(stage.Picture.GetColorAt(3, 0), Roof));
  CHECK(IsNear(stage.Picture.GetColorAt(0, 6), Glass));
  CHECK(stage.Picture.GetColorAt(-4, 2) != Black); // the head, on its mount
  CHECK(stage.Picture.GetColorAt(0, 0) == Black);
  CHECK(stage.Picture.CountPixels(Black) == 200 * 200 - 3 * 20 * 20);

  stage.Show({ Vec3(1, -2, 0), AxisAngle(Up, 90.0) }, 0.0); // forward is then west
  CHECK(IsNear(stage.Picture.GetColorAt(1, 1), Roof));
  CHECK(IsNear(stage.Picture.GetColorAt(-5, -2), Glass));
  CHECK(stage.Picture.GetColorAt(-1, -6) != Black);
  CHECK(stage.Picture.GetColorAt(3, 0) == Black);
}

TEST_CASE("PlatformView: the scanner model rotates with the head")
{
  ModelStage stage;
  stage.Leg.HeadStart = 90.0;
  stage.Leg.HeadSpeed = 9.0;
  stage.Show({ Vec3(0, 0, 0), Level }, 0.0);
  CHECK(stage.Picture.GetColorAt(-6, 0) != Black); // 90 degrees to the left
  stage.Show({ Vec3(0, 0, 0), Level }, 10.0);
  CHECK(stage.Picture.GetColorAt(-4, -2) != Black); // 180
  CHECK(stage.Picture.GetColorAt(-6, 0) == Black);
  stage.Show({ Vec3(0, 0, 0), Level }, 99.0); // stops at the end of the leg
  CHECK(stage.Picture.GetColorAt(-4, -2) != Black);
}

TEST_CASE("PlatformView: a model that cannot be shown is reported and replaced by a simple one")
{
  ModelStage stage;
  stage.Write("bad.obj", "v 0 0\n");
  stage.Write("empty.obj", "v 0 0 0\n");
  stage.Write("plane.j3o", "");
  struct Case
  {
    const char* File;
    const char* Words;
  };
  const Case cases[] = { { "bad.obj", "bad.obj:1" }, { "empty.obj", "empty.obj has no faces" },
    { "none.obj", "no such file; correct the name, or give its folder with --assets" },
    { "plane.j3o", "plane.j3o is not an OBJ file; convert it" } };
  for (const Case& one : cases)
  {
    INFO(one.File);
    stage.Leg.Model = MakeModel(stage, one.File);
    stage.Leg.ScannerModel = ModelData();
    const std::string problem = stage.View.ReadModels({ stage.Leg, stage.Leg }).Message();
    INFO(problem);
    CHECK(problem.find("assets.xml:2: model=\"" + std::string(one.File) + "\": ") == 0);
    CHECK(problem.find(one.Words) != std::string::npos);
    CHECK(problem.find("; a simple model is shown instead") != std::string::npos);
    CHECK(problem.find('\n') == std::string::npos); // once for two legs
    stage.Show({ Vec3(0, 0, 0), Level }, 0.0);
    CHECK(stage.Picture.CountPixels(Black) < 200 * 200); // a tripod
    CHECK(stage.Picture.GetColorAt(3, 0) == Black);
  }
}

TEST_CASE("PlatformView: a small model is enlarged to be visible, and each file is read once")
{
  ModelStage stage;
  stage.Write("small.obj", "v 0 0 0\nv 0.01 0 0\nv 0.01 0.01 0\nv 0 0.01 0\nf 1 2 3 4\n");
  stage.Leg.Model = MakeModel(stage, "small.obj");
  stage.Leg.Mount.Position = Vec3(0, 0, 0);
  stage.Leg.ScannerModel = ModelData{ "n", "n", "" };
  stage.Show({ Vec3(0, 0, 0), Level }, 0.0);
  CHECK(stage.Picture.GetColorAt(0.7, 0.7) != Black); // 4 % of 20 m
  std::filesystem::remove(stage.Folder / "small.obj");
  ModelFiles files;
  CHECK_FALSE(files.Find(stage.Leg.Model));
  CHECK(stage.View.ReadModels({ stage.Leg }).Message().find("small.obj") == std::string::npos);
}

TEST_CASE("PlatformView: the viewer shows the model of a survey, or reports why not")
{
  StepFiles files;
  files.Write("plane.obj", MakeSquare(0, 0, 0) + "f 1 2 3 4\n");
  const bool isGood = GENERATE(true, false);
  files.Replace("assets.xml", "type=\"linearpath\"",
    std::string("type=\"linearpath\" visModel=\"") + (isGood ? "plane" : "jet") + ".obj\"");
  ViewerOptions options;
  options.Inputs = { (files.Folder / "survey.xml").string() };
  options.Offscreen = true;
  options.Still = (files.Folder / "still.png").string();
  options.State = (files.Folder / "state.json").string();
  Viewer viewer(options);
  REQUIRE(viewer.Run() == 0);
  REQUIRE(viewer.GetLegs().size() == 1);
  CHECK(
    viewer.GetLegs().front().Model.File == (isGood ? (files.Folder / "plane.obj").string() : ""));
  std::ifstream state(options.State);
  const std::string said((std::istreambuf_iterator<char>(state)), std::istreambuf_iterator<char>());
  CHECK((said.find("a simple model is shown instead") == std::string::npos) == isGood);
}
