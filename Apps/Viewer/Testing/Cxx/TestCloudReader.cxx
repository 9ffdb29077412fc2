// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloud.h"
#include "heliosCloudReader.h"
#include "heliosSceneCrs.h"
#include "heliosTempFolder.h"
#include "heliosViewerTest.h"
#include "vtkHeliosLASWriter.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"

#include <catch2/catch.hpp>

#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <cstring>
#include <fstream>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

/// Three echoes of pulses 41, 42, 42.
vtkSmartPointer<vtkPolyData> MakeThree()
{
  auto echoes = MakeEchoes({ { 500000.25, 10, 1 }, { 500001.25, 20, 2 }, { 500002.25, 30, 3 } });
  AddColumn(echoes, names::Amplitude, { 1e-9, 2e-9, 3e-9 });
  AddColumn(echoes, names::EchoWidth, { 4, 4, 4 });
  AddColumn<vtkTypeInt64Array>(echoes, names::ReturnNumber, { 1, 1, 2 });
  AddColumn<vtkTypeInt64Array>(echoes, names::NumberOfReturns, { 1, 2, 2 });
  AddColumn<vtkTypeInt64Array>(echoes, names::PulseIds, { 41, 42, 42 });
  AddColumn<vtkTypeInt64Array>(echoes, names::PartIds, { 1, 0, 1 });
  AddColumn<vtkTypeInt64Array>(echoes, names::ClassificationIds, { 2, 5, 6 });
  AddColumn(echoes, names::GpsTime, { 0.5, 0.75, 0.75 });
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  parts->InsertNextValue("oak tree");
  parts->InsertNextValue("house");
  echoes->GetFieldData()->AddArray(parts);
  return echoes;
}

template <typename Writer>
void WriteWith(const std::string& path, vtkPolyData* echoes)
{
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Write(echoes) && writer->Close()));
}

void CheckThird(const Cloud& cloud, vtkIdType count)
{
  REQUIRE(cloud.GetNumberOfPoints() == count);
  const Echo echo = cloud.GetEcho(2);
  CHECK(std::abs(echo.Position[0] - 500002.25) < 1e-4);
  CHECK(echo.Position[1] == 30.0);
  CHECK(echo.Position[2] == 3.0);
}

} // namespace

TEST_CASE("CloudReader: text files of vtkHelios are read with every column")
{
  const TempFolder folder;
  WriteWith<vtkHeliosPointTextWriter>(folder / "leg012_points.xyz", MakeThree());
  WriteText(folder / "leg012_trajectory.txt", "0 0 9 0.0 0 0 0\n1 0 9 1.0 0 0 0\n");
  CloudReader reader;
  Cloud cloud;
  REQUIRE(reader.Read(folder / "leg012_points.xyz", cloud).IsOk());
  CheckThird(cloud, 6);
  const Echo echo = cloud.GetEcho(2);
  CHECK(echo.PulseId == 42);
  CHECK(echo.ReturnNumber == 2);
  CHECK(echo.NumberOfReturns == 2);
  CHECK(echo.Class == 6);
  CHECK(echo.GpsTime == 0.75);
  CHECK(echo.Leg == 12);
  CHECK(std::abs(echo.Amplitude / 3e-9 - 1.0) < 1e-3);
  CHECK(reader.PartNames == std::vector<std::string>{ "house", "oak_tree" });
  CHECK(echo.Part == 0);
  REQUIRE(reader.Trajectories.size() == 1);
  CHECK(reader.Trajectories[0]->GetNumberOfPoints() == 2);
  CHECK(reader.Trajectories[0]->GetNumberOfCells() == 1);
}

TEST_CASE("CloudReader: known part names are kept, others are numbered")
{
  const TempFolder folder;
  WriteText(folder / "a.xyz",
    "1 2 3 4 5 1 1 7 #odd 2 0.5\n1 2 3 4 5 1 1 8 17 2 0.5\n1 2 3 4 5 1 1 9 oak_tree 2 0.5\n");
  CloudReader reader;
  reader.PartNames = { "ground", "oak_tree" };
  Cloud cloud;
  REQUIRE(reader.Read(folder / "a.xyz", cloud).IsOk());
  CHECK(cloud.GetEcho(0).Part == 2);
  CHECK(cloud.GetEcho(1).Part == 17);
  CHECK(cloud.GetEcho(2).Part == 1);
  CHECK(reader.PartNames.back() == "#odd");
}

TEST_CASE("CloudReader: text with x y z first, separated by blanks, commas or semicolons")
{
  const TempFolder folder;
  WriteText(folder / "a.xyz", "500000.25 10 1\n500001.25 20 2 9\n500002.25 30 3\n");
  WriteText(folder / "a.txt", "500000.25,10,1\n500001.25,20,2\n500002.25,30,3\n");
  WriteText(folder / "a.asc", "500000.25;10;1\r\n500001.25;20;2\r\n500002.25;30;3\r\n");
  for (const char* name : { "a.xyz", "a.txt", "a.asc" })
  {
    Cloud cloud;
    CHECK(CloudReader().Read(folder / name, cloud).Message() == "");
    CheckThird(cloud, 3);
    CHECK_FALSE(cloud.Has(CloudColumn::Class));
  }
}

TEST_CASE("CloudReader: text of other programs, with names of columns and with poses")
{
  const TempFolder folder;
  WriteText(folder / "a.csv",
    "X,Y,Z,Classification\n500000.25,10,1,2\n500001.25,20,2,2\n500002.25,30,3,6\n");
  Cloud cloud;
  REQUIRE(CloudReader().Read(folder / "a.csv", cloud).Message() == "");
  CheckThird(cloud, 3);
  CHECK(cloud.GetEcho(2).Class == 6);
  WriteText(folder / "a.ptx",
    "3\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n500000 0 0 1\n"
    "0.25 10 1 0.5\n1.25 20 2 0.5\n2.25 30 3 0.5\n");
  Cloud scans;
  REQUIRE(CloudReader().Read(folder / "a.ptx", scans).Message() == "");
  CheckThird(scans, 3);
}

TEST_CASE("CloudReader: LAS, VTP, PVTP and PLY")
{
  const TempFolder folder;
  const auto echoes = MakeThree();
  WriteWith<vtkHeliosLASWriter>(folder / "leg003_points.las", echoes);
  WriteWith<vtkHeliosPointXMLWriter>(folder / "leg004_points.pvtp", echoes);
  vtkNew<vtkXMLPolyDataWriter> vtp;
  vtp->SetInputData(echoes);
  vtp->SetFileName((folder / "a.vtp").c_str());
  REQUIRE(vtp->Write() == 1);
  WriteText(folder / "a.PLY",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n0 10 1\n1 20 2\n2.25 30 3\n");

  Cloud las, pvtp, fromVtp, fromPly;
  REQUIRE(CloudReader().Read(folder / "leg003_points.las", las).Message() == "");
  CheckThird(las, 6);
  CHECK(las.GetEcho(2).Class == 6);
  CHECK(las.GetEcho(2).GpsTime == 0.75);
  REQUIRE(CloudReader().Read(folder / "leg004_points.pvtp", pvtp).Message() == "");
  CheckThird(pvtp, 6);
  CHECK(pvtp.GetEcho(5).PulseId == 42);
  CHECK(pvtp.GetEcho(5).Leg == 4);
  REQUIRE(CloudReader().Read(folder / "a.vtp", fromVtp).Message() == "");
  CheckThird(fromVtp, 3);
  CHECK(fromVtp.GetEcho(0).Part == 1);
  REQUIRE(CloudReader().Read(folder / "a.PLY", fromPly).Message() == "");
  CHECK(fromPly.GetEcho(2).Position[0] == 2.25);

  std::string binary = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty double x\n"
                       "property double y\nproperty double z\nproperty uchar ReturnNumber\n"
                       "element face 1\nproperty list uchar int corners\nend_header\n";
  for (const double value : { 500000.123456789, 1.0, 2.0 })
  {
    std::string bytes(8, '\0');
    std::memcpy(bytes.data(), &value, 8);
    binary.append(bytes.rbegin(), bytes.rend());
  }
  std::ofstream(folder / "b.ply", std::ios::binary) << binary << '\3';
  Cloud doubles;
  REQUIRE(CloudReader().Read(folder / "b.ply", doubles).Message() == "");
  CHECK(std::abs(doubles.GetEcho(0).Position[0] - 500000.123456789) < 1e-7); // a float: 0.03
}

TEST_CASE("CloudReader: coordinates in feet become metres, degrees are an error")
{
  const TempFolder folder;
  const std::string path = folder / "a.las";
  const auto read = [&](const std::string& crs, Cloud& cloud)
  {
    const auto echoes = MakeEchoes({ { 984000.0, 200000.0, 100.0 } });
    SetCRS(echoes, crs);
    WriteWith<vtkHeliosLASWriter>(path, echoes);
    return CloudReader().Read(path, cloud);
  };
  constexpr double foot = 1200.0 / 3937.0;
  Cloud feet;
  REQUIRE(read("EPSG:2263+5703", feet).IsOk());
  CHECK(feet.GetEcho(0).Position[0] == Approx(984000.0 * foot).margin(1e-4));
  CHECK(feet.GetEcho(0).Position[2] == 100.0);
  Cloud metres;
  REQUIRE(read("EPSG:32118", metres).IsOk());
  CHECK(metres.GetEcho(0).Position[0] == 984000.0);
  WriteText(folder / "a.ply",
    "ply\nformat ascii 1.0\ncomment vtkhelios crs EPSG:2263\nelement vertex 1\nproperty float x\n"
    "property float y\nproperty float z\nproperty uchar intensity\nend_header\n984000 0 100 7\n");
  Cloud ply;
  REQUIRE(CloudReader().Read(folder / "a.ply", ply).IsOk());
  CHECK(ply.GetEcho(0).Position[0] == Approx(984000.0 * foot).margin(1e-4));
  CHECK(ply.GetEcho(0).Amplitude == Approx(7.0).epsilon(1e-3));
  WriteWith<vtkHeliosPointXMLWriter>(folder / "b.vtp",
    []
    {
      auto echoes = MakeEchoes({ { 8.7, 49.4, 100.0 } });
      SetCRS(echoes, "EPSG:4326");
      return echoes;
    }());
  Cloud degrees;
  CHECK(CloudReader().Read(folder / "b.vtp", degrees).Message() ==
    folder / "b.vtp" +
      ": EPSG:4326 (WGS 84) has degrees, and lengths are shown in metres; convert " +
      "it: vtkhelios convert --crs EPSG:32632");
  CHECK(degrees.GetNumberOfPoints() == 0);
}

TEST_CASE("CloudReader: the folder of a run, with progress")
{
  const TempFolder folder;
  WriteWith<vtkHeliosPointTextWriter>(folder / "leg000_points.xyz", MakeThree());
  WriteWith<vtkHeliosPointTextWriter>(folder / "leg002_points.xyz", MakeThree());
  WriteText(folder / "leg000_trajectory.txt", "0 0 9 0.0 0 0 0\n1 0 9 1.0 0 0 0\n");
  WriteText(folder / "leg002_trajectory.txt", "5 5 5 0.0 0 0 0\n");
  WriteText(folder / "run_summary.json",
    R"({"legs": [{"files": [{"name": "leg000_points.xyz"}, {"name": "leg000_trajectory.txt"}]},
    {"files": [{"name": "leg002_points.xyz"}, {"name": "leg002_fullwave.txt"},
    {"name": "leg002_trajectory.txt"}]}]})");
  CloudReader reader;
  std::vector<double> shares;
  vtkIdType points = 0;
  REQUIRE(reader
            .Read(folder / ".",
              [&](vtkPolyData* block, double share)
              {
                points += block->GetNumberOfPoints();
                shares.push_back(share);
                return true;
              })
            .Message() == "");
  CHECK(points == 12);
  CHECK(shares == std::vector<double>{ 0.5, 1.0 });
  CHECK(reader.Files.size() == 2);
  REQUIRE(reader.Trajectories.size() == 2);
  CHECK(reader.Trajectories[1]->GetPoint(0)[2] == 5.0);

  int blocks = 0;
  CHECK(CloudReader()
          .Read(folder / ".", [&](vtkPolyData*, double) { return ++blocks > 1; })
          .Message() == "");
  CHECK(blocks == 1); // stopped by false
}

TEST_CASE("CloudReader: errors name the file and the remedy")
{
  const TempFolder folder;
  const auto check = [&](const std::string& name, const char* text, const std::string& wanted)
  {
    if (text)
    {
      WriteText(folder / name.c_str(), text);
    }
    Cloud cloud;
    const std::string error = CloudReader().Read(folder / name.c_str(), cloud).Message();
    INFO(error);
    CHECK(error.find(folder / name.c_str()) == 0);
    CHECK(error.find(wanted) != std::string::npos);
  };
  check("none.xyz", nullptr, ": no such file or folder; check the name");
  check("a.foo", "1 2 3",
    ": not a supported cloud format; give .xyz, .txt, .asc, .csv, .pts, .ptx, .las,");
  check("empty.xyz", "", ": contains no points; nothing can be shown");
  check("blank.xyz", "\n\n", ": has no points; give a file with points");
  check("words.xyz", "1 2 3\n4 five 6\n", ":2: ");
  check("bad.xyz", "1 2 3 4 5 1 1 7 tree 2 0.5\n1 2 3 4 5 1 1 x tree 2 0.5\n",
    ":2: \"x\" in column 8 (pulse) is not a number; correct or remove the row");
  check("long.xyz", "1 2 3 4 5 1 1 7 tree 2 0.5\n1 2 3 4 5 1 1 7 tree 2 0.5 9\n",
    ":2: has 12 columns, but the first row has 11; correct or remove the row");
  check("short.xyz", "1 2 3 4 5 1 1 7 tree 2 0.5\n1 2 3 4 5 1 1 7\n",
    ":2: has 8 columns, but the first row has 11");
  check("a.las", "no LAS at all", ": is not a LAS file: it does not start with LASF");
  check("a.vtp", "<VTKFile", "a.vtp: is not complete XML; copy or write the file again");
  check("a.ply", "no PLY", ":1: is not a PLY file: its first line is not ply; check its name");
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 2\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  check("a.ply", (head + xyz + "end_header\n1 2 3\n4 five 6\n").c_str(),
    ":9: \"five\" is not a number; correct it");
  check("a.ply", (head + "end_header\n").c_str(), ":4: element vertex has no number x; vertices");
  check(".", nullptr, ": no run_summary.json in this folder; give the folder of a finished run");

  Cloud cloud;
  WriteText(folder / "run_summary.json", "{\"legs\": 3}");
  CHECK(CloudReader().Read(folder / ".", cloud).Message().find("is not the summary of a run") !=
    std::string::npos);
  WriteText(folder / "run_summary.json",
    R"({"legs": [{"files": [{"name": "leg000_points.xyz", "records": 5}]}]})");
  CHECK(CloudReader().Read(folder / ".", cloud).Message().find("leg000_points.xyz: missing") !=
    std::string::npos);
  WriteText(folder / "leg001_points.xyz", "1 2 3 4 5 1 1 7 tree 2 0.5\n");
  WriteText(folder / "leg001_trajectory.txt", "1 2\n");
  CHECK(CloudReader()
          .Read(folder / "leg001_points.xyz", cloud)
          .Message()
          .find("leg001_trajectory.txt:1") != std::string::npos);
}
