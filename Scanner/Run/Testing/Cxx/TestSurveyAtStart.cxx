// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs without the motion of parts are those of scenes with the parts at rest where they start.
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace names = vtkHeliosArrayNames;
using namespace helios::test;

namespace
{

constexpr const char* Leg = R"(<leg><platformSettings onGround="true"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="60" headRotateStart_deg="-40"
 headRotateStop_deg="40"/></leg>)";

std::string MakePart(const std::string& id, const std::string& file, const std::string& inside)
{
  return "<part id=\"" + id +
    "\"><filter type=\"objloader\"><param type=\"string\" key=\"filepath\" value=\"" + file +
    "\"/></filter>" + inside + "</part>\n";
}

std::string MakePlace(double yaw, double x, double y, double z)
{
  std::ostringstream text;
  text << "<filter type=\"rotate\"><param key=\"rotation\" type=\"rotation\"><rot axis=\"z\" "
          "angle_deg=\""
       << yaw << "\"/></param></filter><filter type=\"translate\"><param type=\"vec3\" "
       << "key=\"offset\" value=\"" << x << ";" << y << ";" << z << "\"/></filter>";
  return text.str();
}

/// A floor, and parts whose meshes are one that is used once and one that is used twice.
void WriteScene(const Files& files, const std::string& once, const std::string& twice)
{
  files.Write("wall.obj", "v -3 8 0\nv 3 9 0\nv 3 9 6\nv -3 8 7\nf 1 2 3 4\n");
  files.Write("fin.obj", "v 0 4 0\nv 2 5 0\nv 0 4 3\nv 1 5 1\nf 1 2 3\nf 1 4 3\n");
  files.Write("path.csv", "5,0,0,-30,1,2,0.5\n7,0,0,60,9,2,0.5\n"); // t, roll, pitch, yaw, x, y, z
  files.Write("scene.xml",
    "<document><scene id=\"s\" dynTimeStep=\"0.01\">\n" + MakePart("floor", "plane.obj", "") +
      MakePart("wall", "wall.obj", once) + MakePart("rest", "fin.obj", MakePlace(0, -4, 0, 0)) +
      MakePart("fin", "fin.obj", twice) + "</scene></document>");
}

/// The echoes of a run.
struct Scan
{
  Reading Survey;
  vtkNew<vtkHeliosSurveySource> Source;

  Scan(const Files& files, bool areInstances, const char* without)
    : Survey(files, Tripod, Leg)
  {
    INFO(this->Survey.Log->Errors);
    REQUIRE(this->Survey.Good);
    this->Source->SetSurvey(this->Survey.Reader->GetSurvey());
    this->Source->SetInstances(areInstances);
    this->Source->SetGenerateVelocities(true);
    this->Source->GetOptions()->SetNumberOfSubRays(1);
    this->Source->GetOptions()->SetNoise(false);
    this->Source->GetOptions()->SetWithout(without);
    this->Source->Update();
    REQUIRE(this->Source->GetOutput()->GetNumberOfPoints() > 10000);
  }

  vtkPolyData* operator->() { return this->Source->GetOutput(); }
};

/// Returns the largest distance of echoes of two runs [m], which have the same number.
double Compare(Scan& a, Scan& b)
{
  REQUIRE(a->GetNumberOfPoints() == b->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    largest =
      std::max({ largest, std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) });
  }
  return largest;
}

int CountEchoes(Scan& scan, int part)
{
  vtkDataArray* ids = scan->GetPointData()->GetArray(names::PartIds);
  int count = 0;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    count += static_cast<int>(ids->GetComponent(i, 0)) == part ? 1 : 0;
  }
  return count;
}

} // namespace

TEST_CASE("SurveyAtStart: parts stand where their trajectories begin", "[SurveyAtStart]")
{
  const bool areInstances = GENERATE(false, true);
  const std::string track = "<trajectory file=\"path.csv\"/>";
  const Files moving;
  WriteScene(moving, track, MakePlace(20, 0.5, 0, 0) + track);
  const Files resting;
  // The trajectory turns by 30 degrees about the axis through its first position.
  const double turn = 30.0 * 0.017453292519943295;
  WriteScene(resting, MakePlace(30, 1, 2, 0.5),
    MakePlace(50, 1 + 0.5 * std::cos(turn), 2 + 0.5 * std::sin(turn), 0.5));
  Scan still(moving, areInstances, "partMotion");
  Scan expected(resting, areInstances, "");
  CHECK(CountEchoes(still, 1) > 1000);
  CHECK(CountEchoes(still, 3) > 100);
  CHECK(Compare(still, expected) < 1e-4); // echoes are found to about 1e-5 m
  vtkDataArray* speeds = still->GetPointData()->GetArray(names::RadialVelocity);
  CHECK(speeds->GetRange()[0] == 0.0);
  CHECK(speeds->GetRange()[1] == 0.0);
  Scan whole(moving, areInstances, "");
  CHECK(CountEchoes(whole, 1) != CountEchoes(still, 1));
}

TEST_CASE("SurveyAtStart: parts that step stand where their filters place them", "[SurveyAtStart]")
{
  const bool areInstances = GENERATE(false, true);
  const std::string motion =
    "<dmotion loop=\"0\"><motion type=\"translation\" vec=\"0.02;0;0.01\"/></dmotion>";
  const Files moving;
  WriteScene(moving, motion, MakePlace(20, 1, 0, 0) + motion);
  const Files resting;
  WriteScene(resting, "", MakePlace(20, 1, 0, 0));
  Scan still(moving, areInstances, "partMotion");
  Scan expected(resting, areInstances, "");
  CHECK(Compare(still, expected) == 0.0);
}
