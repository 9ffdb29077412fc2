// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosModelFile.h"

#include "heliosErrorText.h"
#include "heliosMaterialColors.h"
#include "heliosMaterialTable.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosObjSceneReader.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <filesystem>

namespace helios::viewer
{

namespace
{

constexpr const char* Instead = "; a simple model is shown instead";

/// Suppresses warnings: material entries for scenes do not describe a picture.
void Silence(vtkObject* reader)
{
  vtkNew<vtkCallbackCommand> nobody;
  nobody->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::WarningEvent, nobody);
}

/// Colours cells; one material has the default colour.
void ColorCells(vtkPolyData* model)
{
  const MaterialTable materials = GetMaterials(model);
  vtkDataArray* rows = model->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds);
  if (materials.size() < 2 || !rows)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(model->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < model->GetNumberOfCells(); ++cell)
  {
    const auto row = static_cast<std::size_t>(rows->GetComponent(cell, 0));
    const Rgb color = GetMaterialColor(materials[std::min(row, materials.size() - 1)], row);
    std::copy(color.begin(), color.end(), colors->GetPointer(3 * cell));
  }
  model->GetCellData()->SetScalars(colors);
}

Status Read(const std::string& file, vtkSmartPointer<vtkPolyData>& model)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".obj")
  {
    return Status::Error(file + " is not an OBJ file; convert it");
  }
  vtkNew<vtkHeliosObjSceneReader> reader;
  const ErrorText errors(reader);
  Silence(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (!errors.IsEmpty() || reader->GetOutput()->GetNumberOfCells() == 0)
  {
    return Status::Error(errors.Get(file + " has no faces"));
  }
  model = reader->GetOutput();
  ColorCells(model);
  return {};
}

} // namespace

//------------------------------------------------------------------------------
const ModelFiles::Entry& ModelFiles::Get(const ModelData& model)
{
  const auto known = this->Known.find(model.Where + model.File);
  if (known != this->Known.end())
  {
    return known->second;
  }
  Entry& entry = this->Known[model.Where + model.File];
  if (!model.Name.empty())
  {
    entry.Problem = model.File.empty()
      ? "no such file; correct the name, or give its folder with --assets"
      : Read(model.File, entry.Model).Message();
  }
  if (!entry.Problem.empty())
  {
    entry.Problem = model.Where + ": " + entry.Problem + Instead;
  }
  return entry;
}

//------------------------------------------------------------------------------
vtkPolyData* ModelFiles::Find(const ModelData& model)
{
  return this->Get(model).Model;
}

//------------------------------------------------------------------------------
std::string ModelFiles::GetProblem(const ModelData& model)
{
  return this->Get(model).Problem;
}

} // namespace helios::viewer
