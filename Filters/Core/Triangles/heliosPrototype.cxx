// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPrototype.h"

#include "heliosHeightCache.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

namespace helios
{

//------------------------------------------------------------------------------
Status Prototype::Set(vtkDataSet* data)
{
  *this = Prototype();
  this->Data = data;
  if (auto* raster = vtkImageData::SafeDownCast(data))
  {
    const Status status = GetHeightField(raster, this->Field);
    this->Field->GetBounds(this->Bounds);
    return status;
  }
  const Status status = this->Mesh.Set(vtkPolyData::SafeDownCast(data));
  if (status.IsOk())
  {
    this->Mesh.GetBounds(this->Bounds);
  }
  return status;
}

} // namespace helios
