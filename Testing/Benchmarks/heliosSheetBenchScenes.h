// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Thin surfaces closely before a large triangle, which covers the whole beam.

#ifndef heliosSheetBenchScenes_h
#define heliosSheetBenchScenes_h

#include "heliosAccuracyScenes.h"

namespace helios::bench
{

/// Slats of 20 mm every 35 mm, 30 mm before a wall, from 40 m.
inline TradeScene MakeSlatScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 40.03, 0 }, { 20, 0, 0 }, { 0, 0, 20 });
  for (int i = -60; i <= 60; ++i)
  {
    scene.AddQuad({ 0.035 * i, 40, 0 }, { 0.01, 0, 0 }, { 0, 0, 2 });
  }
  return { "slats", scene.Finish(), BenchOffset, { 0.3, 0, 0.2 }, { -1.5, 40, -1.5 }, { 3, 0, 0 },
    { 0, 0, 3 }, 0.35e-3, {} };
}

/// Leaves of 3 to 6 cm, 0.5 to 15 cm before a wall, from 30 m.
inline TradeScene MakeIvyScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 30, 0 }, { 20, 0, 0 }, { 0, 0, 20 });
  for (std::uint64_t i = 0; i < 6000; ++i)
  {
    const auto r = Draw(i);
    const auto s = Draw(i, 1);
    const Vec3 normal = Vec3(0, -1, 0) + 0.6 * DrawDirection(i, 2);
    AddDisc(scene,
      { 2.5 * (2 * r[0] - 1), 30 - 0.005 * std::pow(30.0, r[2]), 2.5 * (2 * r[1] - 1) },
      normal.Normalized(), 0.015 * (1 + s[0]));
  }
  return { "ivy", scene.Finish(), BenchOffset, { 1.0, 0, 0.2 }, { -2, 30, -2 }, { 4, 0, 0 },
    { 0, 0, 4 }, 0.35e-3, {} };
}

/// Leaflets of 1.2 to 2 cm, 1 to 12 cm above soil of one quad, from a mast of 12 m.
inline TradeScene MakeCloverScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 0, 0 }, { 30, 0, 0 }, { 0, 30, 0 });
  for (std::uint64_t i = 0; i < 40000; ++i)
  {
    const auto r = Draw(i);
    const auto s = Draw(i, 1);
    const Vec3 normal = Vec3(0, 0, 1) + 0.5 * DrawDirection(i, 2);
    AddDisc(scene, { 2.5 * (2 * r[0] - 1), 2.5 * (2 * r[1] - 1), 0.01 * std::pow(12.0, r[2]) },
      normal.Normalized(), 0.006 + 0.004 * s[0]);
  }
  return { "clover", scene.Finish(), BenchOffset, { -6, -3, 12 }, { -2, -2, 0 }, { 4, 0, 0 },
    { 0, 4, 0 }, 0.5e-3, {} };
}

/// A venetian blind: slats 25 mm deep, at 45 degrees, every 20 mm, 40 mm before a wall, from 25 m.
inline TradeScene MakeBlindScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 25.04, 0 }, { 20, 0, 0 }, { 0, 0, 20 });
  for (int i = -100; i <= 100; ++i)
  {
    scene.AddQuad({ 0, 25, 0.02 * i }, { 2, 0, 0 }, { 0, 0.0088, 0.0088 });
  }
  return { "blind", scene.Finish(), BenchOffset, { 0.4, 0, 0.3 }, { -1, 25, -1 }, { 2, 0, 0 },
    { 0, 0, 2 }, 0.35e-3, {} };
}

inline std::vector<TradeScene> MakeAllAccuracyScenes()
{
  std::vector<TradeScene> scenes = MakeAccuracyScenes();
  for (auto make : { MakeSlatScene, MakeIvyScene, MakeCloverScene, MakeBlindScene })
  {
    scenes.push_back(make());
  }
  return scenes;
}

} // namespace helios::bench

#endif
