// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRandom.h"
#include "heliosTrajectoryReading.h"
#include "vtkHeliosTrajectoryTextWriter.h"

#include <catch2/catch.hpp>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>

#include <cmath>
#include <cstdio>

namespace names = vtkHeliosArrayNames;
using helios::AxisAngle;
using helios::Quaternion;
using helios::Vec3;

namespace
{

const Vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

struct Reading : helios::TrajectoryReading
{
  bool IsAlong(vtkIdType row, const Vec3& body, const Vec3& world)
  {
    return (this->ToWorld(row, body) - world).Norm() < 1e-14;
  }
};

std::string Row(const std::vector<double>& numbers, const char* separator = ",")
{
  std::string text;
  for (const double number : numbers)
  {
    char word[32];
    std::snprintf(word, sizeof word, "%.17g", number);
    text += (text.empty() ? "" : separator) + std::string(word);
  }
  return text + "\n";
}

} // namespace

TEST_CASE("TrajectoryReader: rows become one polyline", "[TrajectoryReader]")
{
  Reading reading;
  REQUIRE(reading.Read("# flown by hand\n"
                       "#TIME_COLUMN: 0\r\n"
                       "#HEADER: \"t\", \"roll\", \"pitch\", \"yaw\", \"x\", \"y\", \"z\"\r\n"
                       "100.1,0,0,90,478233.51008011301,5471966.6981215651,400\r\n"
                       "\n"
                       " 100.2 ,\t0 , 0, 90,1e3,+2.5,-3 # the last\n"));
  CHECK(reading.Log->Warnings.empty());
  REQUIRE(reading.CountRows() == 2);
  CHECK(reading.Path()->GetNumberOfLines() == 1);
  CHECK(reading.Path()->GetLines()->GetNumberOfConnectivityIds() == 2);
  CHECK(reading.Path()->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(reading.GetTime(0) == 100.1);
  CHECK(reading.GetTime(1) == 100.2);
  CHECK(reading.GetPosition(0) == Vec3(478233.51008011301, 5471966.6981215651, 400));
  CHECK(reading.GetPosition(1) == Vec3(1000, 2.5, -3));
  REQUIRE(reading.Read("5, 0, 0, 0, 1, 2, 3"));
  CHECK(reading.Path()->GetNumberOfVerts() == 1);
}

TEST_CASE(
  "TrajectoryReader: ARINC 705: yaw clockwise, nose up, right side down", "[TrajectoryReader]")
{
  Reading reading;
  REQUIRE(reading.Read("0, 0, 0, 90, 0, 0, 0\n"
                       "1, 0, 30, 0, 0, 0, 0\n"
                       "2, 30, 0, 0, 0, 0, 0\n"
                       "3, 0, 30, 90, 0, 0, 0\n"
                       "4, 30, 0, 90, 0, 0, 0\n"
                       "5, 20, 30, 40, 0, 0, 0\n"));
  const double s = 0.5, c = std::sqrt(0.75);
  CHECK(reading.IsAlong(0, Y, X)); // to the east
  CHECK(reading.IsAlong(1, Y, { 0, c, s }));
  CHECK(reading.IsAlong(2, X, { c, 0, -s }));
  CHECK(reading.IsAlong(3, Y, { c, 0, s }));
  CHECK(reading.IsAlong(4, X, { 0, -c, -s }));
  CHECK(reading.IsAlong(4, Y, X));
  const Quaternion all = AxisAngle(Z, -40) * AxisAngle(Y, 20) * AxisAngle(X, 30);
  CHECK(helios::Distance(reading.GetOrientation(5), all) < 1e-15);
}

TEST_CASE("TrajectoryReader: NAVIGATION: heading, then pitch, then roll", "[TrajectoryReader]")
{
  Reading reading;
  reading.Reader->SetAngleConventionToNavigation();
  REQUIRE(reading.Read("0, 20, 30, 90, 0, 0, 0\n"));
  const double sine = std::sin(vtkMath::RadiansFromDegrees(20.0));
  const double c = std::sqrt(0.75);
  CHECK(reading.IsAlong(0, Y, Vec3(c, 0, 0.5))); // the nose, whatever the roll
  CHECK(reading.ToWorld(0, X)[2] == Approx(-sine * c).margin(1e-14));
}

TEST_CASE("TrajectoryReader: CANONICAL, and radians", "[TrajectoryReader]")
{
  Reading reading;
  reading.Reader->SetAngleConventionToCanonical();
  REQUIRE(reading.Read("0, 20, 30, 40, 0, 0, 0\n"));
  const Quaternion all = AxisAngle(X, 20) * AxisAngle(Y, 30) * AxisAngle(Z, 40);
  CHECK(helios::Distance(reading.GetOrientation(0), all) < 1e-15);
  reading.Reader->SetAngleUnitToRadians();
  REQUIRE(reading.Read(Row({ 0, vtkMath::RadiansFromDegrees(20.0),
    vtkMath::RadiansFromDegrees(30.0), vtkMath::RadiansFromDegrees(40.0), 0, 0, 0 })));
  CHECK(helios::Distance(reading.GetOrientation(0), all) < 1e-15);
}

TEST_CASE("TrajectoryReader: quaternions keep their sign through turns", "[TrajectoryReader]")
{
  Reading reading;
  std::string text;
  for (int i = 0; i < 80; ++i) // two turns
  {
    text += Row({ 1.0 * i, 0, 0, std::fmod(9.0 * i, 360.0), 0, 0, 0 });
  }
  REQUIRE(reading.Read(text));
  for (vtkIdType i = 1; i < 80; ++i)
  {
    const Quaternion a = reading.GetOrientation(i - 1), b = reading.GetOrientation(i);
    CHECK(a[0] * b[0] + a[3] * b[3] == Approx(std::cos(vtkMath::RadiansFromDegrees(4.5))));
  }
}

TEST_CASE("TrajectoryReader: selection of columns", "[TrajectoryReader]")
{
  Reading reading;
  const Vec3 place(4, 5, 6);
  const Quaternion east = AxisAngle(Z, -90);
  const auto isRight = [&reading, &place, &east]()
  {
    return reading.CountRows() == 1 && reading.GetTime(0) == 7.5 &&
      reading.GetPosition(0) == place && helios::Distance(reading.GetOrientation(0), east) < 1e-15;
  };
  CHECK((reading.Read("7.5,0,0,90,4,5,6") && isRight()));
  CHECK((reading.Read("#TIME_COLUMN: 2\n0,0,7.5,90,4,5,6") && isRight()));
  CHECK((reading.Read("# TIME_COLUMN:6 \n0,0,90,4,5,6,7.5") && isRight()));
  CHECK(
    (reading.Read("#HEADER: z, 'y', \"x\", yaw, pitch, roll, t\n6,5,4,90,0,0,7.5") && isRight()));
  SECTION("given columns override the header, and others are not read")
  {
    reading.Reader->SetTimeColumn(8);
    reading.Reader->SetRollColumn(1);
    reading.Reader->SetPitchColumn(2);
    CHECK((reading.Read("#HEADER: nonsense\nA,0,0,90,4,5,6,nan,7.5") && isRight()));
  }
  SECTION("separators")
  {
    reading.Reader->SetSeparators(" ");
    CHECK((reading.Read(" 7.5  0\t0 90  4 5 6 ") && isRight()));
    reading.Reader->SetSeparators("\t");
    CHECK((reading.Read("7.5\t0\t0\t90\t4\t5\t6") && isRight()));
    reading.Reader->SetSeparators(";");
    CHECK(
      (reading.Read("#HEADER: x; y; z; t; roll; pitch; yaw\n4; 5; 6; 7.5; 0; 0; 90") && isRight()));
  }
}

TEST_CASE(
  "TrajectoryReader: rows are sorted by time, two at one time are a jump", "[TrajectoryReader]")
{
  Reading reading;
  REQUIRE(reading.Read("3,0,0,0,3,0,0\n1,0,0,0,1,0,0\n2,0,0,0,2,0,0\n3,0,0,90,33,0,0\n"));
  REQUIRE(reading.CountRows() == 4);
  const double x[4] = { 1, 2, 3, 33 };
  for (vtkIdType i = 0; i < 4; ++i)
  {
    CHECK(reading.GetPosition(i)[0] == x[i]);
  }
  CHECK(reading.Log->HasWarning(
    "a.trj:4: the platform jumps: 1 time has two rows at different positions, the first here; give "
    "the times with more digits if it does not"));
  // A sudden turn gives no warning.
  REQUIRE(reading.Read("1,0,0,0,1,0,0\n1,0,0,90,1,0,0\n2,0,0,0,2,0,0\n2,0,0,9,2,0,0\n"));
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE(
  "TrajectoryReader: positions only: the heading is the flight direction", "[TrajectoryReader]")
{
  Reading reading;
  reading.Reader->SetDomainToPosition();
  SECTION("on a circle, also climbing: the tangent at the rows")
  {
    reading.Reader->SetTimeColumn(0);
    reading.Reader->SetXColumn(1);
    reading.Reader->SetYColumn(2);
    reading.Reader->SetZColumn(3);
    std::string text;
    for (int i = 0; i <= 36; ++i)
    {
      const double a = vtkMath::RadiansFromDegrees(10.0 * i);
      text += Row({ 0.5 * i, 100 * std::cos(a), 100 * std::sin(a), 2.0 * i });
    }
    REQUIRE(reading.Read(text));
    for (int i = 0; i <= 36; ++i)
    {
      // the ends have the direction of their segment
      const double a = vtkMath::RadiansFromDegrees(10.0 * i + (i == 0 ? 5 : (i == 36 ? -5 : 0)));
      INFO("row " << i);
      CHECK(reading.IsAlong(i, Y, { -std::sin(a), std::cos(a), 0 }));
      CHECK(reading.IsAlong(i, Z, Z));
    }
  }
  SECTION("of a parabola at uneven times: the derivative")
  {
    std::string text = "#HEADER: t, x, y, z\n";
    for (const double t : { -1.0, 0.25, 1.0, 3.0 })
    {
      text += Row({ t, 2 * t, t * t, 5 });
    }
    REQUIRE(reading.Read(text));
    for (const vtkIdType i : { 1, 2 })
    {
      const double t = reading.GetTime(i);
      const double speed = std::hypot(2, 2 * t);
      CHECK(reading.IsAlong(i, Y, { 2 / speed, 2 * t / speed, 0 }));
    }
  }
  SECTION("at rest: the previous heading, at the start the first, else north; jumps are ignored")
  {
    const std::string head = "#HEADER: t, x, y, z\n";
    REQUIRE(reading.Read(head +
      "0,0,0,0\n1,0,0,9\n2,0,0,9\n3,5,0,9\n4,5,0,9\n5,5,0,9\n5,5,-90,9\n"
      "6,5,-91,9\n"));
    for (const vtkIdType i : { 0, 1, 2, 3, 4, 5 })
    {
      INFO("row " << i);
      CHECK(reading.IsAlong(i, Y, X));
    }
    CHECK(reading.IsAlong(6, Y, -1.0 * Y));
    CHECK(reading.IsAlong(7, Y, -1.0 * Y));
    REQUIRE(reading.Read(head + "0,0,0,0\n1,0,0,9\n"));
    CHECK(reading.IsAlong(0, Y, Y));
    CHECK(reading.IsAlong(1, Y, Y));
    reading.Reader->SetMinimumSpeed(0.1);
    REQUIRE(reading.Read(head + "0,0,0,0\n1,0,3,0\n2,0,6,0\n3,0,6,0\n4,.05,6,0\n"));
    CHECK(reading.IsAlong(4, Y, Y)); // drifts at 0.05 m/s
  }
}

TEST_CASE(
  "TrajectoryReader: the slope filter keeps rows where the motion changes", "[TrajectoryReader]")
{
  Reading reading;
  reading.Reader->SetSlopeFilterThreshold(0.01);
  std::string text;
  for (int i = 0; i <= 100; ++i) // straight to 30, faster to 60, turning to 80, straight
  {
    const double x = i <= 30 ? i : 30 + 2.0 * (i - 30);
    const double yaw = i <= 60 ? 350 : 350 + std::min(20, i - 60); // through 360
    text += Row({ 1.0 * i, 0, 0, std::fmod(yaw, 360.0), x, 0, 0 });
  }
  REQUIRE(reading.Read(text));
  REQUIRE(reading.CountRows() == 5);
  const double times[5] = { 0, 30, 60, 80, 100 };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    CHECK(reading.GetTime(i) == times[i]);
  }
  // Slopes of a parabola change by 0.02 m/s per row: every third row exceeds 0.05 in total.
  reading.Reader->SetSlopeFilterThreshold(0.05);
  text.clear();
  for (int i = 0; i <= 30; ++i)
  {
    text += Row({ 1.0 * i, 0, 0, 0, 0.01 * i * i, 0, 0 });
  }
  REQUIRE(reading.Read(text));
  CHECK(reading.CountRows() == 11);
  CHECK(reading.GetTime(1) == 3.0);
  // Both rows of a jump are kept.
  REQUIRE(reading.Read("0,0,0,0,0,0,0\n1,0,0,0,1,0,0\n2,0,0,0,2,0,0\n2,0,0,0,8,0,0\n3,0,0,0,9,0,0\n"
                       "4,0,0,0,10,0,0\n"));
  REQUIRE(reading.CountRows() == 4);
  CHECK(reading.GetTime(1) == 2.0);
  CHECK(reading.GetTime(2) == 2.0);
  reading.Reader->SetSlopeFilterThreshold(0);
  CHECK((reading.Update() && reading.CountRows() == 6));
}

TEST_CASE("TrajectoryReader: output of the text writer is read back", "[TrajectoryReader]")
{
  constexpr vtkIdType count = 2000;
  vtkNew<vtkPolyData> path;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times, orientations;
  times->SetName(names::GpsTime);
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto u =
      helios::Uniform4(5, helios::RandomStream::Scene, static_cast<std::uint64_t>(i), 0);
    points->InsertNextPoint(478233.5 + 1000 * u[0], 5471966.7 - 99 * u[1], 300 * u[2]);
    times->InsertNextValue(0.001 * static_cast<double>(i) + 1e-4 * u[3]);
    Quaternion q(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5, u[3] - 0.5);
    q.Normalize();
    orientations->InsertNextTuple(q.GetData());
  }
  path->SetPoints(points);
  path->GetPointData()->AddArray(times);
  path->GetPointData()->AddArray(orientations);

  Reading reading;
  const std::string name = reading.Folder / "leg000_trajectory.txt";
  vtkNew<vtkHeliosTrajectoryTextWriter> writer;
  writer->SetFileName(name.c_str());
  REQUIRE((writer->Open() && writer->Write(path) && writer->Close()));
  reading.Reader->SetFileName(name.c_str());
  reading.Reader->UseWriterFormat();
  REQUIRE(reading.Update());
  REQUIRE(reading.CountRows() == count);
  double place = 0, time = 0, attitude = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    place = std::max(place, (reading.GetPosition(i) - Vec3(path->GetPoint(i))).Norm());
    time = std::max(time, std::abs(reading.GetTime(i) - times->GetValue(i)));
    const Quaternion q(orientations->GetTuple4(i));
    attitude = std::max(attitude, helios::Distance(reading.GetOrientation(i), q));
  }
  CHECK(place < std::sqrt(3.0) * 5.1e-5); // half of the last digits
  CHECK(time < 5.1e-10);
  CHECK(attitude < 3 * vtkMath::RadiansFromDegrees(5e-5));
}

TEST_CASE("TrajectoryReader: errors name file and line", "[TrajectoryReader]")
{
  Reading reading;
  const std::string good = "1,0,0,0,1,2,3\n";
  SECTION("rows")
  {
    CHECK(reading.FailsWith(good + "# x\n2,0,0,0,1,2\n",
      "a.trj:3: the row has 6 columns, but columns are read up to 6 from 0 (t in 0, roll in 1, "
      "pitch in 2, yaw in 3, x in 4, y in 5, z in 6); complete the row"));
    CHECK(reading.FailsWith("5\n", "a.trj:1: the row has 1 column,"));
    CHECK(reading.FailsWith(good + "2,0,0,0,1,2,nan\n",
      "a.trj:2: \"nan\" in column 6 is not finite; correct the row or remove it"));
    CHECK(
      reading.FailsWith(good + "inf,0,0,0,1,2,3\n", "a.trj:2: \"inf\" in column 0 is not finite"));
    CHECK(reading.FailsWith("1,0,0,0,1;2,2,3\n",
      "a.trj:1: \"1;2\" in column 4 is not a number of double precision; write numbers"));
    CHECK(reading.FailsWith("1,0,0,0,,2,3\n", "a.trj:1: column 4 is empty; write a number"));
    CHECK(reading.FailsWith(
      "t,roll,pitch,yaw,x,y,z\n" + good, "a.trj:1: \"t\" in column 0 is not a number"));
    CHECK(reading.FailsWith("1 0 0 0 1 2 3\n", "\"1 0 0 0 1 2 3\" in column 0 is not a number"));
  }
  SECTION("times")
  {
    CHECK(reading.FailsWith("2.5,0,0,0,1,2,3\n" + good + "2.5,0,0,0,1,2,3\n\n2.5,0,0,0,1,2,4\n",
      "a.trj:5: a third row has the time 2.5 s; one row per time is a sample, two are a jump: "
      "remove the others, or give the times with more digits"));
  }
  SECTION("no rows, no file")
  {
    CHECK(reading.FailsWith("", "a.trj: has no rows; give a file with rows of time"));
    CHECK(reading.FailsWith("# only\n\n", "a.trj: has no rows"));
    reading.Reader->SetFileName((reading.Folder / "none.trj").c_str());
    CHECK_FALSE(reading.Update());
    CHECK(reading.Log->HasError("none.trj: cannot be read: No such file"));
    reading.Reader->SetFileName(nullptr);
    CHECK_FALSE(reading.Update());
    CHECK(reading.Log->HasError("FileName is not set; give the file of the trajectory"));
  }
  SECTION("headers")
  {
    CHECK(reading.FailsWith("#HEADER: t, roll, pitch, heading\n" + good,
      "a.trj:1: HEADER names the column \"heading\", which is not one of t, roll, pitch, yaw, x, "
      "y, z; correct the name, or set the columns"));
    CHECK(reading.FailsWith("#HEADER: t, roll, t\n" + good,
      "a.trj:1: HEADER names \"t\" twice, in columns 0 and 2; remove one"));
    CHECK(reading.FailsWith("#HEADER: t, x, y, z\n1,1,2,3\n",
      "a.trj:2: HEADER does not name \"roll\"; add it, or set Domain to POSITION"));
    CHECK(reading.FailsWith("#HEADER: t, roll, pitch, yaw, x, y\n" + good,
      "a.trj:2: HEADER does not name \"z\"; add it, or set the columns"));
    CHECK(reading.FailsWith("#TIME_COLUMN: -1\n" + good,
      "a.trj:1: TIME_COLUMN is \"-1\"; give the number of the column of times, from 0 to 999"));
    CHECK(reading.FailsWith("#TIME_COLUMN: 1 2\n" + good, "TIME_COLUMN is \"1 2\""));
    CHECK(reading.FailsWith("#TIME_COLUMN: 1\n#HEADER: t, roll, pitch, yaw, x, y, z\n" + good,
      "a.trj:3: TIME_COLUMN is 1, but HEADER has t in column 0; correct one"));
    CHECK(reading.FailsWith(good + "#TIME_COLUMN: 3\n",
      "a.trj:2: TIME_COLUMN changes the columns below rows that were read"));
    CHECK(reading.Read(good + "#TIME_COLUMN: 0\n2,0,0,0,1,2,3\n")); // two files concatenated
  }
  SECTION("settings")
  {
    reading.Reader->SetXColumn(2);
    CHECK(reading.FailsWith(
      good, "a.trj:1: one column is read twice (pitch in 2, x in 2); set TimeColumn"));
    reading.Reader->SetSeparators("e");
    CHECK(reading.FailsWith(good, "Separators is \"e\"; give characters other than letters"));
  }
}

TEST_CASE("TrajectoryReader: abort", "[TrajectoryReader]")
{
  Reading reading;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* reader, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(reader)->SetAbortExecute(1); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK(reading.FailsWith("1,0,0,0,1,2,3\n", "a.trj:1: reading was aborted here; update again"));
}

TEST_CASE("TrajectoryReader: damaged files give a path or an error", "[TrajectoryReader]")
{
  const std::string good =
    "#TIME_COLUMN: 0\n#HEADER: \"t\", \"roll\", \"pitch\", \"yaw\", \"x\", \"y\", "
    "\"z\"\n1,0,0,0,1,2,3\n2.5,-1e2,+3,4,5,6,7 # z\r\n3,0,0,0,1,2,3";
  const std::string alphabet = "0123456789+-.eEnNiI,;# \"\n\r\tTHx:/\\";
  Reading reading;
  int failed = 0;
  for (std::uint64_t i = 0; i < 1500; ++i)
  {
    std::string text = good;
    for (std::uint32_t draw = 0; draw <= i % 4; ++draw)
    {
      const auto u = helios::Uniform4(9, helios::RandomStream::Scene, i, draw);
      const auto at = static_cast<std::size_t>(u[0] * static_cast<double>(text.size()));
      const auto c = static_cast<std::size_t>(u[1] * static_cast<double>(alphabet.size()));
      u[2] < 0.5 ? text.replace(at, 1, 1, alphabet[c])
                 : text.replace(at, static_cast<std::size_t>(9 * u[3]), "");
    }
    if (reading.Read(text))
    {
      REQUIRE(reading.CountRows() > 0);
    }
    else
    {
      ++failed;
      REQUIRE(reading.CountRows() == 0);
      REQUIRE(reading.Log->HasError("a.trj:"));
    }
  }
  CHECK(failed > 300);
  CHECK(failed < 1500);
}
