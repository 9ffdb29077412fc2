// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosObjSceneWriter.h"

#include "heliosMtlFile.h"
#include "heliosStatus.h"
#include "heliosTextFileSink.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkHeliosObjSceneWriter);

namespace
{
namespace names = vtkHeliosArrayNames;

// Makes every name a unique word; describes the changes as text.
std::string MakeNamesUnique(helios::MaterialTable& materials)
{
  std::set<std::string> taken;
  std::string first;
  int count = 0;
  for (helios::Material& m : materials)
  {
    std::string word = m.Name.empty() ? "material" : m.Name;
    std::replace_if(word.begin(), word.end(), helios::TextWords::IsBlank, '_');
    const std::string stem = word;
    for (int number = 2; !taken.insert(word).second; ++number)
    {
      word = stem + '_' + std::to_string(number);
    }
    if (word != m.Name && count++ == 0)
    {
      first = helios::Quote(m.Name) + " became " + helios::Quote(word);
    }
    m.Name = word;
  }
  return count == 0 ? first : std::to_string(count) + " materials were renamed: " + first;
}

// Returns the row of each cell, all 0 if the scene has none.
helios::Status GetRows(vtkPolyData* scene, std::size_t materialCount, std::vector<int>& rows)
{
  rows.assign(static_cast<std::size_t>(scene->GetNumberOfCells()), 0);
  vtkDataArray* ids = scene->GetCellData()->GetArray(names::MaterialIds);
  for (std::size_t i = 0; ids && i < rows.size(); ++i)
  {
    const double id = ids->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(id >= 0 && id < static_cast<double>(materialCount)))
    {
      return helios::Status::Error("cell " + std::to_string(i) + " of the scene has " +
        names::MaterialIds + ' ' + std::to_string(static_cast<int>(id)) + ", but there are " +
        std::to_string(materialCount) + " materials; correct the array or add the material");
    }
    rows[i] = static_cast<int>(id);
  }
  return {};
}

void AppendGeometry(const helios::TriangleMesh& mesh, const helios::MaterialTable& materials,
  const std::vector<int>& rows, helios::TextFileSink& sink)
{
  const double* p = mesh.GetPoints();
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i, p += 3)
  {
    sink.Append("v");
    std::for_each(p, p + 3, [&sink](double x) { sink.AppendNumber(x); });
    sink.Append("\n");
  }
  const vtkTypeInt32* corner = mesh.GetCorners();
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i, corner += 3)
  {
    if (i == 0 || rows[i] != rows[i - 1])
    {
      sink.Append("usemtl " + materials[rows[i]].Name + '\n');
    }
    sink.Append("f");
    std::for_each(corner, corner + 3, [&sink](vtkTypeInt32 id) { sink.AppendNumber(id + 1); });
    sink.Append("\n");
  }
}

} // namespace

vtkHeliosObjSceneWriter::vtkHeliosObjSceneWriter()
{
  this->SetNumberOfOutputPorts(0);
}

vtkHeliosObjSceneWriter::~vtkHeliosObjSceneWriter()
{
  this->SetFileName(nullptr);
}

int vtkHeliosObjSceneWriter::Write()
{
  this->IsWritten = false;
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the OBJ file with SetFileName");
  }
  else if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "no scene to write; give it with SetInputData or SetInputConnection");
  }
  else
  {
    this->Modified(); // write again, even if unchanged
    this->Update();
  }
  return this->IsWritten ? 1 : 0;
}

int vtkHeliosObjSceneWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  this->IsWritten = this->WriteFiles(vtkPolyData::GetData(inputVector[0]));
  return this->IsWritten ? 1 : 0;
}

bool vtkHeliosObjSceneWriter::WriteFiles(vtkPolyData* scene)
{
  helios::TriangleMesh mesh;
  helios::MaterialTable materials = helios::GetMaterials(scene);
  std::vector<int> rows;
  helios::Status status = mesh.Set(scene);
  status = status.IsOk() ? GetRows(scene, materials.size(), rows) : status;
  if (!status.IsOk())
  {
    vtkErrorMacro(<< this->FileName << ": not written: " << status.Message());
    return false;
  }

  const std::string renamed = MakeNamesUnique(materials);
  if (!renamed.empty())
  {
    vtkWarningMacro(<< this->FileName << ": " << renamed);
  }
  helios::TextReport report;
  std::string mtlText = "# written by vtkHelios\n";
  if (!helios::FormatMtl(materials, mtlText, report))
  {
    vtkErrorMacro(<< this->FileName << ": not written: " << report.Error);
    return false;
  }

  const std::filesystem::path mtlPath =
    std::filesystem::path(this->FileName).replace_extension(".mtl");
  if (mtlPath == this->FileName)
  {
    vtkErrorMacro(<< this->FileName << ": not written: .mtl is for the materials; use .obj");
    return false;
  }
  helios::TextFileSink mtl;
  helios::TextFileSink obj;
  status = mtl.Open(mtlPath.string());
  status = status.IsOk() ? obj.Open(this->FileName) : status;
  if (status.IsOk())
  {
    obj.Append("# written by vtkHelios\nmtllib " + mtlPath.filename().string() + '\n');
    AppendGeometry(mesh, materials, rows, obj);
    mtl.Append(mtlText);
    status = obj.Close();
    status = status.IsOk() ? mtl.Close() : status;
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
  }
  return status.IsOk();
}

void vtkHeliosObjSceneWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
