// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPose.h"
#include "heliosRandom.h"
#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosTrajectoryTextWriter.h"

#include <catch2/catch.hpp>

#include <vector>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Returns X-Y-Z of HELIOS: yaw is applied to the body first; all axes are axes of the world.
helios::Quaternion Cardan(double roll, double pitch, double yaw)
{
  return helios::AxisAngle({ 1, 0, 0 }, roll) * helios::AxisAngle({ 0, 1, 0 }, pitch) *
    helios::AxisAngle({ 0, 0, 1 }, yaw);
}

vtkSmartPointer<vtkPolyData> MakeSamples(const std::vector<helios::Quaternion>& orientations)
{
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> array;
  array->SetName(names::Orientation);
  array->SetNumberOfComponents(4);
  for (const helios::Quaternion& q : orientations)
  {
    const auto i = static_cast<double>(points->GetNumberOfPoints());
    points->InsertNextPoint(1.5 + i, -2.25, 100.123456);
    array->InsertNextTuple(q.GetData());
  }
  samples->SetPoints(points);
  samples->GetPointData()->AddArray(array);
  helios::AddColumn<vtkDoubleArray>(samples->GetPointData(), names::GpsTime,
    points->GetNumberOfPoints(), [](vtkIdType i) { return 0.5 * static_cast<double>(i); });
  return samples;
}

std::vector<std::vector<std::string>> WriteSamples(const std::vector<helios::Quaternion>& samples)
{
  const helios::TempFolder folder;
  const std::string path = folder / "trajectory.txt";
  vtkNew<vtkHeliosTrajectoryTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(MakeSamples(samples)) && writer->Close()));
  return helios::ReadRows(path);
}

/// Formats the angles as words.
std::vector<std::string> WriteAngles(const helios::Quaternion& q)
{
  const auto row = WriteSamples({ q })[0];
  return { row.begin() + 4, row.end() };
}

using Words = std::vector<std::string>;

} // namespace

TEST_CASE("TrajectoryTextWriter: columns", "[TrajectoryTextWriter]")
{
  const auto rows = WriteSamples({ Cardan(0, 0, 0), Cardan(10, -20, 300) });
  REQUIRE(rows.size() == 2);
  CHECK(rows[0] ==
    Words{ "1.5000", "-2.2500", "100.1235", "0.000000000", "0.0000", "0.0000", "0.0000" });
  CHECK(rows[1] ==
    Words{ "2.5000", "-2.2500", "100.1235", "0.500000000", "10.0000", "-20.0000", "300.0000" });
}

TEST_CASE("TrajectoryTextWriter: headings of a level body", "[TrajectoryTextWriter]")
{
  // forward is y: a heading to the west is 90 degrees, counter-clockwise from above
  CHECK(WriteAngles(helios::AxisAngle({ 0, 0, 1 }, 90)) == Words{ "0.0000", "0.0000", "90.0000" });
  CHECK(
    WriteAngles(helios::AxisAngle({ 0, 0, 1 }, -90)) == Words{ "0.0000", "0.0000", "270.0000" });
  // nose up while heading along y is a rotation about x
  CHECK(WriteAngles(helios::AxisAngle({ 1, 0, 0 }, 5)) == Words{ "5.0000", "0.0000", "0.0000" });
}

TEST_CASE("TrajectoryTextWriter: printed yaw is below 360", "[TrajectoryTextWriter]")
{
  for (const double tiny : { -1e-12, -4.9e-5, -1e-300, 4.9e-5 })
  {
    CHECK(WriteAngles(Cardan(0, 0, tiny))[2] == "0.0000");
  }
  CHECK(WriteAngles(Cardan(0, 0, -5.1e-5))[2] == "359.9999");
  CHECK(WriteAngles(Cardan(0, 0, 359.99996))[2] == "0.0000");
}

TEST_CASE(
  "TrajectoryTextWriter: roll is 0 in gimbal lock, the rotation is kept", "[TrajectoryTextWriter]")
{
  CHECK(WriteAngles(Cardan(0, 90, 40)) == Words{ "0.0000", "90.0000", "40.0000" });
  CHECK(WriteAngles(Cardan(30, 90, 40)) == Words{ "0.0000", "90.0000", "70.0000" });
  CHECK(WriteAngles(Cardan(30, -90, 40)) == Words{ "0.0000", "-90.0000", "10.0000" });
}

TEST_CASE("TrajectoryTextWriter: the angles restore the attitude", "[TrajectoryTextWriter]")
{
  std::vector<helios::Quaternion> orientations;
  for (std::uint64_t i = 0; i < 3000; ++i)
  {
    const auto u = helios::Uniform4(1, helios::RandomStream::Scene, i, 0);
    // quaternion of any length
    orientations.emplace_back(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5, u[3] - 0.5);
    // close to gimbal lock
    const double off = std::pow(10.0, -14 * u[2]);
    orientations.push_back(Cardan(360 * u[0], i % 2 == 0 ? 90 - off : off - 90, 360 * u[1]));
  }
  const auto rows = WriteSamples(orientations);
  REQUIRE(rows.size() == orientations.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double roll = std::stod(rows[i][4]), pitch = std::stod(rows[i][5]);
    const double yaw = std::stod(rows[i][6]);
    CHECK((std::abs(roll) <= 180 && std::abs(pitch) <= 90 && yaw >= 0 && yaw < 360));
    const helios::Rotation expected(orientations[i]), read(Cardan(roll, pitch, yaw));
    for (int k = 0; k < 9; ++k)
    {
      largest = std::max(largest, std::abs(read.M[k / 3][k % 3] - expected.M[k / 3][k % 3]));
    }
  }
  // three angles, each with a rounding error of half of 1e-4 degrees
  CHECK(largest < 3 * vtkMath::RadiansFromDegrees(5e-5));
}

TEST_CASE("TrajectoryTextWriter: an orientation of length 0 is dropped", "[TrajectoryTextWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "trajectory.txt";
  vtkNew<vtkHeliosTrajectoryTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE(writer->Open());
  using Q = helios::Quaternion;
  CHECK(writer->Write(MakeSamples({ Q(0, 0, 0, 0), Q(1, 0, 0, 0), Q(vtkMath::Nan(), 0, 0, 1) })));
  CHECK(log->HasWarning("2 of 3 records"));
  CHECK(writer->GetNumberOfRecords() == 1);
}

TEST_CASE("TrajectoryTextWriter: bad input is an error", "[TrajectoryTextWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "trajectory.txt";
  vtkNew<vtkHeliosTrajectoryTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  const auto samples = MakeSamples({ helios::Quaternion(1, 0, 0, 0) });
  CHECK_FALSE(writer->Write(samples));
  CHECK(log->HasError("is not open"));
  REQUIRE(writer->Open());
  vtkNew<vtkPolyData> bare;
  CHECK(writer->Write(bare));
  samples->GetPointData()->RemoveArray(names::Orientation);
  CHECK_FALSE(writer->Write(samples));
  CHECK(log->HasError("no array Orientation; the samples of a vtkHeliosPlatform have it"));
  CHECK(writer->Close());
  CHECK(std::filesystem::file_size(path) == 0);
}
