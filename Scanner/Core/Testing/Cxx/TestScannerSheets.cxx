// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that end in a beam, closely before others: adaptive sampling against 65,536 sub-rays.
#include "heliosMaterialTable.h"
#include "heliosScannerBench.h"
#include "heliosSheetScenes.h"

#include <vtkImageData.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using helios::Material;
using helios::OpticsKind;
using helios::Vec3;
using namespace helios::testing;
namespace names = vtkHeliosArrayNames;

namespace
{

/// All pulses down.
class StraightDown : public vtkHeliosBeamDeflector
{
public:
  static StraightDown* New() { VTK_STANDARD_NEW_BODY(StraightDown); }
  vtkTypeMacro(StraightDown, vtkHeliosBeamDeflector);
  bool GetDirection(vtkIdType, double direction[3]) const override
  {
    direction[0] = direction[1] = 0.0;
    direction[2] = -1.0;
    return true;
  }
};

constexpr double Divergence = 5e-4; // [rad]
constexpr double Height = 40.0;     // [m]
constexpr double Radius = 0.5 * Divergence * Height;
const std::vector<double> Tolerances = { 1e-3, 1e-2 }; // [m]

/// One pulse from above.
struct Shot : Bench
{
  vtkNew<StraightDown> Down;

  explicit Shot(vtkPolyData* scene)
    : Bench(scene, { 0, 0, Height })
  {
    this->Scanner->SetBeamDeflector(this->Down);
    this->Scanner->SetDuration(1e-5);
    this->Scanner->SetAtmosphericExtinction(0.0);
    this->Scanner->SetRangeAccuracy(0.0);
    this->Scanner->GetBeamSampler()->SetBeamDivergence(Divergence);
  }
  void SetTolerance(double range)
  {
    this->Scanner->SetSamplingToTolerance();
    this->Scanner->SetRangeTolerance(range);
    this->Scanner->SetEnergyTolerance(10.0 * range);
  }
  void SetReference()
  {
    this->Scanner->GetBeamSampler()->SetPatternToVogel();
    this->Scanner->GetBeamSampler()->SetNumberOfSubRays(65536);
    this->Scanner->SetBinSize(0.02);
  }
  double GetFullAmplitude() const
  {
    const double d = this->Scanner->GetReceiverDiameter();
    return this->Scanner->GetAveragePower() * 0.5 * this->Scanner->GetOpticalEfficiency() * d * d /
      (4.0 * Height * Height);
  }
};

/// Scenes of a kind, and the beams on them.
struct Setting
{
  const char* Name = "";
  double Slope = 0.2;
  Material Ground = {};
  std::function<void(Shot&)> SetUp = [](Shot&) {};
};

/// Errors of the echoes of beams that the tolerances bound.
struct Errors
{
  std::vector<double> Ranges; // [m]
  double Amplitude = 0.0;     // the largest, of a full footprint
  double Squares = 0.0;       // sum of squares of all amplitudes
  int Lost = 0;               // missed and invented

  void Add(vtkPolyData* found, vtkPolyData* truth, double full, double least)
  {
    const auto isStrong = [&](vtkPolyData* echoes, vtkIdType i)
    { return Value(echoes, names::Amplitude, i) >= least * full; };
    for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); ++i)
    {
      const vtkIdType nearest = FindNearest(found, Value(truth, names::Range, i));
      if (nearest >= 0)
      {
        const auto getError = [&](const char* name)
        { return std::abs(Value(found, name, nearest) - Value(truth, name, i)); };
        const double amplitude = getError(names::Amplitude) / full;
        this->Amplitude = std::max(this->Amplitude, amplitude);
        this->Squares += amplitude * amplitude;
        if (isStrong(truth, i))
        {
          this->Ranges.push_back(getError(names::Range));
        }
      }
      this->Lost += nearest < 0 && isStrong(truth, i) ? 1 : 0;
    }
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      const bool isKnown = FindNearest(truth, Value(found, names::Range, i)) >= 0;
      this->Lost += !isKnown && isStrong(found, i) ? 1 : 0;
    }
  }

  /// The echo within the distance of echoes that are one, or -1.
  static vtkIdType FindNearest(vtkPolyData* echoes, double range)
  {
    vtkIdType nearest = -1;
    double least = 0.25;
    for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
    {
      const double away = std::abs(Value(echoes, names::Range, i) - range);
      nearest = away < least ? i : nearest;
      least = std::min(least, away);
    }
    return nearest;
  }

  double GetQuantile(double quantile)
  {
    std::sort(this->Ranges.begin(), this->Ranges.end());
    const std::size_t size = this->Ranges.size();
    const auto place = static_cast<std::size_t>(quantile * static_cast<double>(size));
    return size == 0 ? 0.0 : this->Ranges[std::min(place, size - 1)];
  }
};

/// Adds the errors of a number of beams, by tolerance.
void Measure(SheetKind sheet, GroundKind ground, const Setting& setting, int count,
  std::vector<Errors>& errors)
{
  const std::uint64_t first =
    100000 * (100 * static_cast<std::uint64_t>(sheet) + static_cast<std::uint64_t>(ground));
  for (int i = 0; i < count; ++i)
  {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const double gap = std::pow(10.0, SheetDice(seed + 7)(-4.0, -0.7));
    const auto scene = SheetScene(seed, Radius, gap, setting.Slope).Make(sheet, ground);
    helios::SetMaterials(scene, { Material(), setting.Ground });
    Shot reference(scene);
    setting.SetUp(reference);
    reference.SetReference();
    vtkPolyData* truth = reference.Run();
    for (std::size_t k = 0; k < Tolerances.size(); ++k)
    {
      Shot shot(scene);
      setting.SetUp(shot);
      shot.SetTolerance(Tolerances[k]);
      const double least = std::max(0.02, 10.0 * Tolerances[k]);
      errors[k].Add(shot.Run(), truth, shot.GetFullAmplitude(), least);
      CHECK(shot.Log->Errors.empty());
    }
  }
}

/// The number of beams of each kind; another one for a longer run, which prints a table.
const char* const Longer = std::getenv("HELIOS_SHEETS");
int GetCount(int usual)
{
  return Longer ? std::atoi(Longer) : usual;
}

void Print(const std::string& name, double tolerance, Errors& e)
{
  if (Longer)
  {
    std::printf("%-42s %5.1f mm asked: p95 %7.3f, most %7.3f mm, amplitude %.5f, %d lost\n",
      name.c_str(), 1e3 * tolerance, 1e3 * e.GetQuantile(0.95), 1e3 * e.GetQuantile(1.0),
      e.Amplitude, e.Lost);
  }
}

/// Checks every beam.
void Check(SheetKind sheet, GroundKind ground, const Setting& setting, int count)
{
  const std::string name = std::string(SheetNames[static_cast<std::size_t>(sheet)]) + " over " +
    GroundNames[static_cast<std::size_t>(ground)] + " " + setting.Name;
  std::vector<Errors> errors(Tolerances.size());
  Measure(sheet, ground, setting, count, errors);
  for (std::size_t k = 0; k < Tolerances.size(); ++k)
  {
    Print(name, Tolerances[k], errors[k]);
    CAPTURE(name, Tolerances[k]);
    CHECK(errors[k].GetQuantile(1.0) <= Tolerances[k]);
    CHECK(errors[k].Amplitude <= 10.0 * Tolerances[k]);
    CHECK(errors[k].Lost == 0);
  }
}

template <typename UseT>
void ForEachSheet(UseT use)
{
  for (std::size_t sheet = 0; sheet < SheetNames.size(); ++sheet)
  {
    use(static_cast<SheetKind>(sheet));
  }
}

vtkSmartPointer<vtkImageData> MakeThinAir()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 2);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0, 2.0, 2.0);
  vtkNew<vtkDoubleArray> density;
  density->SetName(names::PAD);
  density->InsertNextValue(1e-12);
  image->GetCellData()->AddArray(density);
  return image;
}

Material MakePane()
{
  Material pane;
  pane.Optics.Kind = OpticsKind::Pane;
  return pane;
}

Material MakeDark()
{
  Material dark;
  dark.Reflectance = 0.05;
  return dark;
}

std::vector<Setting> GetSettings()
{
  return {
    { "steep", 1.5 },
    { "dark ground", 0.2, MakeDark() },
    { "ellipse", 0.5, {},
      [](Shot& shot)
      {
        shot.Scanner->GetBeamSampler()->SetDivergenceRatio(0.3);
        shot.Scanner->GetBeamSampler()->SetMajorAxisAngle(20.0);
      } },
    { "waist", 0.5, {},
      [](Shot& shot) { shot.Scanner->GetBeamSampler()->SetBeamQualityFactor(1.5); } },
  };
}

/// Beams that are not divided, but sampled.
std::vector<Setting> GetSampledSettings()
{
  return {
    { "glass", 0.2, MakePane() },
    { "in leaves", 0.2, {},
      [](Shot& shot) { shot.Scanner->AddInputDataObject(2, MakeThinAir()); } },
  };
}

} // namespace

TEST_CASE("ScannerSheets: what ends in a beam before a surface counts", "[ScannerSheets]")
{
  ForEachSheet(
    [](SheetKind sheet)
    {
      for (std::size_t ground = 0; ground < GroundNames.size(); ++ground)
      {
        Check(sheet, static_cast<GroundKind>(ground), {}, GetCount(6));
      }
    });
}

TEST_CASE("ScannerSheets: the same for other beams, slopes and materials", "[ScannerSheets]")
{
  for (const Setting& setting : GetSettings())
  {
    ForEachSheet(
      [&](SheetKind sheet)
      {
        Check(sheet, GroundKind::Triangle, setting, GetCount(2));
        Check(sheet, GroundKind::Mesh, setting, GetCount(2));
      });
  }
}

TEST_CASE("ScannerSheets: sampled beams keep the percentile", "[ScannerSheets]")
{
  for (const Setting& setting : GetSampledSettings())
  {
    std::vector<Errors> errors(Tolerances.size());
    ForEachSheet(
      [&](SheetKind sheet)
      {
        Measure(sheet, GroundKind::Triangle, setting, GetCount(4), errors);
        Measure(sheet, GroundKind::Mesh, setting, GetCount(4), errors);
      });
    for (std::size_t k = 0; k < Tolerances.size(); ++k)
    {
      Print(setting.Name, Tolerances[k], errors[k]);
      CAPTURE(setting.Name, Tolerances[k]);
      CHECK(errors[k].GetQuantile(0.95) <= Tolerances[k]);
      const auto count = static_cast<double>(errors[k].Ranges.size());
      CHECK(std::sqrt(errors[k].Squares / count) <= 10.0 * Tolerances[k]);
      CHECK(errors[k].Lost == 0);
    }
  }
}
