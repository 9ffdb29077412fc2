// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Turbid voxels as boxes: positions, sizes, colours and number.
#include "heliosTurbidBoxes.h"

#include "heliosCloudView.h"
#include "heliosMaterialTable.h"
#include "heliosSceneView.h"
#include "heliosStepFiles.h"
#include "heliosViewer.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Opacity = 0.35;
constexpr double None = std::numeric_limits<double>::quiet_NaN();

/// Cells of an edge [m] with the lowest corner at a position, with densities.
vtkSmartPointer<vtkImageData> MakeGrid(
  const Vec3& corner, double edge, int nx, int ny, int nz, const std::vector<double>& densities)
{
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->SetDimensions(nx + 1, ny + 1, nz + 1);
  grid->SetSpacing(edge, edge, edge);
  grid->SetOrigin(corner[0], corner[1], corner[2]);
  vtkNew<vtkDoubleArray> pad;
  pad->SetName(names::PAD);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    pad->InsertNextValue(densities[static_cast<std::size_t>(i) % densities.size()]);
  }
  grid->GetCellData()->AddArray(pad);
  return grid;
}

/// A scene of one triangle far below, not visible.
vtkSmartPointer<vtkPolyData> MakeSpeck()
{
  auto scene = MakeEchoes({ { 0, 0, -50 }, { 0.001, 0, -50 }, { 0, 0.001, -50 } });
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  scene->SetPolys(cells);
  return scene;
}

bool IsNear(const Rgb& seen, const Rgb& color, double opacity)
{
  bool isNear = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    isNear = isNear && std::abs(seen[k] - opacity * color[k]) <= 3.0;
  }
  return isNear;
}

constexpr Rgb Leaf = { 84, 150, 76 };

} // namespace

TEST_CASE("TurbidBoxes: one box per voxel: volume by density, colour by material")
{
  Stage stage;
  SceneView view(stage.Renderer);
  const Vec3 far(500000.0, 5400000.0, 300.0);
  view.SetOrigin(far);
  REQUIRE(view.SetScene(MakeSpeck()).IsOk());
  auto grid = MakeGrid(far + Vec3(-8, -2, 0), 4.0, 4, 1, 1, { 0.8, 0.1, None, 0.0 });
  view.SetGrids({ grid });
  CHECK(view.GetNumberOfBoxes() == 2);
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(-6, 0), Leaf, Opacity)); // from -8 to -4
  CHECK(IsNear(stage.GetColorAt(-7.8, -1.8), Leaf, Opacity));
  CHECK(IsNear(stage.GetColorAt(-2.8, 0.8), Leaf, Opacity)); // an eighth: 2 m around -2
  CHECK(stage.GetColorAt(-3.3, 0) == Black);
  CHECK(stage.GetColorAt(2, 0) == Black); // unknown
  CHECK(stage.GetColorAt(6, 0) == Black); // empty
  CHECK(stage.CountPixels(Black) == 200 * 200 - 40 * 40 - 20 * 20);

  MaterialTable table(2);
  table[0].Classification = 6;
  table[1].Name = "bark";
  SetMaterials(grid, table);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (const int id : { 0, 1, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  grid->GetCellData()->AddArray(ids);
  view.SetGrids({ grid });
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(-6, 0), GetClassColor(6), Opacity));
  CHECK(IsNear(stage.GetColorAt(-2, 0), Rgb{ 120, 92, 66 }, Opacity));

  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
  view.SetVisible(true);
  view.SetOrigin(far + Vec3(0.0, 5.0, 0.0));
  stage.Render();
  CHECK(stage.GetColorAt(-6, 0) == Black);
  CHECK(stage.GetColorAt(-6, -5) != Black);
  view.SetGrids({});
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
}

TEST_CASE("TurbidBoxes: a rotated grid with any origin")
{
  Stage stage;
  SceneView view(stage.Renderer);
  REQUIRE(view.SetScene(MakeSpeck()).IsOk());
  vtkNew<vtkImageData> grid;
  grid->SetExtent(3, 5, 0, 1, 0, 1); // two cells from index 3
  grid->SetSpacing(2.0, 2.0, 2.0);
  const double turned[9] = { 0, -1, 0, 1, 0, 0, 0, 0, 1 }; // x maps to y
  grid->SetDirectionMatrix(turned);
  vtkNew<vtkDoubleArray> pad;
  pad->SetName(names::PAD);
  pad->InsertNextValue(0.5);
  pad->InsertNextValue(0.0);
  grid->GetCellData()->AddArray(pad);
  view.SetGrids({ grid.Get() });
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(-1, 7), Leaf, Opacity)); // x in [-2, 0], y in [6, 8]
  CHECK(IsNear(stage.GetColorAt(-1.8, 6.2), Leaf, Opacity));
  CHECK(stage.CountPixels(Black) == 200 * 200 - 20 * 20);
}

TEST_CASE("TurbidBoxes: a million voxels are merged to the maximum number of boxes")
{
  const auto grid = MakeGrid(Vec3(-5, -5, 0), 0.1, 100, 100, 100, { 0.5, 0.0 });
  const vtkIdType most = SceneView::MaximumBoxes;
  const auto boxes = MakeTurbidBoxes(grid, most, Vec3(0, 0, 0));
  const vtkIdType count = boxes->GetNumberOfCells() / 6;
  CHECK(count == 25 * 25 * 25); // 4 x 4 x 4 cells, the smallest below the limit
  CHECK(boxes->GetNumberOfPoints() == 8 * count);
  double bounds[6];
  boxes->GetPoints()->GetBounds(bounds);
  CHECK(bounds[0] == Approx(-5.0)); // equal, so they fill their blocks
  CHECK(bounds[5] == Approx(10.0));
  CHECK(MakeTurbidBoxes(grid, 1, Vec3(0, 0, 0))->GetNumberOfCells() == 6);
  Stage stage;
  SceneView view(stage.Renderer);
  REQUIRE(view.SetScene(MakeSpeck()).IsOk());
  view.SetGrids({ grid });
  CHECK(view.GetNumberOfBoxes() == count);
  view.SetInteracting(true);
  CHECK(view.GetNumberOfBoxes() <= SceneView::MaximumMovingBoxes);
  CHECK(view.GetNumberOfBoxes() > SceneView::MaximumMovingBoxes / 4);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200 - 100 * 99); // the last layer is empty
  view.SetInteracting(false);
  CHECK(view.GetNumberOfBoxes() == count);
  std::vector<vtkSmartPointer<vtkImageData>> two = { grid, grid };
  CHECK(MakeTurbidBoxes(two, most, Vec3(0, 0, 0))->GetNumberOfCells() / 6 <= most);
  const auto few = MakeGrid(Vec3(0, 0, 0), 1.0, 7, 3, 5, { 1.0 });
  CHECK(MakeTurbidBoxes(few, 105, Vec3(0, 0, 0))->GetNumberOfCells() / 6 == 105);
  const auto odd = MakeTurbidBoxes(few, 30, Vec3(0, 0, 0)); // 2 x 2 x 2, fewer at the ends
  CHECK(odd->GetNumberOfCells() / 6 == 4 * 2 * 3);
  odd->GetPoints()->GetBounds(bounds);
  CHECK(bounds[1] == Approx(7.0));
  CHECK(bounds[3] == Approx(3.0));
  vtkNew<vtkImageData> bare; // without densities
  CHECK(MakeTurbidBoxes(bare, 10, Vec3(0, 0, 0))->GetNumberOfCells() == 0);
}

TEST_CASE("TurbidBoxes: the viewer shows those of surveys and of scenes")
{
  StepFiles files;
  std::string text =
    "VOXEL SPACE\n#min_corner: -4 10 3\n#max_corner: 4 14 7\n#split: 2 1 1\n#res: 4\n"
    "i j k PadBVTotal\n0 0 0 1\n1 0 0 0.5\n";
  files.Write("tree.vox", text);
  files.Replace("scene.xml", "</scene>",
    "<part id=\"tree\"><filter type=\"detailedvoxels\"><param key=\"filepath\" value=\"tree.vox\"/>"
    "</filter></part></scene>");
  files.Write("platforms.xml",
    "<document><platform id=\"tripod\" type=\"static\"><scannerMount "
    "z=\"1.5\"/></platform></document>");
  files.Write("scanners.xml",
    "<document><scanner id=\"vz400_class_tls\" optics=\"rotating\" pulseFreqs_Hz=\"1000\" "
    "headRotatePerSecMax_deg=\"60\" scanAngleMax_deg=\"60\" scanAngleEffectiveMax_deg=\"50\" "
    "scanFreqMin_Hz=\"3\" scanFreqMax_Hz=\"120\"/></document>");
  ViewerOptions options;
  const std::string input = GENERATE("survey.xml", "scene.xml");
  CAPTURE(input);
  options.Inputs = { (files.Folder / input).string() };
  options.Assets = { files.Folder.string() };
  options.Offscreen = true;
  options.Still = (files.Folder / "still.png").string();
  options.State = (files.Folder / "state.json").string();
  options.Camera = "top";
  Viewer viewer(options);
  REQUIRE(viewer.Run() == 0);
  CHECK(viewer.GetSceneView()->GetNumberOfBoxes() == 2);
  CHECK(viewer.GetCloudView().GetEyeDomeLighting() == (input == "survey.xml")); // only for points
  std::ifstream state(options.State);
  const std::string said((std::istreambuf_iterator<char>(state)), std::istreambuf_iterator<char>());
  CHECK(said.find("\"voxels\" : 2") != std::string::npos);
}

TEST_CASE("Benchmark: a million voxels", "[.][benchmark]")
{
  Stage stage;
  stage.Window->SetSize(1280, 800);
  SceneView view(stage.Renderer);
  REQUIRE(view.SetScene(MakeSpeck()).IsOk());
  std::vector<double> densities;
  for (int i = 0; i < 1009; ++i)
  {
    densities.push_back(std::fmod(i * 0.754877, 1.0));
  }
  const auto grid = MakeGrid(Vec3(-5, -5, -5), 0.1, 100, 100, 100, densities);
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto start = now();
  view.SetGrids({ grid });
  const std::chrono::duration<double> made = now() - start;
  std::cout << "made in " << made.count() << " s" << std::endl;
  for (const bool isInteracting : { false, true })
  {
    view.SetInteracting(isInteracting);
    stage.Window->Render();
    const auto first = now();
    for (int i = 0; i < 10; ++i)
    {
      stage.Renderer->GetActiveCamera()->Azimuth(3.0);
      stage.Window->Render();
    }
    const std::chrono::duration<double> drawn = now() - first;
    std::cout << "boxes: " << view.GetNumberOfBoxes()
              << ", pictures a second: " << 10.0 / drawn.count() << std::endl;
  }
}
