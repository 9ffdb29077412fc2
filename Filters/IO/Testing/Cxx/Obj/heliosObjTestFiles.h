// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A folder for test files, and a reader of an OBJ file in it.

#ifndef heliosObjTestFiles_h
#define heliosObjTestFiles_h

#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosObjSceneReader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace helios
{

/// A new folder, removed with its content at the end of the test.
class TestFolder
{
public:
  TestFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "vtkHeliosObjXXXXXX").string();
    this->Path = ::mkdtemp(name.data());
  }
  ~TestFolder() { std::filesystem::remove_all(this->Path); }

  std::string GetPath(const std::string& name) const { return (this->Path / name).string(); }

  std::string Write(const std::string& name, const std::string& text) const
  {
    std::filesystem::create_directories((this->Path / name).parent_path());
    std::ofstream(this->Path / name, std::ios::binary) << text;
    return this->GetPath(name);
  }

private:
  std::filesystem::path Path;
};

/// A reader with recorded messages.
struct ObjReading
{
  vtkNew<vtkHeliosObjSceneReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit ObjReading(const std::string& path)
  {
    this->Log->Watch(this->Reader);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
    this->Reader->SetFileName(path.c_str());
  }

  /// True if there was no error.
  bool Read()
  {
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  vtkPolyData* Scene() { return this->Reader->GetOutput(); }
  vtkIdType TriangleCount() { return this->Scene()->GetNumberOfPolys(); }

  std::vector<vtkIdType> Corners(vtkIdType cell)
  {
    vtkNew<vtkIdList> ids;
    this->Scene()->GetCellPoints(cell, ids);
    return { ids->begin(), ids->end() };
  }

  const Material MaterialOf(vtkIdType cell)
  {
    auto* ids = vtkIntArray::SafeDownCast(
      this->Scene()->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds));
    return GetMaterials(this->Scene()).at(static_cast<std::size_t>(ids->GetValue(cell)));
  }

private:
  // The executive repeats every error with its own message.
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
};

/// The vertices of a unit square, in lines 1 to 4.
inline const std::string ObjSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace helios

#endif
