// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of instances in the frame of their prototype.

#ifndef heliosPrototype_h
#define heliosPrototype_h

#include "heliosHeightField.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace helios
{

/// The triangles of a mesh, or of a raster of heights.
class VTKHELIOSFILTERSCORE_EXPORT Prototype
{
public:
  /// Sets a mesh (vtkPolyData) or a raster (vtkImageData), and keeps a reference. Errors: see
  /// TriangleMesh and HeightField.
  Status Set(vtkDataSet* data);

  bool IsRaster() const { return this->Field != nullptr; }
  const TriangleMesh& GetMesh() const { return this->Mesh; }     ///< unless it is a raster
  const HeightField& GetHeights() const { return *this->Field; } ///< if it is a raster

  vtkIdType GetNumberOfTriangles() const
  {
    return this->IsRaster() ? this->Field->GetNumberOfTriangles()
                            : this->Mesh.GetNumberOfTriangles();
  }

  void GetCorners(vtkIdType triangle, double corners[3][3]) const
  {
    if (this->IsRaster())
    {
      this->Field->GetCorners(triangle, corners);
      return;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      std::copy_n(this->Mesh.GetCorner(triangle, corner), 3, corners[corner]);
    }
  }

  /// Returns the smallest and largest coordinates of the corners: x0 x1 y0 y1 z0 z1.
  void GetBounds(double bounds[6]) const { std::copy_n(this->Bounds, 6, bounds); }

  /// Bytes held by this object in addition to its data.
  std::size_t GetMemorySize() const
  {
    return this->Mesh.GetMemorySize() + (this->IsRaster() ? this->Field->GetMemorySize() : 0);
  }

private:
  vtkSmartPointer<vtkDataSet> Data;
  TriangleMesh Mesh;
  std::shared_ptr<const HeightField> Field; ///< null: a mesh
  double Bounds[6] = {};
};

} // namespace helios

#endif
