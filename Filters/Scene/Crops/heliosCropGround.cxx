// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCropGround.h"

#include "heliosMeshBuilder.h"
#include "heliosSyntheticMaterials.h"
#include "heliosSyntheticTerrain.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{
constexpr double ClodPeriod = 4.0; // [m]; the longest wave of Terrain is 0.8 times its Size
}

CropGround::CropGround(
  double width, double length, double spacing, double roughness, vtkIdType seed)
  : Size{ width, length }
  , Cells{ 1, 1 }
{
  if (roughness <= 0.0)
  {
    return;
  }
  for (int k = 0; k < 2; ++k)
  {
    this->Cells[k] = std::max(1, static_cast<int>(std::ceil(this->Size[k] / spacing)));
  }
  const Terrain clods(ClodPeriod, roughness, seed);
  this->Heights.reserve((this->Cells[0] + std::size_t{ 1 }) * (this->Cells[1] + std::size_t{ 1 }));
  for (int j = 0; j <= this->Cells[1]; ++j)
  {
    for (int i = 0; i <= this->Cells[0]; ++i)
    {
      this->Heights.push_back(clods.GetHeight(this->GetX(i), this->GetY(j)));
    }
  }
  this->Highest = *std::max_element(this->Heights.begin(), this->Heights.end());
}

double CropGround::GetX(int i) const
{
  return this->Size[0] * (static_cast<double>(i) / this->Cells[0] - 0.5);
}

double CropGround::GetY(int j) const
{
  return this->Size[1] * (static_cast<double>(j) / this->Cells[1] - 0.5);
}

double CropGround::GetZ(int i, int j) const
{
  return this->Heights.empty()
    ? 0.0
    : this->Heights[j * (this->Cells[0] + std::size_t{ 1 }) + static_cast<std::size_t>(i)];
}

double CropGround::GetHeight(double x, double y) const
{
  if (this->Heights.empty())
  {
    return 0.0;
  }
  const double u = std::clamp(x / this->Size[0] + 0.5, 0.0, 1.0) * this->Cells[0];
  const double v = std::clamp(y / this->Size[1] + 0.5, 0.0, 1.0) * this->Cells[1];
  const int i = std::min(static_cast<int>(u), this->Cells[0] - 1);
  const int j = std::min(static_cast<int>(v), this->Cells[1] - 1);
  const double s = u - i;
  const double t = v - j;
  const double a = this->GetZ(i, j);
  const double c = this->GetZ(i + 1, j + 1);
  // The cell is split from its lower left to its upper right corner.
  return s > t ? a + (this->GetZ(i + 1, j) - a) * (s - t) + (c - a) * t
               : a + (this->GetZ(i, j + 1) - a) * (t - s) + (c - a) * s;
}

void CropGround::AddTo(MeshBuilder& mesh) const
{
  mesh.SetMaterial(synthetic::Soil());
  for (int j = 0; j <= this->Cells[1]; ++j)
  {
    for (int i = 0; i <= this->Cells[0]; ++i)
    {
      mesh.AddPoint({ this->GetX(i), this->GetY(j), this->GetZ(i, j) });
    }
  }
  for (int j = 0; j < this->Cells[1]; ++j)
  {
    for (int i = 0; i < this->Cells[0]; ++i)
    {
      const vtkTypeInt32 a = j * (this->Cells[0] + 1) + i;
      mesh.AddQuad(a, a + 1, a + this->Cells[0] + 2, a + this->Cells[0] + 1);
    }
  }
}

} // namespace helios
