// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Plant area density from beams whose paths are known.
#include "heliosErrorObserver.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"
#include "vtkHeliosMemoryLimit.h"
#include "vtkHeliosPlantAreaDensity.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTypeInt64Array.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace
{

using Triple = std::array<double, 3>;

vtkSmartPointer<vtkPolyData> MakeCloud(
  const std::vector<Triple>& points, const std::map<std::string, std::vector<double>>& columns)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> holder;
  holder->SetDataTypeToDouble();
  for (const Triple& point : points)
  {
    holder->InsertNextPoint(point.data());
  }
  cloud->SetPoints(holder);
  for (const auto& [name, values] : columns)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    const auto width = points.empty() ? 1 : values.size() / points.size();
    column->SetNumberOfComponents(static_cast<int>(width));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      column->InsertValue(static_cast<vtkIdType>(i), values[i]);
    }
    cloud->GetPointData()->AddArray(column);
  }
  return cloud;
}

/// A row of two cells of one metre along x, from 0 to 2, and beams along x from -1.
struct Row
{
  Row()
  {
    this->Filter->SetVoxelSize(1.0);
    this->Filter->SetGridBounds(0, 2, 0, 1, 0, 1);
    this->Filter->SetMinimumNumberOfBeams(1e-6);
    this->Observer->Watch(this->Filter);
  }

  /// Sets beams, and the pulse and x of each echo.
  void Set(int beams, const std::vector<std::pair<int, double>>& echoes,
    std::map<std::string, std::vector<double>> columns = {})
  {
    std::vector<Triple> origins;
    std::vector<double> directions;
    std::vector<double> ids;
    for (int i = 0; i < beams; ++i)
    {
      origins.push_back({ -1.0, 0.5, 0.5 });
      directions.insert(directions.end(), { 1.0, 0.0, 0.0 });
      ids.push_back(i);
    }
    std::vector<Triple> points;
    for (const auto& [pulse, x] : echoes)
    {
      points.push_back({ x, 0.5, 0.5 });
      columns[names::PulseIds].push_back(pulse);
    }
    this->Filter->SetInputData(0, MakeCloud(points, columns));
    this->Filter->SetInputData(
      1, MakeCloud(origins, { { names::Direction, directions }, { names::PulseIds, ids } }));
  }

  double Get(const char* name, vtkIdType cell)
  {
    this->Filter->Update();
    vtkDataArray* array = this->Filter->GetOutput()->GetCellData()->GetArray(name);
    REQUIRE(array);
    return array->GetTuple1(cell);
  }

  bool FailsWith(const std::string& message)
  {
    this->Observer->Clear();
    this->Filter->Modified();
    this->Filter->Update();
    INFO(this->Observer->Errors);
    return this->Observer->HasError(message);
  }

  vtkNew<vtkHeliosPlantAreaDensity> Filter;
  vtkNew<helios::ErrorObserver> Observer;
};

} // namespace

TEST_CASE("PlantAreaDensity: sums of four beams", "[PlantAreaDensity]")
{
  Row row;
  // In the first cell after 0.25 m, in the second after 0.5 m; two beams meet nothing.
  row.Set(4, { { 0, 0.25 }, { 2, 1.5 } });
  CHECK(row.Get(foliage::NumberOfBeams, 0) == 4);
  CHECK(row.Get(foliage::NumberOfBeams, 1) == 3);
  CHECK(row.Get(foliage::NumberOfShadowedBeams, 1) == 1);
  CHECK(row.Get(foliage::PathLength, 0) == Approx(3.25));
  CHECK(row.Get(foliage::PathLength, 1) == Approx(2.5));
  CHECK(row.Get(foliage::FreePath, 0) == Approx(0.5 * 3.25));
  CHECK(row.Get(foliage::HitPath, 0) == Approx(0.5 * 0.25));
  CHECK(row.Get(foliage::PotentialPath, 1) == Approx(0.5 * 3.0));
  CHECK(row.Get(names::Transmittance, 1) == Approx(2.0 / 3.0));
  CHECK(row.Get(foliage::CellState, 0) == 1);
}

TEST_CASE("PlantAreaDensity: estimators by their formulas", "[PlantAreaDensity]")
{
  Row row;
  row.Set(4, { { 0, 0.25 }, { 2, 1.5 } });
  const double path = 0.5 * 3.25;
  row.Filter->SetEstimatorToMaximumLikelihood();
  CHECK(row.Get(names::PAD, 0) == Approx(1.0 / path));
  CHECK(row.Get(foliage::DensityError, 0) == Approx(1.0 / path));
  row.Filter->SetEstimatorToMaximumLikelihoodCorrected();
  CHECK(row.Get(names::PAD, 0) == Approx((1.0 - 0.125 / path) / path));
  row.Filter->SetEstimatorToContactFrequency();
  CHECK(row.Get(names::PAD, 0) == Approx(0.25 / 0.5));
  CHECK(row.Get(foliage::DensityError, 0) == Approx(std::sqrt(0.75) / 2.0));
  row.Filter->SetEstimatorToBeerLambert();
  CHECK(row.Get(names::PAD, 0) == Approx(-std::log(0.75) / 0.5));
  row.Filter->SetEstimatorToBeerLambertCorrected();
  CHECK(row.Get(names::PAD, 0) == Approx((-std::log(0.75) - 0.25 / (2 * 4 * 0.75)) / 0.5));
}

TEST_CASE(
  "PlantAreaDensity: cells that nothing passes and that no beam enters", "[PlantAreaDensity]")
{
  Row row;
  row.Set(2, { { 0, 0.5 }, { 1, 0.5 } });
  row.Filter->SetEstimatorToBeerLambert();
  CHECK(row.Get(foliage::CellState, 0) == 3);
  CHECK(std::isnan(row.Get(names::PAD, 0)));
  CHECK(row.Get(foliage::CellState, 1) == 2);
  row.Filter->SetEstimatorToBeerLambertCorrected();
  CHECK(row.Get(names::PAD, 0) == Approx(std::log(6.0) / 0.5));
  row.Filter->SetEstimatorToMaximumLikelihood();
  CHECK(row.Get(names::PAD, 0) == Approx(2.0 / 0.5));
  CHECK(std::isnan(row.Get(names::PAD, 1)));
  row.Filter->SetGridBounds(0, 2, 5, 6, 0, 1);
  CHECK(row.Get(foliage::CellState, 0) == 0);
}

TEST_CASE("PlantAreaDensity: what is not counted ends the path", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetEstimatorToMaximumLikelihood();
  const std::map<std::string, std::vector<double>> columns = {
    { names::ClassificationIds, { 4, 2, 7 } }, { names::MaterialIds, { 1, 2, 1 } }
  };
  // A leaf, the ground, and noise, which is dropped.
  row.Set(3, { { 0, 0.5 }, { 1, 0.5 }, { 2, 0.5 } }, columns);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(1.0));
  CHECK(row.Get(foliage::PathLength, 0) == Approx(2.0));
  CHECK(row.Get(foliage::PotentialPath, 0) == Approx(0.5 * 2.5)); // the ground's ends there
  CHECK(row.Get(names::PAD, 0) == Approx(1.0 / (0.5 * 2.0)));
  row.Filter->AddCountedClass(2);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(1.0));
  row.Filter->AddCountedMaterial(1);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == 0.0);
  row.Filter->RemoveAllCounted();
  row.Filter->AddCountedMaterial(2);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(1.0));
  CHECK(vtkHeliosPlantAreaDensity::IsPlantClass(5));
  CHECK_FALSE(vtkHeliosPlantAreaDensity::IsPlantClass(9));
}

TEST_CASE("PlantAreaDensity: shares of the echoes of a pulse", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetEstimatorToMaximumLikelihood();
  row.Set(1, { { 0, 1.5 }, { 0, 0.5 } },
    { { names::Amplitude, { 1.0, 25.0 / 9.0 } }, { names::NumberOfReturns, { 4, 4 } },
      { names::Reflectance, { -10.0, -10.0 } } });
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(0.5)); // equal: P R^2
  row.Filter->SetEchoShares(vtkHeliosPlantAreaDensity::EQUAL);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(0.25)); // four returns
  row.Filter->SetEchoShares(vtkHeliosPlantAreaDensity::FIRST);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(1.0));
  CHECK(row.Get(foliage::NumberOfBeams, 1) == 0);
  row.Filter->SetEchoShares(vtkHeliosPlantAreaDensity::REFLECTANCE);
  row.Filter->SetElementReflectance(0.6);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(0.1 / 0.4));
  CHECK(row.Get(foliage::EnteringEnergy, 1) == Approx(0.75));
  row.Filter->SetElementReflectance(0.1); // a hit that faces the beam counts 1.5
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(1.5));
  CHECK(row.Get(foliage::NumberOfBeams, 1) == 0);
}

TEST_CASE(
  "PlantAreaDensity: hits of sub-rays, with the class of the nearest echo", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetEstimatorToMaximumLikelihood();
  row.Set(2, { { 0, 0.5 }, { 0, 1.5 } }, { { names::ClassificationIds, { 5, 2 } } });
  row.Filter->SetInputData(2,
    MakeCloud({ { 0.4, 0.5, 0.5 }, { 0.6, 0.5, 0.5 }, { 1.4, 0.5, 0.5 } },
      { { names::PulseIds, { 0, 0, 0 } }, { names::Weight, { 0.2, 0.3, 0.5 } },
        { names::IncidenceAngle, { 60, 0, 0 } } }));
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(0.5));
  CHECK(row.Get(foliage::InterceptedSquare, 0) == Approx(0.25));
  CHECK(row.Get(foliage::HitPath, 0) == Approx(0.5 * (0.04 * 0.4 + 0.09 * 0.6)));
  CHECK(row.Get(foliage::InterceptedEnergy, 1) == 0.0);
  CHECK(row.Get(foliage::PathLength, 1) == Approx(0.5 * 0.4 + 1.0));
  row.Filter->SetLeafAngleDistribution(vtkHeliosPlantAreaDensity::INCIDENCE_ANGLES);
  CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(0.2 / 0.5 + 0.3));
  CHECK(row.Get(names::PAD, 0) == Approx(0.7 / (0.2 * 0.4 + 0.3 * 0.6 + 0.5 + 1.0)));
}

TEST_CASE("PlantAreaDensity: G of leaf angles, by the direction of the beams", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetEstimatorToMaximumLikelihood();
  row.Set(1, { { 0, 0.5 } });
  row.Filter->SetLeafAngleDistribution(vtkHeliosPlantAreaDensity::VERTICAL);
  const double projection = 2.0 / std::acos(-1.0);
  CHECK(row.Get(names::PAD, 0) == Approx(1.0 / (0.5 * projection)));
  vtkDataArray* table = row.Filter->GetOutput()->GetFieldData()->GetArray(names::LeafProjection);
  REQUIRE(table);
  CHECK(table->GetNumberOfTuples() == 91);
  CHECK(table->GetComponent(90, 3) == Approx(projection));
}

TEST_CASE("PlantAreaDensity: elements of a size", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetEstimatorToMaximumLikelihood();
  row.Set(2, { { 0, 0.5 } });
  row.Filter->SetElementArea(0.2);
  const double attenuation = 0.2 * 0.5; // by one element
  const double path = -(std::log(1 - attenuation * 0.5) + std::log(1 - attenuation)) / 0.2;
  CHECK(row.Get(names::PAD, 0) == Approx(1.0 / path));
  CHECK(row.Get(foliage::DensityError, 0) == Approx(std::sqrt(1.0 + 2.0 / 3.0 * 0.2 * 1.5) / path));
  row.Filter->SetElementArea(2.0);
  CHECK(row.FailsWith("too large for cells"));
}

TEST_CASE("PlantAreaDensity: scans one after the other are one", "[PlantAreaDensity]")
{
  Row both;
  both.Set(4, { { 0, 0.25 }, { 2, 1.5 }, { 3, 0.7 } });
  Row first;
  first.Set(2, { { 0, 0.25 } });
  first.Filter->Update();
  Row second;
  second.Set(2, { { 0, 1.5 }, { 1, 0.7 } });
  second.Filter->SetInputData(4, first.Filter->GetOutput());
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    for (const char* name : { names::PAD, foliage::DensityError, foliage::PathLength,
           foliage::NumberOfBeams, foliage::NumberOfShadowedBeams, foliage::HitPath })
    {
      CHECK(second.Get(name, cell) == Approx(both.Get(name, cell)).epsilon(1e-8));
    }
  }
}

TEST_CASE("PlantAreaDensity: beams of echoes without pulses", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetEstimatorToMaximumLikelihood();
  const std::vector<Triple> points = { { 0.5, 0.5, 0.5 }, { 1.5, 0.5, 0.5 }, { 0.5, 0.25, 0.5 } };
  row.Filter->SetInputData(0, MakeCloud(points, { { names::GpsTime, { 10, 10, 12 } } }));
  SECTION("from one place, by times")
  {
    row.Filter->SetBeamOrigin(-1, 0.5, 0.5);
    CHECK(row.Get(foliage::NumberOfBeams, 0) == 2);
    CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(1.5));
  }
  SECTION("from a trajectory")
  {
    row.Filter->SetInputData(
      3, MakeCloud({ { -1, 0.5, 0.5 }, { -1, 0.0, 0.5 } }, { { names::GpsTime, { 10, 14 } } }));
    CHECK(row.Get(foliage::PathLength, 0) == Approx(0.5 * 0.5 + 0.5 * 1.0 + 0.5));
  }
  SECTION("from an array, each by itself")
  {
    row.Filter->SetInputData(
      0, MakeCloud(points, { { names::Origin, { -1, .5, .5, -1, .5, .5, -1, .25, .5 } } }));
    CHECK(row.Get(foliage::NumberOfBeams, 0) == 3);
    CHECK(row.Get(foliage::InterceptedEnergy, 0) == Approx(2.0));
  }
  SECTION("errors")
  {
    CHECK(row.FailsWith("where the beams begin is not known"));
    row.Filter->SetBeamOrigin(0.5, 0.5, 0.5);
    CHECK(row.FailsWith("echo 0 is at the origin of its beam"));
    row.Filter->SetInputData(
      3, MakeCloud({ { -1, 0, 0 }, { -1, 0, 0 } }, { { names::GpsTime, { 20, 30 } } }));
    CHECK(row.FailsWith("GpsTime 10.000000 of echo 0 is not on the trajectory"));
    row.Filter->SetInputData(
      3, MakeCloud({ { -1, 0, 0 }, { -1, 0, 0 } }, { { names::GpsTime, { 30, 20 } } }));
    CHECK(row.FailsWith("the trajectory is not sorted by GpsTime"));
    row.Filter->SetInputData(3, MakeCloud({ { -1, 0, 0 } }, {}));
    CHECK(row.FailsWith("no array GpsTime"));
  }
}

TEST_CASE("PlantAreaDensity: sums do not depend on the order of beams", "[PlantAreaDensity]")
{
  std::vector<std::pair<int, double>> echoes;
  for (int i = 0; i < 3000; ++i)
  {
    echoes.emplace_back(i, 2.0 * std::fmod(0.618034 * i, 1.0));
  }
  Row row;
  row.Set(5000, echoes);
  const double expected[] = { row.Get(names::PAD, 0), row.Get(foliage::HitPath, 1) };
  std::reverse(echoes.begin(), echoes.end());
  Row other;
  other.Set(5000, echoes);
  CHECK(other.Get(names::PAD, 0) == expected[0]);
  CHECK(other.Get(foliage::HitPath, 1) == expected[1]);
}

TEST_CASE("PlantAreaDensity: the grid of the counted echoes", "[PlantAreaDensity]")
{
  Row row;
  row.Filter->SetGridBounds(1, -1, 1, -1, 1, -1);
  row.Set(2, { { 0, 0.25 }, { 1, 2.5 } });
  row.Filter->Update();
  const double* bounds = row.Filter->GetOutput()->GetBounds();
  CHECK(bounds[0] == 0.0);
  CHECK(bounds[1] == 3.0);
  CHECK(bounds[3] == 1.0);
  CHECK(row.Filter->GetNumberOfBeams() == 2);
  row.Filter->SetMaximumNumberOfCells(2);
  CHECK(row.FailsWith("the grid has 3 cells, expected 1 to MaximumNumberOfCells (2)"));
  row.Set(1, {});
  CHECK(row.FailsWith("no echo is of a plant that is counted"));
}

TEST_CASE("PlantAreaDensity: bad input is an error", "[PlantAreaDensity]")
{
  Row row;
  row.Set(2, { { 0, 0.25 }, { 7, 2.5 } });
  CHECK(row.FailsWith("2 echoes or hits belong to 1 by their PulseIds"));
  row.Set(2, { { 0, 0.25 } });
  row.Filter->AddCountedClass(5);
  CHECK(row.FailsWith("no array ClassificationIds"));
  row.Filter->RemoveAllCounted();
  row.Filter->AddCountedMaterial(5);
  CHECK(row.FailsWith("no array MaterialIds"));
  row.Filter->RemoveAllCounted();
  row.Filter->SetEchoShares(vtkHeliosPlantAreaDensity::REFLECTANCE);
  CHECK(row.FailsWith("no array Reflectance"));
  row.Filter->SetEchoShares(vtkHeliosPlantAreaDensity::EQUAL);
  row.Filter->SetLeafAngleDistribution(vtkHeliosPlantAreaDensity::TABLE);
  CHECK(row.FailsWith("has no field array LeafProjection"));
  row.Filter->SetLeafAngleDistribution(vtkHeliosPlantAreaDensity::INCIDENCE_ANGLES);
  CHECK(row.FailsWith("no array IncidenceAngle"));
  row.Filter->SetEstimatorToBeerLambert();
  CHECK(row.FailsWith("Estimator is not one of maximum likelihood"));
  row.Filter->SetLeafAngleDistribution(vtkHeliosPlantAreaDensity::SPHERICAL);
  row.Filter->SetInputData(2, MakeCloud({ { 0, 0, 0 } }, { { names::PulseIds, { 0 } } }));
  CHECK(row.FailsWith("the hits of sub-rays have no array Weight"));
  row.Filter->SetInputData(2, MakeCloud({ { 0, 0, 0 } }, { { names::Weight, { 1 } } }));
  CHECK(row.FailsWith("the hits have no array PulseIds"));
  row.Filter->SetInputData(1, MakeCloud({ { 0, 0, 0 } }, { { names::PulseIds, { 0 } } }));
  CHECK(row.FailsWith("the pulses have no arrays Direction"));
  row.Filter->SetInputData(1, vtkSmartPointer<vtkPolyData>::New());
  CHECK(row.FailsWith("have no points"));
  row.Filter->SetInputConnection(1, nullptr);
  row.Filter->SetBeamOrigin(-1, 0, 0);
  CHECK(row.FailsWith("hits of sub-rays need the pulses"));
}

TEST_CASE("PlantAreaDensity: more cells than memory are an error", "[PlantAreaDensity]")
{
  Row row;
  row.Set(1, { { 0, 0.25 } });
  vtkHeliosMemoryLimit::SetLimit(1e-7);
  CHECK(row.FailsWith("cells need about"));
  vtkHeliosMemoryLimit::SetLimit(0.0);
}
