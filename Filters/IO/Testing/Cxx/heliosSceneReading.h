// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene file written for a test, and its reader with recorded messages.

#ifndef heliosSceneReading_h
#define heliosSceneReading_h

#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "heliosMutation.h"
#include "heliosPose.h"
#include "heliosTempFolder.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace helios
{

template <typename ReaderT>
struct SceneReading
{
  TempFolder Folder;
  std::string Path;
  vtkNew<ReaderT> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  SceneReading(const std::string& name, const std::string& bytes)
    : Path(this->Folder / name)
  {
    this->Log->Watch(this->Reader);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
    this->Reader->SetFileName(this->Path.c_str());
    this->Write(name, bytes);
  }

  std::string Write(const std::string& name, const std::string& bytes)
  {
    std::ofstream(this->Folder / name, std::ios::binary) << bytes;
    this->Reader->Modified();
    return this->Folder / name;
  }

  /// True if there was no error.
  bool Read()
  {
    this->Log->Clear();
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  vtkPolyData* Scene() { return this->Reader->GetOutput(); }
  vtkIdType Triangles() { return this->Scene()->GetNumberOfPolys(); }
  vtkIdType Points() { return this->Scene()->GetNumberOfPoints(); }

  Vec3 Corner(vtkIdType triangle, int corner)
  {
    TriangleMesh mesh;
    REQUIRE(mesh.Set(this->Scene()).IsOk());
    return Vec3(mesh.GetCorner(triangle, corner));
  }

  /// The sum of the areas of the triangles with a material, or of all [m2].
  double Area(const std::string& material = "")
  {
    TriangleMesh mesh;
    REQUIRE(mesh.Set(this->Scene()).IsOk());
    double area = 0.0;
    for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
    {
      const Vec3 a(mesh.GetCorner(i, 0));
      const Vec3 cross = (Vec3(mesh.GetCorner(i, 1)) - a).Cross(Vec3(mesh.GetCorner(i, 2)) - a);
      area += material.empty() || this->MaterialOf(i).Name == material ? 0.5 * cross.Norm() : 0.0;
    }
    return area;
  }

  /// The enclosed volume, positive if the triangles face outside [m3].
  double Volume()
  {
    TriangleMesh mesh;
    REQUIRE(mesh.Set(this->Scene()).IsOk());
    const Vec3 origin = this->Corner(0, 0);
    double volume = 0.0;
    for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
    {
      const Vec3 a = Vec3(mesh.GetCorner(i, 0)) - origin;
      const Vec3 b = Vec3(mesh.GetCorner(i, 1)) - origin;
      volume += a.Dot(b.Cross(Vec3(mesh.GetCorner(i, 2)) - origin)) / 6.0;
    }
    return volume;
  }

  Material MaterialOf(vtkIdType triangle)
  {
    vtkDataArray* ids = this->Scene()->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds);
    return GetMaterials(this->Scene()).at(static_cast<std::size_t>(ids->GetComponent(triangle, 0)));
  }

private:
  // The executive repeats every error with its own message.
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
};

/// A bad file, and the message after its path.
struct BadFile
{
  std::string Bytes;
  std::string Message;
};

template <typename ReaderT>
void CheckErrors(const std::string& name, const std::vector<BadFile>& cases)
{
  for (const BadFile& bad : cases)
  {
    SceneReading<ReaderT> reading(name, bad.Bytes);
    INFO(bad.Bytes << "\nexpected: " << bad.Message);
    CHECK_FALSE(reading.Read());
    INFO("said: " << reading.Log->Errors);
    CHECK(reading.Log->HasError(reading.Path + bad.Message));
    CHECK(reading.Points() == 0);
  }
}

/// Indices, material ids and points are valid; a scene may be empty, with a warning.
template <typename ReaderT>
void CheckScene(SceneReading<ReaderT>& reading)
{
  vtkDataArray* ids = reading.Scene()->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds);
  REQUIRE(ids->GetNumberOfTuples() == reading.Triangles());
  if (reading.Triangles() == 0)
  {
    REQUIRE(reading.Log->HasWarning("no triangles"));
    return;
  }
  TriangleMesh mesh;
  REQUIRE(mesh.Set(reading.Scene()).Message() == "");
  REQUIRE(ids->GetRange(0)[1] < static_cast<double>(GetMaterials(reading.Scene()).size()));
}

/// Damaged files give an error or a valid scene; both occur.
template <typename ReaderT>
void CheckMutations(const std::string& name, const std::vector<std::string>& good)
{
  const int count = GetNumberOfMutations();
  int scenes = 0;
  for (int seed = 0; seed < count; ++seed)
  {
    const std::string& bytes = good[static_cast<std::size_t>(seed) % good.size()];
    INFO("seed " << seed);
    SceneReading<ReaderT> reading(name, Mutator(static_cast<unsigned>(seed))(bytes));
    if (!reading.Read())
    {
      REQUIRE(reading.Points() == 0);
      continue;
    }
    ++scenes;
    CheckScene(reading);
  }
  CHECK(scenes > 0);
  CHECK(scenes < count);
}

} // namespace helios

#endif
