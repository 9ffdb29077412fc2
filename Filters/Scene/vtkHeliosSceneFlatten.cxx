// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneFlatten.h"

#include "heliosFlatScene.h"
#include "heliosSceneBounds.h"
#include "heliosStatus.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

vtkStandardNewMacro(vtkHeliosSceneFlatten);

//------------------------------------------------------------------------------
int vtkHeliosSceneFlatten::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkSmartPointer<vtkPolyData> mesh;
  const helios::Status status = helios::GetFlatScene(vtkPolyData::GetData(inputVector[0]), mesh);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkPolyData::GetData(outputVector)->ShallowCopy(mesh);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosSceneFlatten::ComputeBounds(vtkPolyData* scene, double bounds[6])
{
  const helios::Status status = helios::GetSceneBounds(scene, bounds);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
  }
  return status.IsOk();
}
