// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of echoes.
#include "heliosMaterialTable.h"
#include "heliosScannerBench.h"
#include "heliosTexture.h"
#include "vtkHeliosMemoryLimit.h"
#include "vtkHeliosScene.h"

#include <vtkBMPWriter.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkJPEGWriter.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace helios::testing;
using helios::Rgb;
namespace names = vtkHeliosArrayNames;

namespace
{

class TextureFolder
{
public:
  TextureFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "vtkHeliosTextureXXXXXX").string();
    this->Path = ::mkdtemp(name.data());
  }
  ~TextureFolder() { std::filesystem::remove_all(this->Path); }

  std::string GetPath(const std::string& name) const { return (this->Path / name).string(); }

private:
  std::filesystem::path Path;
};

/// An image of bytes: a function of column, row (from the lowest) and component.
template <typename ValueT>
vtkSmartPointer<vtkImageData> MakeImage(int width, int height, int components, ValueT value)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, value(x, y, c));
      }
    }
  }
  return image;
}

template <typename WriterT>
void WriteImage(const std::string& path, vtkImageData* image)
{
  vtkNew<WriterT> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

} // namespace

TEST_CASE("ScannerColors: a texture is bilinear, and repeats")
{
  TextureFolder folder;
  const std::string path = folder.GetPath("ramp.png");
  const auto value = [](int x, int y, int c) { return c == 0 ? 60 * x : c == 1 ? 100 * y : 255; };
  WriteImage<vtkPNGWriter>(path, MakeImage(4, 2, 3, value));
  helios::Texture texture;
  REQUIRE(texture.Read(path).IsOk());
  const auto is = [&texture](double u, double v, double red, double green)
  {
    const Rgb color = texture.Get(u, v);
    CHECK(255.0 * color[0] == Approx(red).margin(1e-9));
    CHECK(255.0 * color[1] == Approx(green).margin(1e-9));
    CHECK(color[2] == Approx(1.0));
  };
  is(0.5 / 4, 0.5 / 2, 0, 0);          // the centre of the lower left pixel
  is(3.5 / 4, 1.5 / 2, 180, 100);      // centre of the upper right one
  is(1.0 / 4, 0.5 / 2, 30, 0);         // between two
  is(2.0 / 4, 1.0 / 2, 90, 50);        // between four
  is(0.0, 0.25, 90, 0);                // mean of the left edge and the right one
  is(0.625 - 3.0, 0.25 + 7.0, 120, 0); // repeats
}

TEST_CASE("ScannerColors: images of other kinds, and those that are none")
{
  TextureFolder folder;
  helios::Texture texture;
  WriteImage<vtkPNGWriter>(
    folder.GetPath("grey.png"), MakeImage(2, 2, 1, [](int, int, int) { return 51; }));
  REQUIRE(texture.Read(folder.GetPath("grey.png")).IsOk());
  CHECK(texture.Get(0.3, 0.4)[2] == Approx(0.2));
  WriteImage<vtkPNGWriter>(folder.GetPath("alpha.png"),
    MakeImage(2, 2, 4, [](int, int, int c) { return c == 3 ? 7 : 102; }));
  REQUIRE(texture.Read(folder.GetPath("alpha.png")).IsOk());
  CHECK(texture.Get(0.3, 0.4)[2] == Approx(0.4));
  WriteImage<vtkBMPWriter>(
    folder.GetPath("a.bmp"), MakeImage(4, 4, 3, [](int, int, int c) { return c == 0 ? 255 : 0; }));
  REQUIRE(texture.Read(folder.GetPath("a.bmp")).IsOk());
  CHECK(texture.Get(0.5, 0.5) == Rgb{ 1.0, 0.0, 0.0 });
  WriteImage<vtkJPEGWriter>(
    folder.GetPath("a.jpg"), MakeImage(16, 16, 3, [](int, int, int) { return 128; }));
  REQUIRE(texture.Read(folder.GetPath("a.jpg")).IsOk());
  CHECK(texture.Get(0.5, 0.5)[1] == Approx(128.0 / 255.0).margin(0.02));

  const std::string text = folder.GetPath("text.png");
  std::ofstream(text) << "no image";
  CHECK(texture.Read(text).Message() ==
    "texture " + text +
      " is no image that is read; give PNG, JPEG, TIFF, BMP or PNM, or remove map_Kd");
  CHECK(texture.Read(folder.GetPath("none.png")).Message() ==
    "texture " + folder.GetPath("none.png") + " does not exist; give it, or remove map_Kd");
  const std::string place = folder.GetPath("");
  CHECK(texture.Read(place).Message() ==
    "texture " + place +
      ": cannot be read: it is a folder; give the name of a file, or remove map_Kd");
}

namespace
{

/// A wall across y, 10 m away, of one material.
vtkSmartPointer<vtkPolyData> MakeColoredWall(const helios::MaterialColor& color)
{
  const auto scene = MakeScene({ Wall(10.0) });
  helios::Material material;
  material.Color = color;
  helios::SetMaterials(scene, { material });
  return scene;
}

/// The texture coordinates of the triangles: x (or another axis) and z [m], over a width.
void AddCoordinates(vtkPolyData* mesh, double width, int axis = 0)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName(names::TextureCoordinates);
  coordinates->SetNumberOfComponents(6);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const double* p = mesh->GetPoint(mesh->GetCell(cell)->GetPointId(corner));
      coordinates->InsertNextValue(static_cast<float>(p[axis] / width));
      coordinates->InsertNextValue(static_cast<float>(p[2] / width));
    }
  }
  mesh->GetCellData()->AddArray(coordinates);
}

Rgb GetColor(vtkPolyData* cloud, vtkIdType row)
{
  Rgb color{ -1.0, -1.0, -1.0 };
  if (vtkDataArray* colors = cloud->GetPointData()->GetArray(names::RGB))
  {
    colors->GetTuple(row, color.data());
  }
  return color;
}

} // namespace

TEST_CASE("ScannerColors: echoes have the colour of their material, if asked")
{
  Bench bench(MakeColoredWall({ { 0.25, 0.5, 1.0 }, "" }));
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::RGB));
  bench.Scanner->GenerateColorsOn();
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() > 0);
  CHECK(GetColor(cloud, 0) == Rgb{ 0.25, 0.5, 1.0 });
}

TEST_CASE("ScannerColors: triangles with colours of their own keep them")
{
  const auto scene = MakeColoredWall({ { 0.25, 0.5, 1.0 }, "" });
  const bool areBytes = GENERATE(false, true);
  vtkNew<vtkFloatArray> real;
  vtkNew<vtkUnsignedCharArray> bytes;
  vtkDataArray* colors = areBytes ? static_cast<vtkDataArray*>(bytes.Get()) : real.Get();
  colors->SetName(names::RGB);
  colors->SetNumberOfComponents(3);
  const double full = areBytes ? 255.0 : 1.0;
  for (vtkIdType cell = 0; cell < scene->GetNumberOfCells(); ++cell)
  {
    colors->InsertNextTuple3(0.2 * full, 0.4 * full, 0.6 * full);
  }
  scene->GetCellData()->AddArray(colors);
  Bench bench(scene);
  bench.Scanner->GenerateColorsOn();
  const Rgb color = GetColor(bench.Run(), 0);
  CHECK(color[0] == Approx(0.2));
  CHECK(color[1] == Approx(0.4));
  CHECK(color[2] == Approx(0.6));
}

namespace
{

/// An image of 64 x 64 pixels on 64 m: red grows by 4 with x, green with z.
std::string WriteRamp(const TextureFolder& folder)
{
  const auto value = [](int x, int y, int c) { return c == 0 ? 4 * x : c == 1 ? 4 * y : 255; };
  WriteImage<vtkPNGWriter>(folder.GetPath("ramp.png"), MakeImage(64, 64, 3, value));
  return folder.GetPath("ramp.png");
}

/// The mesh as a prototype at one place.
vtkSmartPointer<vtkPolyData> MakeInstance(vtkPolyData* mesh, const helios::Vec3& place)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->AddPrototype(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(place.GetData());
  vtkNew<vtkIntArray> prototypes;
  prototypes->SetName(names::PrototypeIds);
  prototypes->InsertNextValue(0);
  vtkNew<vtkPolyData> instances;
  instances->SetPoints(points);
  instances->GetPointData()->AddArray(prototypes);
  scene->SetInstances(instances);
  helios::SetMaterials(scene, helios::GetMaterials(mesh));
  return scene;
}

/// Checks the colour of the ramp at a place, times (1, 0.5, 1).
void CheckRamp(const Rgb& color, double x, double z)
{
  CHECK(color[0] == Approx(4.0 * (x - 0.5) / 255.0).margin(1e-6));
  CHECK(color[1] == Approx(0.5 * 4.0 * (z - 0.5) / 255.0).margin(1e-6));
  CHECK(color[2] == Approx(1.0));
}

} // namespace

TEST_CASE("ScannerColors: a texture is sampled where the echo is")
{
  TextureFolder folder;
  const auto wall = MakeColoredWall({ { 1.0, 0.5, 1.0 }, WriteRamp(folder) });
  AddCoordinates(wall, 64.0);
  const bool isInstance = GENERATE(false, true);
  Bench bench(isInstance ? MakeInstance(wall, { -3.0, 0.0, -4.0 }) : wall, { 20.0, 0.0, 15.0 });
  bench.Scanner->GenerateColorsOn();
  bench.Scanner->SetRangeAccuracy(0.5); // the surface gives the colour
  vtkPolyData* cloud = bench.Run();
  CHECK(bench.Log->Warnings.empty());
  REQUIRE(cloud->GetNumberOfPoints() == 1000);
  for (const vtkIdType row : { 0, 500, 999 })
  {
    CheckRamp(GetColor(cloud, row), isInstance ? 23.0 : 20.0, isInstance ? 19.0 : 15.0);
  }
}

TEST_CASE("ScannerColors: colours of points are interpolated")
{
  const auto wall = MakeScene({ Wall(10.0) }); // corners at x, z = -50 and 50
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(names::RGB);
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < wall->GetNumberOfPoints(); ++i)
  {
    const double* p = wall->GetPoint(i);
    colors->InsertNextTuple3(p[0] > 0.0 ? 255 : 0, p[2] > 0.0 ? 102 : 0, 51);
  }
  wall->GetPointData()->AddArray(colors);
  Bench bench(wall, { 20.0, 0.0, -15.0 });
  bench.Scanner->GenerateColorsOn();
  const Rgb color = GetColor(bench.Run(), 0);
  CHECK(color[0] == Approx(0.7).margin(1e-5));
  CHECK(color[1] == Approx(0.4 * 0.35).margin(1e-5));
  CHECK(color[2] == Approx(0.2).margin(1e-6));
}

TEST_CASE("ScannerColors: a ghost has the colour of the surface behind the mirror")
{
  TextureFolder folder;
  // A mirror at 45 degrees sends the beam at (20, 10, 15) along x, to a wall at x = 25.
  const auto scene = MakeScene(
    { { { 19, 9, 10 }, { 2, 2, 0 }, { 0, 0, 10 } }, { { 25, 0, 0 }, { 0, 50, 0 }, { 0, 0, 50 } } });
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (const int id : { 0, 0, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  scene->GetCellData()->AddArray(ids);
  helios::Material mirror;
  mirror.Optics.Kind = helios::OpticsKind::Mirror;
  helios::Material painted;
  painted.Color = { { 1.0, 0.5, 1.0 }, WriteRamp(folder) };
  helios::SetMaterials(scene, { mirror, painted });
  AddCoordinates(scene, 64.0, 1);
  Bench bench(scene, { 20.0, 0.0, 15.0 });
  bench.Scanner->GenerateColorsOn();
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() > 0);
  const Rgb color = GetColor(cloud, 0);
  CHECK(color[0] == Approx(4.0 * (10.0 - 0.5) / 255.0).margin(1e-3)); // gradient of y
  CHECK(color[1] == Approx(0.5 * 4.0 * (15.0 - 0.5) / 255.0).margin(1e-3));
}

TEST_CASE("ScannerColors: a texture that cannot be read is an error, not another colour")
{
  const auto wall = MakeColoredWall({ { 0.25, 0.5, 1.0 }, "/none/brick.png" });
  AddCoordinates(wall, 64.0);
  Bench bench(wall);
  bench.Scanner->GenerateColorsOn();
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
  CHECK(bench.Log->HasError("texture /none/brick.png does not exist; give it, or remove map_Kd"));
}

namespace
{

/// Loads the textures of a scene, and checks the result.
void CheckLoad(helios::TextureStore& store, vtkPolyData* scene, const std::string& fault)
{
  std::vector<std::string> warnings;
  CHECK(store.Load({ scene }, warnings).Message() == fault);
  CHECK(warnings.empty());
}

} // namespace

TEST_CASE("ScannerColors: textures are read once, by all scanners of a scene")
{
  TextureFolder folder;
  const std::string path = WriteRamp(folder);
  const auto wall = MakeColoredWall({ { 1.0, 0.5, 1.0 }, path });
  AddCoordinates(wall, 64.0);
  const auto store = std::make_shared<helios::TextureStore>();
  CheckLoad(*store, wall, "");
  const auto texture = store->Find(path);
  REQUIRE(texture != nullptr);
  CHECK(store->Find("none") == nullptr);
  std::filesystem::remove(path);
  CheckLoad(*store, wall, "");
  CHECK(store->Find(path) == texture);
  for (int scanner = 0; scanner < 2; ++scanner)
  {
    Bench bench(wall, { 20.0, 0.0, 15.0 });
    bench.Scanner->GenerateColorsOn();
    bench.Scanner->SetTextures(store);
    CheckRamp(GetColor(bench.Run(), 0), 20.0, 15.0);
    bench.Scanner->SetTextures(nullptr); // its own
    bench.Run();
    CHECK(bench.Log->HasError("texture " + path + " does not exist"));
  }
}

TEST_CASE("ScannerColors: textures are read again once the scene changes")
{
  TextureFolder folder;
  const std::string path = folder.GetPath("a.png");
  const auto write = [&path](int grey)
  { WriteImage<vtkPNGWriter>(path, MakeImage(2, 2, 1, [grey](int, int, int) { return grey; })); };
  write(51);
  const auto wall = MakeColoredWall({ { 1.0, 1.0, 1.0 }, path });
  AddCoordinates(wall, 64.0);
  Bench bench(wall);
  bench.Scanner->GenerateColorsOn();
  CHECK(GetColor(bench.Run(), 0)[0] == Approx(0.2));
  write(102);
  bench.Scanner->Modified();
  CHECK(GetColor(bench.Run(), 0)[0] == Approx(0.2));
  wall->Modified();
  CHECK(GetColor(bench.Run(), 0)[0] == Approx(0.4));
}

TEST_CASE("ScannerColors: the memory of all textures together is checked")
{
  TextureFolder folder;
  const std::string first = folder.GetPath("a.png");
  const std::string second = folder.GetPath("b.png");
  const auto image = MakeImage(3000, 1000, 3, [](int, int, int) { return 7; });
  WriteImage<vtkPNGWriter>(first, image);
  WriteImage<vtkPNGWriter>(second, image);
  const auto scene = MakeScene({ Wall(10.0) });
  helios::Material materials[2];
  materials[0].Color = { { 1.0, 1.0, 1.0 }, first };
  materials[1].Color = { { 1.0, 1.0, 1.0 }, second };
  helios::SetMaterials(scene, { materials[0], materials[1] });
  vtkHeliosMemoryLimit::SetLimit(vtkHeliosMemoryLimit::GetUsed() + 14.0); // one has 9 MB
  helios::TextureStore store;
  std::vector<std::string> warnings;
  const helios::Status status = store.Load({ scene }, warnings);
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(status.Message().find(first +
          " and others: 6000000 pixels of 2 textures need about 18 MB of memory, and ") == 0);
}

TEST_CASE("ScannerColors: a scene without colours gives black, with a warning")
{
  Bench bench(MakeScene({ Wall(10.0) }));
  bench.Scanner->GenerateColorsOn();
  CHECK(GetColor(bench.Run(), 0) == Rgb{ 0.0, 0.0, 0.0 });
  CHECK(bench.Log->HasWarning("the scene has no colours"));
}
