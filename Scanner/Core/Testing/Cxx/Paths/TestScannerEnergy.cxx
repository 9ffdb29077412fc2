// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Random scenes of mirrors and panes gain no energy.
#include "heliosOpticsBench.h"
#include "heliosRandom.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace helios::testing;
using helios::Material;
using helios::OpticsKind;
using helios::Vec3;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Half = 20.0; // half side of a white room [m]
constexpr int Plates = 60;

/// All pulses in random directions.
class Everywhere : public vtkHeliosBeamDeflector
{
public:
  static Everywhere* New() { VTK_STANDARD_NEW_BODY(Everywhere); }
  vtkTypeMacro(Everywhere, vtkHeliosBeamDeflector);
  bool GetDirection(vtkIdType pulse, double direction[3]) const override
  {
    const auto u =
      helios::Uniform4(11, helios::RandomStream::Scene, static_cast<std::uint64_t>(pulse), 3);
    const double z = 2.0 * u[0] - 1.0;
    const double angle = 2.0 * vtkMath::Pi() * u[1];
    direction[0] = std::sqrt(1.0 - z * z) * std::cos(angle);
    direction[1] = std::sqrt(1.0 - z * z) * std::sin(angle);
    direction[2] = z;
    return true;
  }
};

/// A white room about the scanner, with plates at random places: a mirror, and two panes for each.
vtkSmartPointer<vtkPolyData> MakeRoom(std::uint64_t seed)
{
  std::vector<Rectangle> all;
  for (int i = 0; i < Plates; ++i)
  {
    const auto item = static_cast<std::uint64_t>(i);
    const auto u = helios::Uniform4(seed, helios::RandomStream::Scene, item, 4);
    const auto v = helios::Uniform4(seed, helios::RandomStream::Scene, item, 5);
    const auto at = [](double share) { return 1.6 * Half * (share - 0.5); };
    Vec3 normal(v[0] - 0.5, v[1] - 0.5, v[2] - 0.5);
    normal.Normalize();
    const Vec3 centre(at(u[0]), at(u[1]), at(u[2]));
    all.push_back(Across(centre, normal, std::min(8.0, 0.5 * centre.Norm())));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -Half, Half })
    {
      Vec3 centre(0, 0, 0), normal(0, 0, 0);
      centre[axis] = side;
      normal[axis] = 1.0;
      all.push_back(Across(centre, normal, Half));
    }
  }
  const auto room = MakeScene(all);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (int i = 0; i < static_cast<int>(all.size()); ++i)
  {
    ids->InsertNextValue(i < Plates ? (i % 3 == 0 ? 1 : 2) : 0);
    ids->InsertNextValue(i < Plates ? (i % 3 == 0 ? 1 : 2) : 0);
  }
  room->GetCellData()->AddArray(ids);
  Material white;
  white.Reflectance = 1.0;
  Material pane = MakeMaterial(OpticsKind::Pane);
  pane.Optics.Thickness = 1e-6;
  helios::SetMaterials(room, { white, MakeMaterial(OpticsKind::Mirror), pane });
  return room;
}

/// The pulses that a plate sends back into the receiver, all of their light.
std::set<vtkIdType> FindSelfSeen(vtkPolyData* subRays)
{
  std::set<vtkIdType> pulses;
  for (vtkIdType i = 0; i < subRays->GetNumberOfPoints(); ++i)
  {
    if (Value(subRays, names::CellIds, i) < 2.0 * Plates)
    {
      pulses.insert(static_cast<vtkIdType>(Value(subRays, names::PulseIds, i)));
    }
  }
  return pulses;
}

} // namespace

TEST_CASE("ScannerEnergy: what returns from random scenes is never more than was sent")
{
  const auto seed = static_cast<std::uint64_t>(GENERATE(1, 2, 3));
  Bench bench(MakeRoom(seed));
  vtkHeliosScanner* scanner = bench.Scanner;
  vtkNew<Everywhere> directions;
  directions->SetPulseFrequency(1e5);
  scanner->SetBeamDeflector(directions);
  scanner->SetDuration(0.02);
  scanner->GetBeamSampler()->SetBeamDivergence(0.0);
  scanner->GetBeamSampler()->SetNumberOfRings(1);
  scanner->SetAtmosphericExtinction(0.0);
  scanner->SetRangeMin(0.0);
  scanner->SetPulseLength(0.05);
  scanner->SetBinSize(0.01);
  scanner->SetMaximumSpecularEvents(12);
  scanner->SetLeastSpecularShare(1e-5);
  scanner->GenerateWaveformsOn();
  scanner->GenerateSubRaysOn();
  bench.Run();
  REQUIRE(bench.Log->Errors.empty());

  // A white wall at R returns P(R) = Gain / R^2; a waveform is a sum of T^2 cos P(R), and the sum of all T is
  // at most 1.
  auto* table = vtkTable::SafeDownCast(scanner->GetOutputDataObject(1));
  auto* samples =
    vtkDataArray::SafeDownCast(table->GetFieldData()->GetAbstractArray(names::Samples));
  const auto column = [table](const char* name)
  { return vtkDataArray::SafeDownCast(table->GetColumnByName(name)); };
  const double gain = scanner->GetAveragePower() * scanner->GetOpticalEfficiency() * 0.25 *
    std::pow(scanner->GetReceiverDiameter(), 2);
  // area of the pulse [ns]
  const double area = 0.05 / std::sqrt(4.0 * std::log(2.0) / vtkMath::Pi());
  const std::set<vtkIdType> seen = FindSelfSeen(scanner->GetOutput(3));
  double largest = 0.0;
  double mean = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (seen.count(static_cast<vtkIdType>(column(names::PulseIds)->GetComponent(row, 0))) > 0)
    {
      continue;
    }
    const double start = column(names::StartTime)->GetComponent(row, 0);
    const auto first = static_cast<vtkIdType>(column(names::Offset)->GetComponent(row, 0));
    const auto count = static_cast<vtkIdType>(column(names::Count)->GetComponent(row, 0));
    double share = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double range = 0.5 * 0.299792458 * (start + 0.01 * static_cast<double>(i));
      share += samples->GetComponent(first + i, 0) * range * range / gain * 0.01 / area;
    }
    largest = std::max(largest, share);
    mean += share / static_cast<double>(table->GetNumberOfRows());
  }
  CHECK(table->GetNumberOfRows() > 1990);
  CHECK(seen.size() < 20);
  CHECK(scanner->GetOutput(3)->GetNumberOfPoints() > 10000); // paths
  CHECK(largest < 1.001);
  CHECK(mean > 0.3);
}
