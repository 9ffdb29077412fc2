// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryReading.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosSBETWriter.h"

#include "heliosCoordinateTransform.h"
#include "heliosSceneCrs.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

namespace names = vtkHeliosArrayNames;
using helios::Quaternion;
using helios::Vec3;

namespace
{

using Record = std::array<double, 17>;

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0;
const Vec3 Right(1, 0, 0), Forward(0, 1, 0), Up(0, 0, 1);

/// A record on the Rhine, level, to the north.
Record MakeRecord(double time, double latitude = 49.0, double longitude = 8.0)
{
  return { time, latitude * Degree, longitude * Degree, 250.0 };
}

std::string ToBytes(const std::vector<Record>& records)
{
  std::string bytes(records.size() * sizeof(Record), '\0');
  std::memcpy(bytes.data(), records.data(), bytes.size());
  return bytes;
}

struct Reading : helios::TrajectoryReading
{
  Reading() { this->Reader->SetFileFormatToSbet(); }

  bool Read(const std::vector<Record>& records)
  {
    return this->TrajectoryReading::Read(ToBytes(records));
  }
  bool FailsWith(const std::vector<Record>& records, const std::string& part)
  {
    return this->TrajectoryReading::FailsWith(ToBytes(records), part);
  }
};

/// The meridian convergence of the transverse Mercator projection, to third order in the longitude
/// difference: l sin(latitude) (1 + l^2 cos^2(latitude) (1 + 3 eta^2 + 2 eta^4) / 3), in radians
/// (Snyder 1987, Map Projections, p. 61).
double ComputeConvergence(double latitude, double l)
{
  const double e2 = 0.00669437999014;
  const double c = std::cos(latitude);
  const double eta2 = e2 / (1.0 - e2) * c * c;
  return l * std::sin(latitude) * (1.0 + l * l * c * c * (1.0 + 3 * eta2 + 2 * eta2 * eta2) / 3.0);
}

/// The distance from the equator along a meridian of WGS 84 [m], by Simpson's rule over
/// a (1 - e^2) / (1 - e^2 sin^2)^(3/2).
double ComputeMeridianArc(double latitude)
{
  const double f = 1.0 / 298.257223563;
  const double e2 = f * (2.0 - f);
  const auto radius = [e2](double b)
  { return 6378137.0 * (1.0 - e2) / std::pow(1.0 - e2 * std::sin(b) * std::sin(b), 1.5); };
  constexpr int n = 1000;
  const double h = latitude / n;
  double sum = radius(0.0) + radius(latitude);
  for (int i = 1; i < n; ++i)
  {
    sum += (i % 2 == 0 ? 2.0 : 4.0) * radius(i * h);
  }
  return sum * h / 3.0;
}

/// The heading of a body vector, clockwise from y [rad].
double GetHeading(const Vec3& v)
{
  return std::atan2(v[0], v[1]);
}

} // namespace

TEST_CASE("SBET: positions are in the UTM zone of the first record", "[SBET]")
{
  Reading reading;
  REQUIRE(reading.Read({ MakeRecord(1.5, 49.0, 9.0), MakeRecord(1.75, 49.0, 8.0) }));
  CHECK(helios::GetCRS(reading.Path()) == "EPSG:32632");
  CHECK(reading.GetTime(0) == 1.5);
  CHECK(reading.GetTime(1) == 1.75);
  const Vec3 p = reading.GetPosition(0);
  CHECK(p[0] == Approx(500000.0).margin(1e-6)); // on the central meridian
  CHECK(p[2] == 250.0);
  CHECK(p[1] == Approx(0.9996 * ComputeMeridianArc(49.0 * Degree)).margin(1e-6));
  REQUIRE(reading.Read({ MakeRecord(0, -49.0, -60.0) }));
  CHECK(helios::GetCRS(reading.Path()) == "EPSG:32721");
}

TEST_CASE("SBET: the yaw is the true heading less the meridian convergence", "[SBET]")
{
  for (const double heading : { 0.0, 30.0, 200.0 })
  {
    Record record = MakeRecord(0, 49.0, 11.5);
    record[9] = heading * Degree;
    Reading reading;
    reading.Reader->SetTargetCRS("EPSG:32632");
    REQUIRE(reading.Read({ record }));
    const double convergence = ComputeConvergence(49.0 * Degree, 2.5 * Degree);
    const double yaw = GetHeading(reading.ToWorld(0, Forward));
    CHECK(
      std::remainder(yaw - (heading * Degree - convergence), 2 * Pi) == Approx(0.0).margin(1e-8));
    CHECK((reading.ToWorld(0, Up) - Up).Norm() < 1e-9);
  }
}

TEST_CASE("SBET: heading, pitch, roll in this order, less the wander angle", "[SBET]")
{
  Record record = MakeRecord(0, 49.0, 9.0); // no convergence
  record[7] = 20.0 * Degree;
  record[8] = 30.0 * Degree;
  record[9] = 95.0 * Degree;
  record[10] = 5.0 * Degree;
  Reading reading;
  REQUIRE(reading.Read({ record }));
  // To the east, nose 30 degrees up whatever the roll; then 20 degrees about the nose, right down.
  const Vec3 nose = reading.ToWorld(0, Forward);
  CHECK((nose - Vec3(std::cos(30 * Degree), 0, 0.5)).Norm() < 1e-8);
  const Vec3 right = reading.ToWorld(0, Right);
  CHECK(right[2] == Approx(-std::sin(20 * Degree) * std::cos(30 * Degree)).margin(1e-8));
  CHECK(right[1] == Approx(-std::cos(20 * Degree)).margin(1e-8)); // to the south
}

TEST_CASE("SBET: velocities are turned by wander angle and convergence", "[SBET]")
{
  Record record = MakeRecord(0, 49.0, 11.5);
  record[10] = 20.0 * Degree;
  record[4] = 30.0;  // along x, which is 20 degrees west of north: azimuth 0 - 20
  record[5] = -40.0; // to the right of it
  record[6] = 2.0;
  Reading reading;
  reading.Reader->SetTargetCRS("EPSG:32632");
  REQUIRE(reading.Read({ record, MakeRecord(1, 49.0, 11.5) }));
  vtkDataArray* velocities = reading.Path()->GetPointData()->GetArray(names::Velocity);
  REQUIRE(velocities);
  REQUIRE(velocities->GetNumberOfTuples() == 2);
  const Vec3 found(velocities->GetTuple3(0));
  const double convergence = ComputeConvergence(49.0 * Degree, 2.5 * Degree);
  const double azimuth = std::atan2(40.0, 30.0) - 20.0 * Degree - convergence;
  CHECK(found[0] == Approx(50.0 * std::sin(azimuth)).margin(1e-6));
  CHECK(found[1] == Approx(50.0 * std::cos(azimuth)).margin(1e-6));
  CHECK(found[2] == Approx(2.0).margin(1e-6));
  CHECK(Vec3(velocities->GetTuple3(1)).Norm() == 0.0);
}

TEST_CASE("SBET: a file whose velocities are all 0 has none", "[SBET]")
{
  Reading reading;
  REQUIRE(reading.Read({ MakeRecord(0), MakeRecord(1) }));
  CHECK_FALSE(reading.Path()->GetPointData()->HasArray(names::Velocity));
}

TEST_CASE("SBET: rows that are left out take their velocities with them", "[SBET]")
{
  std::vector<Record> records;
  for (int i = 0; i < 5; ++i)
  {
    records.push_back(MakeRecord(i, 49.0 + 1e-5 * (i < 3 ? i : 2), 9.0));
    records.back()[4] = i;
  }
  Reading reading;
  reading.Reader->SetTargetCRS("ENU 49 9 250");
  reading.Reader->SetSlopeFilterThreshold(0.1);
  REQUIRE(reading.Read(records));
  vtkDataArray* velocities = reading.Path()->GetPointData()->GetArray(names::Velocity);
  REQUIRE(velocities);
  REQUIRE(velocities->GetNumberOfTuples() < 5);
  for (vtkIdType i = 0; i < velocities->GetNumberOfTuples(); ++i)
  {
    CHECK(velocities->GetComponent(i, 1) == Approx(reading.GetTime(i)).margin(1e-6));
  }
}

TEST_CASE("SBET: a local system tilts with the distance from its origin", "[SBET]")
{
  Reading reading;
  reading.Reader->SetTargetCRS("ENU 49 9 250");
  REQUIRE(reading.Read({ MakeRecord(0, 49.0, 9.0), MakeRecord(1, 50.0, 9.0) }));
  CHECK(reading.GetPosition(0).Norm() < 1e-8);
  CHECK((reading.ToWorld(0, Up) - Up).Norm() < 1e-9);
  CHECK(
    (reading.ToWorld(1, Up) - Vec3(0, std::sin(1 * Degree), std::cos(1 * Degree))).Norm() < 1e-9);
}

TEST_CASE("SBET: a file cut within a record is refused with its byte", "[SBET]")
{
  Reading reading;
  const std::string bytes = ToBytes({ MakeRecord(0), MakeRecord(1) });
  CHECK(reading.TrajectoryReading::FailsWith(bytes.substr(0, 200),
    "a.trj: has 200 bytes, no whole number of SBET records of 136 bytes; it ends within record 1, "
    "which starts at byte 136; copy the complete file again, or truncate it to 136 bytes"));
  CHECK(reading.TrajectoryReading::FailsWith("", "is empty; give an SBET file"));
  reading.Reader->SetFileName("nowhere.sbet");
  CHECK(!reading.Update());
  CHECK(reading.Log->HasError("nowhere.sbet"));
}

TEST_CASE("SBET: bad numbers are errors with record, byte, value and cure", "[SBET]")
{
  Reading reading;
  const auto fails = [&reading](int field, double value, const std::string& part)
  {
    Record record = MakeRecord(1);
    record[static_cast<std::size_t>(field)] = value;
    return reading.FailsWith({ MakeRecord(0), record }, part);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(fails(0, nan, "a.trj, record 1 (byte 136): time is nan; give finite numbers"));
  CHECK(fails(8, INFINITY, "record 1 (byte 136): pitch is inf; give finite numbers"));
  CHECK(fails(10, nan, "wander angle is nan"));
  CHECK(fails(5, nan, "record 1 (byte 136): velocity y is nan; give finite numbers"));
  CHECK(fails(1, 49.0, "latitude is 49, outside [-pi/2, pi/2]; SBET has angles in radians"));
  CHECK(fails(2, -80.0, "longitude is -80, outside [-2 pi, 2 pi]; SBET has angles in radians"));
  CHECK(fails(0, 0.0, "time is 0 s, not after that of the record before, 0 s; split the file"));
  CHECK(fails(0, -1.0, "time is -1 s, not after that of the record before, 0 s"));
  CHECK(reading.Read({ MakeRecord(0), MakeRecord(1) }));
  Record record = MakeRecord(1); // fields that are not read
  record[11] = record[16] = nan;
  CHECK(reading.Read({ MakeRecord(0), record }));
}

TEST_CASE("SBET: unsuitable systems are errors", "[SBET]")
{
  Reading reading;
  reading.Reader->SetTargetCRS("EPSG:4326");
  CHECK(reading.FailsWith({ MakeRecord(0) }, "a.trj: TargetCRS EPSG:4326 (WGS 84) is in degrees"));
  reading.Reader->SetTargetCRS("nonsense");
  CHECK(reading.FailsWith({ MakeRecord(0) }, "TargetCRS \"nonsense\" is not a coordinate system"));
  reading.Reader->SetTargetCRS("EPSG:32632");
  reading.Reader->SetFileCRS("EPSG:32632");
  CHECK(reading.FailsWith({ MakeRecord(0) }, "give a geographic system, since SBET has latitudes"));
  reading.Reader->SetFileCRS("nonsense");
  CHECK(
    reading.FailsWith({ MakeRecord(0) }, "a.trj: FileCRS \"nonsense\" is not a coordinate system"));
  reading.Reader->SetFileCRS("EPSG:4979");
  CHECK(reading.FailsWith({ MakeRecord(0), MakeRecord(1, 49.0, 120.0) }, "record 1 (byte 136)"));
}

TEST_CASE("SBET: a system that moves against that of the scene is named", "[SBET]")
{
  Reading reading;
  reading.Reader->SetFileCRS("EPSG:7912"); // ITRF2014
  reading.Reader->SetTargetCRS("EPSG:25832");
  REQUIRE(reading.Read({ MakeRecord(0), MakeRecord(1) }));
  CHECK(reading.Log->HasWarning("coordinates move by 2.5 cm a year, and their epoch is not known"));
  CHECK(reading.Log->HasWarning("convert the trajectory before, or name the datum of the scene"));
  reading.Reader->SetFileCRS("EPSG:4937"); // ETRS89
  reading.Log->Clear();
  REQUIRE(reading.Read({ MakeRecord(0), MakeRecord(1) }));
  CHECK_FALSE(reading.Log->HasWarning("epoch"));
}

TEST_CASE("SBET: the format is found by the ending of the name", "[SBET]")
{
  vtkNew<vtkHeliosTrajectoryReader> reader;
  for (const char* name : { "a.sbet", "a.SBET", "sbet_mission 1.out" })
  {
    reader->SetFileName(name);
    CHECK(reader->IsSbet());
  }
  for (const char* name : { "a.txt", "sbet", "a.tum" })
  {
    reader->SetFileName(name);
    CHECK(!reader->IsSbet());
  }
  reader->SetFileFormatToSbet();
  CHECK(reader->IsSbet());
}

namespace
{

/// Samples with any attitude in a system.
vtkSmartPointer<vtkPolyData> MakeSamples(const std::string& crs, const Vec3& origin, double start)
{
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (int i = 0; i < 50; ++i)
  {
    const double s = i;
    points->InsertNextPoint(origin[0] + 300 * s, origin[1] - 20 * s, origin[2] + s);
    Quaternion q(std::cos(s), std::sin(1 + s), std::cos(2 * s), std::sin(3 * s));
    orientations->InsertNextTuple((q * (1.0 / q.Norm())).GetData());
  }
  samples->SetPoints(points);
  samples->GetPointData()->AddArray(orientations);
  helios::AddColumn<vtkDoubleArray>(samples->GetPointData(), names::GpsTime, 50,
    [start](vtkIdType i) { return start + 0.5 * static_cast<double>(i); });
  helios::SetCRS(samples, crs);
  return samples;
}

/// A writer of a file that the reader reads.
struct Writing : Reading
{
  vtkNew<vtkHeliosSBETWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Problems = helios::WatchErrors(Writer);

  Writing() { this->Writer->SetFileName((this->Folder / "b.sbet").c_str()); }

  bool ReadBack(const std::string& crs)
  {
    this->Reader->SetFileName(this->Writer->GetFileName());
    this->Reader->SetTargetCRS(crs);
    return this->Update();
  }
  bool Refuses(vtkPolyData* samples, const std::string& part)
  {
    this->Problems->Clear();
    return !this->Writer->Write(samples) && this->Problems->HasError(part);
  }
};

} // namespace

TEST_CASE("SBET: what is written is read back, in any system", "[SBET]")
{
  struct Place
  {
    const char* Crs;
    Vec3 Origin;
  };
  const Place places[] = { { "EPSG:32632", { 691000, 5334000, 900 } },
    { "ENU 49 9 250", { 100, -200, 500 } }, { "EPSG:28992", { 85000, 447000, 400 } } };
  for (const Place& place : places)
  {
    Writing writing;
    const auto samples = MakeSamples(place.Crs, place.Origin, 1e5);
    writing.Reader->SetFileCRS("EPSG:4979");
    if (std::string(place.Crs) == "EPSG:28992") // on its own datum, no grid is needed
    {
      writing.Writer->SetFileCRS("EPSG:4289");
      writing.Reader->SetFileCRS("EPSG:4289");
    }
    REQUIRE((writing.Writer->Open() && writing.Writer->Write(samples) && writing.Writer->Close()));
    CHECK(writing.Writer->GetNumberOfRecords() == 50);
    REQUIRE(writing.ReadBack(place.Crs));
    REQUIRE(writing.CountRows() == 50);
    for (vtkIdType i = 0; i < 50; ++i)
    {
      CHECK(writing.GetTime(i) == 1e5 + 0.5 * static_cast<double>(i));
      CHECK((writing.GetPosition(i) - Vec3(samples->GetPoint(i))).Norm() < 1e-6);
      const Quaternion q(samples->GetPointData()->GetArray(names::Orientation)->GetTuple4(i));
      CHECK(helios::Distance(writing.GetOrientation(i), q) < 1e-8);
    }
    CHECK(writing.Path()->GetPointData()->HasArray(names::Velocity));
  }
}

TEST_CASE("SBET: velocities are north, west and up", "[SBET]")
{
  for (const bool hasArray : { false, true })
  {
    Writing writing;
    const auto samples = MakeSamples("ENU 49 9 250", { 0, 0, 0 }, 0);
    if (hasArray)
    {
      vtkNew<vtkDoubleArray> velocities;
      velocities->SetName(names::Velocity);
      velocities->SetNumberOfComponents(3);
      for (int i = 0; i < 50; ++i)
      {
        velocities->InsertNextTuple3(1, 2, 3);
      }
      samples->GetPointData()->AddArray(velocities);
    }
    REQUIRE((writing.Writer->Open() && writing.Writer->Write(samples) && writing.Writer->Close()));
    Record record{};
    std::ifstream file(writing.Writer->GetFileName(), std::ios::binary);
    file.read(reinterpret_cast<char*>(record.data()), sizeof record);
    const Vec3 expected = hasArray ? Vec3(1, 2, 3) : Vec3(600, -40, 2);
    CHECK(record[4] == Approx(expected[1]).margin(1e-7));
    CHECK(record[5] == Approx(-expected[0]).margin(1e-7));
    CHECK(record[6] == Approx(expected[2]).margin(1e-7));
    CHECK(record[10] == 0.0);
  }
}

TEST_CASE("SBET: blocks that cannot be stored are refused with the row", "[SBET]")
{
  Writing writing;
  REQUIRE(writing.Writer->Open());
  CHECK(writing.Refuses(MakeSamples("", { 0, 0, 0 }, 0),
    "the block has no field data CRS, and CRS is not set; give the system of its points"));
  CHECK(writing.Refuses(MakeSamples("nonsense", { 0, 0, 0 }, 0), "CRS \"nonsense\" is not"));
  const auto samples = MakeSamples("EPSG:32632", { 500000, 5400000, 100 }, 0);
  REQUIRE(writing.Writer->Write(samples));
  CHECK(writing.Refuses(samples,
    "row 0 of a block: GpsTime is 0 s, not after that of the sample before, 24.5 s; SBET times "
    "increase"));
  const auto zero = MakeSamples("EPSG:32632", { 500000, 5400000, 100 }, 100);
  zero->GetPointData()->GetArray(names::Orientation)->SetTuple4(7, 0, 0, 0, 0);
  CHECK(writing.Refuses(zero, "row 7 of a block: its time or orientation is not finite"));
  CHECK(writing.Writer->Write(MakeSamples("EPSG:32632", { 500000, 5400000, 100 }, 100)));
  CHECK(writing.Writer->Close());
  CHECK(std::filesystem::file_size(writing.Writer->GetFileName()) == 100 * 136);
  writing.Writer->SetFileCRS("EPSG:32632");
  REQUIRE(writing.Writer->Open());
  CHECK(writing.Refuses(samples, "give a geographic system, since SBET has latitudes"));
  writing.Writer->SetFileCRS("nonsense");
  CHECK(writing.Refuses(samples, "FileCRS \"nonsense\" is not a coordinate system"));
}
