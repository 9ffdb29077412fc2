// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformTesting.h"
#include "vtkHeliosWaveformPolylines.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <array>
#include <utility>
#include <vector>

namespace names = vtkHeliosArrayNames;

namespace
{

using Vector = std::array<double, 3>;
constexpr double SpeedOfLight = 0.299792458; // [m/ns]

struct Polylines
{
  vtkNew<vtkHeliosWaveformPolylines> Filter;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(Filter);
  vtkSmartPointer<helios::ErrorObserver> Quiet = helios::WatchErrors(Filter->GetExecutive());
  vtkSmartPointer<vtkTable> Table;

  explicit Polylines(vtkIdType count)
    : Table(helios::MakeWaveforms(count))
  {
    this->Filter->SetInputData(this->Table);
  }

  vtkPolyData* Update()
  {
    this->Filter->Modified();
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  double Get(const char* name, vtkIdType row, int component = 0)
  {
    return this->Table->GetRowData()->GetArray(name)->GetComponent(row, component);
  }
  double GetSample(vtkIdType i)
  {
    return this->Table->GetFieldData()->GetArray(names::Samples)->GetComponent(i, 0);
  }
  void SetDirection(vtkIdType row, const Vector& direction)
  {
    this->Table->GetRowData()->GetArray(names::Direction)->SetTuple(row, direction.data());
  }
};

Vector GetPoint(vtkPolyData* curves, vtkIdType i)
{
  Vector point;
  curves->GetPoint(i, point.data());
  return point;
}

std::vector<vtkIdType> GetPulses(vtkPolyData* curves)
{
  std::vector<vtkIdType> pulses;
  vtkDataArray* ids = curves->GetCellData()->GetArray(names::PulseIds);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    pulses.push_back(static_cast<vtkIdType>(ids->GetComponent(i, 0)));
  }
  return pulses;
}

} // namespace

TEST_CASE("WaveformPolylines: samples are at the positions of the formula", "[WaveformPolylines]")
{
  Polylines curves(50);
  constexpr double scale = 3e6;
  curves.Filter->SetScale(scale);
  vtkPolyData* output = curves.Update();
  REQUIRE(output->GetNumberOfLines() == 50);
  CHECK(output->GetPoints()->GetDataType() == VTK_DOUBLE);
  vtkDataArray* amplitudes = output->GetPointData()->GetArray(names::Amplitude);
  vtkDataArray* ranges = output->GetPointData()->GetArray(names::Range);
  REQUIRE(amplitudes->GetNumberOfTuples() == output->GetNumberOfPoints());
  REQUIRE(ranges->GetNumberOfTuples() == output->GetNumberOfPoints());
  vtkIdType at = 0;
  double worst = 0.0;
  for (vtkIdType row = 0; row < 50; ++row)
  {
    vtkIdType size;
    const vtkIdType* ids;
    output->GetLines()->GetCellAtId(row, size, ids);
    REQUIRE(size == 1 + row % 40);
    for (vtkIdType i = 0; i < size; ++i, ++at)
    {
      REQUIRE(ids[i] == at);
      const double range =
        SpeedOfLight / 2 * (667.125 + static_cast<double>(row) + 0.25 * static_cast<double>(i));
      const double a = curves.GetSample(at);
      const Vector point = GetPoint(output, at);
      for (int axis = 0; axis < 3; ++axis) // beams are horizontal within 1e-9: up is perpendicular
      {
        const double expected = curves.Get(names::Origin, row, axis) +
          range * curves.Get(names::Direction, row, axis) + (axis == 2 ? scale * a : 0.0);
        worst = std::max(worst, std::abs(point[static_cast<std::size_t>(axis)] - expected));
      }
      CHECK(amplitudes->GetComponent(at, 0) == a);
      CHECK(ranges->GetComponent(at, 0) == Approx(range).epsilon(1e-14));
    }
  }
  CHECK(at == output->GetNumberOfPoints());
  CHECK(worst < 1e-8); // the beams are horizontal within 1e-9, and displacements go up to 3 m
  CHECK(output->GetCellData()->GetArray(names::GpsTime)->GetComponent(7, 0) == 1.75);
  CHECK(GetPulses(output)[3] == 49);
  CHECK_FALSE(output->GetCellData()->GetArray(names::Offset));
  CHECK_FALSE(output->GetCellData()->GetArray(names::Origin));
}

TEST_CASE("WaveformPolylines: amplitudes are perpendicular to the beam", "[WaveformPolylines]")
{
  const auto [direction, wanted, across] = GENERATE(
    std::tuple(Vector{ 0, 0.6, -0.8 }, Vector{ 0, 0, 1 }, Vector{ 0, 0.8, 0.6 }), // tilted: up
    std::tuple(Vector{ 0, 0.6, -0.8 }, Vector{ 5, 0, 0 }, Vector{ 1, 0, 0 }),     // unchanged
    std::tuple(Vector{ 0, 0, -1 }, Vector{ 0, 0, 1 }, Vector{ 1, 0, 0 }),         // along it: x
    std::tuple(Vector{ 1, 0, 0 }, Vector{ -2, 0, 0 }, Vector{ 0, 1, 0 }));        // along x: y
  Polylines curves(1);
  curves.SetDirection(0, direction);
  curves.Table->GetFieldData()->GetArray(names::Samples)->SetComponent(0, 0, 0.25F);
  curves.Filter->SetDisplacementDirection(wanted.data());
  curves.Filter->SetScale(8.0);
  const Vector point = GetPoint(curves.Update(), 0);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double onBeam = curves.Get(names::Origin, 0, static_cast<int>(axis)) +
      SpeedOfLight / 2 * 667.125 * direction[axis];
    CHECK(point[axis] - onBeam == Approx(2.0 * across[axis]).epsilon(0).margin(1e-9));
  }
}

TEST_CASE("WaveformPolylines: by default the largest amplitude is displaced by Height",
  "[WaveformPolylines]")
{
  Polylines curves(40);
  curves.Filter->SetHeight(2.5);
  vtkPolyData* output = curves.Update();
  const auto row = std::pair(output->GetNumberOfPoints() - 1, 819); // last of 820 samples i 1e-9
  CHECK(curves.GetSample(row.first) == Approx(1e-9 * row.second));
  CHECK(GetPoint(output, row.first)[2] - 100.5 == Approx(2.5).epsilon(1e-6));
  curves.Table->GetFieldData()->GetArray(names::Samples)->Fill(0.0);
  curves.Table->Modified();
  output = curves.Update();
  CHECK(GetPoint(output, 5)[2] == Approx(100.5).epsilon(1e-9)); // no signal: on the beam
}

TEST_CASE("WaveformPolylines: every Nth waveform", "[WaveformPolylines]")
{
  Polylines curves(7); // pulses 40, 43 ... 58
  curves.Filter->SetEveryNth(3);
  CHECK(GetPulses(curves.Update()) == std::vector<vtkIdType>{ 40, 49, 58 });
  for (const vtkIdType pulse : { 58, 43, 46, 52, 1000 })
  {
    curves.Filter->AddPulseId(pulse);
  }
  CHECK(GetPulses(curves.Update()) == std::vector<vtkIdType>{ 43, 58 });
  curves.Filter->SetEveryNth(1);
  CHECK(GetPulses(curves.Update()) == std::vector<vtkIdType>{ 43, 46, 52, 58 });
  curves.Filter->RemoveAllPulseIds();
  CHECK(GetPulses(curves.Update()).size() == 7);
  curves.Filter->AddPulseId(1);
  CHECK(curves.Update()->GetNumberOfCells() == 0);
}

TEST_CASE("WaveformPolylines: no waveforms: no curves", "[WaveformPolylines]")
{
  Polylines curves(0);
  CHECK(curves.Update()->GetNumberOfPoints() == 0);
  CHECK(curves.Log->Errors.empty());
}

TEST_CASE("WaveformPolylines: bad input is an error", "[WaveformPolylines]")
{
  Polylines curves(3);
  SECTION("no samples")
  {
    curves.Table->GetFieldData()->RemoveArray(names::Samples);
    CHECK(curves.Update()->GetNumberOfCells() == 0);
    CHECK(curves.Log->HasError("the input has no array Samples; connect the waveforms of"));
  }
  SECTION("no direction")
  {
    curves.Filter->SetDisplacementDirection(0, 0, 0);
    CHECK(curves.Update()->GetNumberOfCells() == 0);
    CHECK(curves.Log->HasError("DisplacementDirection is 0 0 0; set a vector that is not zero"));
  }
}
