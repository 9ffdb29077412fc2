// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneClassify.h"

#include "heliosMaterialTable.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkHeliosSceneClassify);

//------------------------------------------------------------------------------
int vtkHeliosSceneClassify::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
  helios::MaterialTable materials = helios::GetMaterials(output);
  for (helios::Material& material : materials)
  {
    material.Classification = this->Classification;
  }
  helios::SetMaterials(output, materials);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneClassify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Classification: " << this->Classification << '\n';
}
