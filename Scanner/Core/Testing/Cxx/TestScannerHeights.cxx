// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes on a height field are those on its mesh, byte for byte.
#pragma GCC diagnostic ignored "-Wpsabi" // heliosBeamBundle.h needs it
#include "heliosBeamBundle.h"
#include "heliosConeProbe.h"
#include "heliosHeightField.h"
#include "heliosRasterScenes.h"
#include "heliosScannerBench.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRotatingMirror.h"

#include <catch2/catch.hpp>

#include <algorithm>

using helios::HeightRaster;
using helios::Vec3;
using namespace helios::testing;

namespace
{

/// Casts rays on a height field instead of the scene, which is its mesh.
class HeightCaster : public vtkHeliosRayCaster
{
public:
  static HeightCaster* New() { VTK_STANDARD_NEW_BODY(HeightCaster); }
  vtkTypeMacro(HeightCaster, vtkHeliosRayCaster);

  bool SetRaster(vtkImageData* raster)
  {
    const bool isSet = this->Field.Set(raster).IsOk();
    this->Tree.Build(this->Field);
    return isSet;
  }

  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      hits[i] = this->Tree.Intersect(rays[i]);
    }
  }
  void IntersectBeams(
    const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const override
  {
    helios::BeamBundle bundle(this->Tree);
    for (vtkIdType beam = 0; beam < beams; ++beam)
    {
      for (int first = 0; first < raysPerBeam; first += helios::BeamBundle::MaximumRays)
      {
        const int count = std::min(helios::BeamBundle::MaximumRays, raysPerBeam - first);
        bundle.Trace(rays + first, hits + first, count);
      }
      rays += raysPerBeam;
      hits += raysPerBeam;
    }
  }
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override
  {
    helios::SceneTree::Occluder occluder;
    for (vtkIdType i = 0; i < count; ++i)
    {
      occluded[i] = this->Tree.IsOccluded(rays[i], occluder);
    }
  }
  const char* GetName() const override { return "height"; }
  std::size_t GetAcceleratorSize() const override { return this->Tree.GetMemorySize(); }

protected:
  bool BuildAccelerator(const helios::TriangleMesh&) override { return true; }
  std::unique_ptr<helios::ConeProbe> MakeConeProbe() override
  {
    return helios::MakeConeProbe(this->Tree);
  }

private:
  helios::HeightField Field;
  helios::SceneTree Tree;
};

/// A raster of 200 x 200 pixels of 0.5 m about the origin.
HeightRaster MakeRaster(bool hasHoles, bool isRotated)
{
  HeightRaster raster(200, 200, { -50, 0.5, 0, 50, 0, -0.5 });
  if (isRotated)
  {
    raster.Transform = { 10, 0.3, -0.4, 70, -0.4, -0.3 };
  }
  raster.AddHills(1.5, 0.05);
  if (hasHoles)
  {
    raster.AddHoles();
  }
  return raster;
}

/// A sweep up and down, from above the middle, all around.
std::string Scan(vtkPolyData* mesh, vtkImageData* raster, double divergence, bool isFixed)
{
  Bench bench(mesh, { 0.1, 0.2, 12.0 });
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(60);
  mirror->SetPulseFrequency(20000);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->SetHeadRotateSpeed(2000);
  bench.Scanner->SetDuration(0.18);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(divergence);
  if (!isFixed)
  {
    bench.Scanner->SetSamplingToTolerance();
  }
  vtkNew<HeightCaster> caster;
  if (raster)
  {
    REQUIRE(caster->SetRaster(raster));
    bench.Scanner->SetRayCaster(caster);
  }
  vtkPolyData* echoes = bench.Run();
  CHECK(bench.Log->Errors.empty());
  CHECK(echoes->GetNumberOfPoints() > 1000);
  return Bytes(echoes);
}

} // namespace

TEST_CASE("ScannerHeights: echoes are those of the mesh, byte for byte", "[ScannerHeights]")
{
  for (const bool hasHoles : { false, true })
  {
    for (const bool isRotated : { false, true })
    {
      const HeightRaster raster = MakeRaster(hasHoles, isRotated);
      const auto mesh = helios::MakeMesh(raster);
      const auto image = raster.MakeImage<vtkFloatArray>();
      for (const double divergence : { 3e-4, 5e-3, 0.05 })
      {
        INFO("holes " << hasHoles << ", rotated " << isRotated << ", divergence " << divergence);
        CHECK((Scan(mesh, image, divergence, true) == Scan(mesh, nullptr, divergence, true)));
        CHECK((Scan(mesh, image, divergence, false) == Scan(mesh, nullptr, divergence, false)));
      }
    }
  }
}
