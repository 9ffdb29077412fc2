// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A small pyramid on a steep base, in the middle of flat ground: few positions see it whole.

#ifndef heliosPyramidScene_h
#define heliosPyramidScene_h

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

namespace helios
{

/// Dimensions of the pyramid [m]; half widths, and heights above the ground.
struct Pyramid
{
  double Ground = 10.5;
  double Base = 2.5;
  double Shoulder = 1.75;
  double ShoulderHeight = 2.0;
  double ApexHeight = 2.4375;
};

/// 20 triangles: a ring of ground, a steep frustum, and a flat pyramid on top.
inline vtkSmartPointer<vtkPolyData> MakePyramidScene(const Pyramid& size = Pyramid())
{
  vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  vtkSmartPointer<vtkCellArray> polys = vtkSmartPointer<vtkCellArray>::New();
  const auto addSquare = [&points](double half, double z)
  {
    std::array<vtkIdType, 4> ids;
    const int signs[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    for (int i = 0; i < 4; ++i)
    {
      ids[i] = points->InsertNextPoint(signs[i][0] * half, signs[i][1] * half, z);
    }
    return ids;
  };
  const auto ground = addSquare(size.Ground, 0.0);
  const auto base = addSquare(size.Base, 0.0);
  const auto shoulder = addSquare(size.Shoulder, size.ShoulderHeight);
  const vtkIdType apex = points->InsertNextPoint(0.0, 0.0, size.ApexHeight);
  for (const auto& [outer, inner] :
    { std::make_pair(ground, base), std::make_pair(base, shoulder) })
  {
    for (int i = 0; i < 4; ++i)
    {
      const int j = (i + 1) % 4;
      polys->InsertNextCell({ outer[i], outer[j], inner[j] });
      polys->InsertNextCell({ outer[i], inner[j], inner[i] });
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    polys->InsertNextCell({ shoulder[i], shoulder[(i + 1) % 4], apex });
  }
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(polys);
  return scene;
}

} // namespace helios

#endif
