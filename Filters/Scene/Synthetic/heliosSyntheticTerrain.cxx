// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSyntheticTerrain.h"

#include "heliosMeshBuilder.h"
#include "heliosRandom.h"
#include "heliosSyntheticMaterials.h"

#include <vtkMath.h>

#include <cmath>
#include <cstdint>

namespace helios
{

Terrain::Terrain(double side, double relief, vtkIdType seed)
{
  constexpr double goldenAngle = 2.399963229728653; // spreads the directions of the waves
  constexpr double ratio = 0.62;                    // length of a wave relative to the previous one
  const auto key = static_cast<std::uint64_t>(seed);
  const double turn = 2.0 * vtkMath::Pi() * Uniform4(key, RandomStream::Scene, 0, 1)[0];
  double length = 0.8 * side;
  double amplitude = 1.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < this->Waves.size(); ++i)
  {
    const double k = 2.0 * vtkMath::Pi() / length;
    const double angle = turn + goldenAngle * static_cast<double>(i);
    const double phase = 2.0 * vtkMath::Pi() * Uniform4(key, RandomStream::Scene, i, 1)[1];
    this->Waves[i] = { k * std::cos(angle), k * std::sin(angle), phase, amplitude };
    sum += amplitude;
    length *= ratio;
    amplitude *= std::pow(ratio, 1.5); // shorter waves are less steep
  }
  for (Wave& wave : this->Waves)
  {
    wave.Amplitude *= 0.5 * relief / sum;
  }
}

double Terrain::GetHeight(double x, double y) const
{
  double height = 0.0;
  for (const Wave& wave : this->Waves)
  {
    height += wave.Amplitude * std::sin(wave.X * x + wave.Y * y + wave.Phase);
  }
  return height;
}

void AddTerrain(MeshBuilder& mesh, const Terrain& terrain, double side, int parts)
{
  mesh.SetMaterial(synthetic::Grass());
  const auto along = [side, parts](int i) { return side * (static_cast<double>(i) / parts - 0.5); };
  for (int j = 0; j <= parts; ++j)
  {
    for (int i = 0; i <= parts; ++i)
    {
      mesh.AddPoint({ along(i), along(j), terrain.GetHeight(along(i), along(j)) });
    }
  }
  for (int j = 0; j < parts; ++j)
  {
    for (int i = 0; i < parts; ++i)
    {
      const vtkTypeInt32 a = j * (parts + 1) + i;
      mesh.AddQuad(a, a + 1, a + parts + 2, a + parts + 1);
    }
  }
}

} // namespace helios
