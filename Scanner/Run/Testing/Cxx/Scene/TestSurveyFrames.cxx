// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts that deform by frames, compared with closed forms.
#include "heliosSurveyChanges.h"
#include "heliosSurveyPlaying.h"
#include "heliosVelocityEchoes.h"

#include <vtkMath.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace helios::test;
using helios::Vec3;

namespace
{

/// Writes a frame that is a sphere of a radius about (1, 2, 3), of squares and triangles.
void WriteSphere(const Files& files, const std::string& name, double radius)
{
  constexpr int rows = 12;
  constexpr int columns = 2 * rows;
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i <= rows; ++i)
  {
    for (int k = 0; k < columns; ++k)
    {
      const double a = vtkMath::Pi() * i / rows;
      const double b = 2.0 * vtkMath::Pi() * k / columns;
      text << "v " << 1.0 + radius * std::sin(a) * std::cos(b) << ' '
           << 2.0 + radius * std::sin(a) * std::sin(b) << ' ' << 3.0 - radius * std::cos(a) << '\n';
    }
  }
  for (int i = 0; i < rows; ++i)
  {
    for (int k = 0; k < columns; ++k)
    {
      const int p = 1 + i * columns + k;
      const int q = 1 + i * columns + (k + 1) % columns;
      text << "f " << p << ' ' << q << ' ' << q + columns << ' ' << p + columns << '\n';
    }
  }
  files.Write(name, text.str());
}

/// Writes a frame that is a level plane.
void WritePlane(const Files& files, const std::string& name, double z)
{
  std::ostringstream text;
  text.precision(17);
  text << "v 7 7 7\nv -50 -50 " << z << "\nv 50 -50 " << z << "\nv 50 50 " << z << "\nv -50 50 "
       << z << "\nf 2 3 4 5\n"; // the first vertex is not used
  files.Write(name, text.str());
}

/// Adds a filter frames to the floor, or others in its place.
void AddFrames(const Files& files, const std::string& pattern, const std::string& parameters,
  const std::string& scene, const std::string& others = "")
{
  files.Replace("scene.xml", "key=\"filepath\" value=\"plane.obj\"",
    "key=\"efilepath\" value=\"" + pattern + "\"");
  files.Replace("scene.xml", "</part>",
    "<filter type=\"frames\">" + parameters + "</filter>" + others + "</part>");
  files.Replace("scene.xml", "<scene id=\"s\"", "<scene id=\"s\" " + scene);
}

std::string Param(const std::string& key, const std::string& value)
{
  return "<param key=\"" + key + "\" value=\"" + value + "\"/>";
}

/// A plane that rises by 0.25 m a frame.
void AddRisingPlane(const Files& files, const std::string& parameters, const std::string& scene,
  const std::string& others = "", int frames = 10)
{
  for (int i = 0; i < frames; ++i)
  {
    WritePlane(files, "up_" + std::to_string(8 + i) + ".obj", 0.25 * i); // 8, 9, 10: by number
  }
  AddFrames(files, R"(up_\d+\.obj)", parameters, scene, others);
}

/// Straight distance from a point to a plane at a height, along a beam.
void CheckHeights(Echoes& echoes, const std::function<double(double)>& getHeight)
{
  REQUIRE(echoes.Count() > 10000);
  for (vtkIdType i = 0; i < echoes.Count(); ++i)
  {
    const double time = echoes.Get(names::GpsTime, i);
    REQUIRE(std::abs(echoes.GetPoint(i)[2] - getHeight(time)) < 1e-6);
  }
}

} // namespace

TEST_CASE("SurveyFrames: a plane that rises from frame to frame", "[SurveyFrames]")
{
  Files files;
  const int subRays = GENERATE(1, 7, 0);
  const std::string motion =
    GENERATE("motion=\"continuous\"", "", "dynTimeStep=\"0.01\"", "dynTimeStep=\"0.3\"");
  AddRisingPlane(files, Param("framesPerSecond", "8") + Param("tStart", "0.0625"), motion);
  Echoes echoes(files, Tripod, OneLeg, subRays);
  constexpr double speed = 2.0; // [m/s]
  const double step = motion.find("0.01") != std::string::npos ? 0.01
    : motion.find("0.3") != std::string::npos                  ? 0.3
                                                               : 0.0;
  if (subRays == 1)
  {
    CheckHeights(echoes,
      [step](double time)
      {
        const double seen = step > 0.0 ? std::floor(time / step + 1e-9) * step : time;
        return speed * (seen + 0.0625);
      });
  }
  echoes.CheckVelocities([](const Vec3&, double) { return Vec3(0.0, 0.0, speed); }, AtRest, 1e-9);
}

TEST_CASE("SurveyFrames: the plane is rotated, scaled and moved, and drives", "[SurveyFrames]")
{
  Files files;
  const std::string others = R"(<filter type="rotate"><param key="rotation">
<rot axis="x" angle_deg="180"/></param></filter><filter type="scale"><param key="scale" value="2"/></filter>
<filter type="translate"><param key="offset" value="0;0;1"/></filter>
<dmotion loop="0"><motion type="translation" vec="0;0;-0.03"/></dmotion>)";
  AddRisingPlane(
    files, Param("framesPerSecond", "8"), "motion=\"continuous\" dynTimeStep=\"0.01\"", others);
  Echoes echoes(files, Tripod, OneLeg, 1);
  CheckHeights(echoes, [](double time) { return 1.0 - 2.0 * 2.0 * time - 3.0 * time; });
  echoes.CheckVelocities([](const Vec3&, double) { return Vec3(0.0, 0.0, -7.0); }, AtRest, 1e-9);
}

TEST_CASE("SurveyFrames: a part is mounted on one that deforms where it stands", "[SurveyFrames]")
{
  Files files;
  const std::string mesh = "<filter type=\"objloader\"><param type=\"string\" key=\"filepath\" "
                           "value=\"plane.obj\"/></filter>";
  AddRisingPlane(files, Param("framesPerSecond", "8"), "motion=\"continuous\" dynTimeStep=\"0.01\"",
    "<filter type=\"translate\"><param key=\"offset\" value=\"0;0;-100\"/></filter>");
  files.Replace("scene.xml", "</scene>",
    "<part id=\"lid\" mount=\"floor\">" + mesh +
      "<dmotion loop=\"0\"><motion type=\"translation\" "
      "vec=\"0;0;-0.03\"/></dmotion></part></scene>");
  Echoes echoes(files, Tripod, OneLeg, 1);
  CheckHeights(echoes, [](double time) { return -3.0 * time; });
  echoes.CheckVelocities([](const Vec3&, double) { return Vec3(0.0, 0.0, -3.0); }, AtRest, 1e-9);
}

TEST_CASE("SurveyFrames: what the survey finds after the last frame", "[SurveyFrames]")
{
  Files files;
  const std::string end = GENERATE("hold", "loop");
  AddRisingPlane(
    files, Param("framesPerSecond", "8") + Param("atEnd", end), "motion=\"continuous\"", "", 4);
  Echoes echoes(files, Tripod, OneLeg, 1);
  CheckHeights(echoes,
    [&end](double time)
    {
      if (end == "hold")
      {
        return std::min(2.0 * time, 0.75);
      }
      const double place = std::fmod(8.0 * time, 4.0); // from the last frame back to the first
      return place < 3.0 ? 0.25 * place : 0.75 * (4.0 - place);
    });
}

TEST_CASE("SurveyFrames: a sphere that breathes", "[SurveyFrames]")
{
  Files files;
  for (int i = 0; i < 5; ++i)
  {
    WriteSphere(files, "ball" + std::to_string(i) + ".obj", 1.0 + 0.3 * i * (4 - i) / 4.0);
  }
  AddFrames(files, R"(ball\d\.obj)", Param("framesPerSecond", "10") + Param("atEnd", "loop"),
    "motion=\"continuous\"",
    R"(<filter type="translate"><param key="offset" value="1;1;-1"/></filter>)");
  const int subRays = GENERATE(1, 0);
  Echoes echoes(files, Tripod, R"(<leg><platformSettings x="-4" y="3" z="0.3"/>
<scannerSettings scanFreq_hz="50" headRotatePerSec_deg="10" headRotateStart_deg="260"
headRotateStop_deg="280"/></leg>)",
    subRays);
  const auto getRadius = [](double time, double& speed)
  {
    const double place = std::fmod(10.0 * time, 5.0);
    const auto radius = [](int i) { return 1.0 + 0.3 * (i % 5) * (4 - i % 5) / 4.0; };
    const int from = static_cast<int>(place);
    speed = 10.0 * (radius(from + 1) - radius(from));
    return radius(from) + (place - from) * (radius(from + 1) - radius(from));
  };
  const Vec3 center(2.0, 3.0, 2.0);
  const double flat = std::cos(vtkMath::Pi() / 12.0); // the middle of a face is not on the sphere
  for (vtkIdType i = 0; subRays == 1 && i < echoes.Count(); ++i)
  {
    double speed = 0.0;
    const double distance =
      (echoes.GetPoint(i) - center).Norm() / getRadius(echoes.Get(names::GpsTime, i), speed);
    REQUIRE(distance < 1.0 + 1e-6);
    REQUIRE(distance > flat * flat - 1e-6);
  }
  // Every point moves away from the centre in proportion to its distance.
  const auto getVelocity = [&](const Vec3& p, double time)
  {
    double speed = 0.0;
    const double radius = getRadius(time, speed);
    return (speed / radius) * (p - center);
  };
  // Echoes of several faces have a point beside them.
  const double tolerance = subRays == 1 ? 1e-6 : 1e-2;
  echoes.CheckVelocities(getVelocity, AtRest, tolerance, tolerance);
}

TEST_CASE("SurveyFrames: files do not depend on blocks", "[SurveyFrames]")
{
  Files files;
  AddRisingPlane(files, Param("framesPerSecond", "40") + Param("atEnd", "loop"),
    GENERATE("motion=\"continuous\"", "dynTimeStep=\"0.005\""));
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  std::vector<std::string> texts;
  for (const int pulses : { 100000, 7001 })
  {
    Playing playing(files, reading);
    playing.Player->SetPulsesPerBlock(pulses);
    playing.Player->SetOverwrite(true);
    REQUIRE(playing.Player->Run());
    texts.push_back(ReadText(files / "out/test/leg001_points.xyz"));
  }
  CHECK(texts[0].size() > 100000);
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("SurveyFrames: PLY files are frames, too", "[SurveyFrames]")
{
  Files files;
  for (int i = 0; i < 3; ++i)
  {
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         << "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         << "-50 -50 " << i << "\n50 -50 " << i << "\n50 50 " << i << "\n-50 50 " << i
         << "\n4 0 1 2 3\n";
    files.Write("p" + std::to_string(i) + ".ply", text.str());
  }
  files.Replace("scene.xml", "objloader", "plyloader");
  AddFrames(files, R"(p\d\.ply)", Param("framesPerSecond", "1"), "motion=\"continuous\"");
  Echoes echoes(files, Tripod, OneLeg, 1);
  CheckHeights(echoes, [](double time) { return time; });
}

TEST_CASE("SurveyFrames: bad frames are errors", "[SurveyFrames]")
{
  struct Row
  {
    std::function<void(const Files&)> Change;
    std::string Parameters;
    std::string Message;
  };
  const std::string rate = Param("framesPerSecond", "8");
  const auto same = [](const Files&) {};
  const Row row = GENERATE_COPY(
    Row{ same, "", "scene.xml:3: filter frames of part floor has no framesPerSecond; add <param" },
    Row{ same, rate + Param("animation", "walk"),
      "has an animation, \"walk\", which only gltfloader plays; remove it" },
    Row{ same, rate + Param("efilepath", "up_8.obj"),
      "needs at least two files; add <param key=\"efilepath\"" },
    Row{ [](const Files& files) { std::filesystem::remove(files / "up_10.obj"); }, rate,
      "frame 10 is missing between up_9.obj and up_11.obj; add it, or number the frames" },
    Row{ [](const Files& files) { WritePlane(files, "up_09.obj", 1.0); }, rate,
      "up_09.obj and up_9.obj have the same number; give a pattern that finds one of them" },
    Row{ [](const Files& files) { WritePlane(files, "up_.obj", 1.0); },
      rate + Param("efilepath", "up_.*\\.obj"),
      "up_.obj has no number in its name; number the frames" },
    Row{ [](const Files& files) { WriteSphere(files, "up_10.obj", 1.0); }, rate,
      "scene.xml:3: part floor: frames up_8.obj and up_10.obj are no frames of one mesh: they "
      "have 5 "
      "and 312 vertices, 1 and 288 faces; write all frames with" },
    Row{ [](const Files& files) { files.Replace("up_10.obj", "f 2 3 4 5", "f 2 3 5 4"); }, rate,
      "they have 5 vertices, 1 faces with other vertices; write" },
    Row{ [](const Files& files) { files.Replace("up_8.obj", "f 2 3 4 5", ""); }, rate,
      "up_8.obj has no triangles; give frames with faces" },
    Row{ [](const Files& files)
      { files.Replace("scene.xml", "</part>", "<filter type=\"repair\"/></part>"); },
      rate, "does not work with filter repair, which changes the triangles" },
    Row{ [](const Files& files) { files.Replace("scene.xml", "objloader", "stlloader"); }, rate,
      "works with objloader, plyloader and gltfloader, and this part has stlloader; convert" },
    Row{ same, Param("framesPerSecond", "10"),
      "part floor: frames up_8.obj to up_17.obj have times of the survey from 0 s to 0.9 s, but a "
      "leg "
      "lasts from 0 s to 1 s; set atEnd to loop or hold" },
    Row{ same, rate + Param("tStart", "-0.5"), "from 0.5 s to 1.625 s, but a leg lasts from 0 s" },
    Row{ same, rate + Param("atEnd", "stop"), "stop" });
  Files files;
  AddRisingPlane(files, row.Parameters, "");
  row.Change(files);
  const Reading reading(files, Tripod, OneLeg);
  if (!reading.Good)
  {
    INFO(reading.Log->Errors << "\nexpected: " << row.Message);
    CHECK(reading.Log->HasError(row.Message));
    return;
  }
  Playing playing(files, reading);
  CHECK_FALSE(playing.Player->Run());
  INFO(playing.Log->Errors << "\nexpected: " << row.Message);
  CHECK(playing.Log->HasError(row.Message));
}
