// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// COPC: the octree is checked point by point, from the bytes of the file.
#include "heliosCopcFile.h"
#include "heliosLasTesting.h"
#include "vtkHeliosCOPCWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkSMPTools.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;
using helios::GetNumber;
using helios::LasReading;
using helios::MakeLasEchoes;

namespace
{

constexpr std::size_t AtInfo = 375 + 54;
constexpr int Few = 20000;

struct Writing
{
  helios::TempFolder Folder;
  vtkNew<vtkHeliosCOPCWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(this->Writer);

  void Open(const std::string& name)
  {
    this->Writer->SetFileName((this->Folder / name).c_str());
    REQUIRE(this->Writer->Open());
  }
  void Write(const std::string& name, vtkPolyData* echoes)
  {
    this->Open(name);
    REQUIRE((this->Writer->Write(echoes) && this->Writer->Close()));
  }
  std::string Bytes(const std::string& name) const { return helios::ReadText(this->Folder / name); }
};

struct Node
{
  std::array<int, 4> Key; // level, x, y, z
  std::uint64_t Place;
  int Bytes;
  int Points;
};

/// Returns the nodes of the only page, in the order of the file.
std::vector<Node> ReadNodes(const std::string& bytes)
{
  const auto begin = GetNumber<std::uint64_t>(bytes, AtInfo + 40);
  const auto size = GetNumber<std::uint64_t>(bytes, AtInfo + 48);
  REQUIRE(begin + size == bytes.size());
  std::vector<Node> nodes;
  for (std::size_t at = begin; at < begin + size; at += 32)
  {
    Node node{};
    for (std::size_t k = 0; k < 4; ++k)
    {
      node.Key[k] = GetNumber<std::int32_t>(bytes, at + 4 * k);
    }
    node.Place = GetNumber<std::uint64_t>(bytes, at + 16);
    node.Bytes = GetNumber<std::int32_t>(bytes, at + 24);
    node.Points = GetNumber<std::int32_t>(bytes, at + 28);
    nodes.push_back(node);
  }
  std::sort(
    nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.Place < b.Place; });
  return nodes;
}

/// Returns a cell of a point in a grid over the cube of the file.
std::array<int, 3> FindCell(const std::string& bytes, const double* point, int bits)
{
  const double half = GetNumber<double>(bytes, AtInfo + 24);
  std::array<int, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double low = GetNumber<double>(bytes, AtInfo + 8 * axis) - half;
    const double share = (point[axis] - low) / (2.0 * half);
    const double end = 1.0 + 1e-9; // the largest coordinates are in the last cell
    const double inside = share >= 1.0 && share < end ? 1.0 - 1e-9 : std::max(share, -1e-12);
    cell[axis] = static_cast<int>(std::floor(std::ldexp(inside + 1e-12, bits)));
  }
  return cell;
}

/// Checks a node: its points are in its box and in the order of pulses, and it has one of each cell
/// unless it is small or the deepest.
void CheckNode(const std::string& bytes, const Node& node, LasReading& reading, vtkIdType first,
  const std::set<std::array<int, 4>>& parents)
{
  const int level = node.Key[0];
  std::set<std::array<int, 3>> cells;
  int outside = 0;
  int unsorted = 0;
  for (vtkIdType i = first; i < first + node.Points; ++i)
  {
    const double* point = reading.Cloud()->GetPoint(i);
    const auto box = FindCell(bytes, point, level);
    outside += box == std::array<int, 3>{ node.Key[1], node.Key[2], node.Key[3] } ? 0 : 1;
    cells.insert(FindCell(bytes, point, level + 7));
    unsorted += i == first ||
        reading.Get(names::PulseIds)->GetTuple1(i - 1) < reading.Get(names::PulseIds)->GetTuple1(i)
      ? 0
      : 1;
  }
  CHECK(outside == 0);
  CHECK(unsorted == 0);
  const bool isDivided = parents.count(node.Key) > 0;
  CHECK((
    isDivided ? static_cast<int>(cells.size()) == node.Points : node.Points <= Few || level == 14));
}

/// Checks the octree of a file against its points, which are those of echoes.
void CheckOctree(const std::string& path, vtkPolyData* echoes)
{
  const std::string bytes = helios::ReadText(path);
  const vtkIdType count = echoes->GetNumberOfPoints();
  const std::vector<Node> nodes = ReadNodes(bytes);
  LasReading reading(path);
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == count);
  std::set<std::array<int, 4>> keys;
  std::set<std::array<int, 4>> parents;
  for (const Node& node : nodes)
  {
    keys.insert(node.Key);
    for (std::array<int, 4> key = node.Key; key[0] > 0;)
    {
      key = { key[0] - 1, key[1] / 2, key[2] / 2, key[3] / 2 };
      parents.insert(key);
    }
  }
  CHECK(keys.size() == nodes.size());
  CHECK(std::includes(keys.begin(), keys.end(), parents.begin(), parents.end()));
  vtkIdType first = 0;
  std::uint64_t place = GetNumber<std::uint32_t>(bytes, 96) + 8;
  for (const Node& node : nodes)
  {
    CHECK(node.Place == place);
    CheckNode(bytes, node, reading, first, parents);
    first += node.Points;
    place += static_cast<std::uint64_t>(node.Bytes);
  }
  CHECK(first == count);
  // every point is there, with its attributes
  std::vector<bool> seen(static_cast<std::size_t>(count));
  int wrong = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto row =
      static_cast<vtkIdType>(reading.Get(names::PulseIds)->GetTuple1(i)) - 5000000000;
    seen[static_cast<std::size_t>(row)] = true;
    const double* truth = echoes->GetPoint(row);
    const double x = truth[0];
    const double z = truth[2];
    const double* point = reading.Cloud()->GetPoint(i);
    wrong += std::abs(point[0] - x) < 1e-3 && std::abs(point[2] - z) < 1e-3 ? 0 : 1;
    wrong += reading.Get(names::GpsTime)->GetTuple1(i) ==
        echoes->GetPointData()->GetArray(names::GpsTime)->GetTuple1(row)
      ? 0
      : 1;
  }
  CHECK(wrong == 0);
  CHECK(std::count(seen.begin(), seen.end(), true) == count);
}

/// Moves echoes to random places in a box, most of them near one corner.
void Scatter(vtkPolyData* echoes, double size)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    const double near = i % 4 == 0 ? 1.0 : 0.001;
    const double x = size * near * uniform(random);
    const double y = size * near * uniform(random);
    echoes->GetPoints()->SetPoint(i, 5e5 + x, 5.5e6 + y, 0.1 * size * near * uniform(random));
  }
}

} // namespace

TEST_CASE("COPCWriter: an octree of all points", "[COPCWriter]")
{
  Writing writing;
  const vtkIdType count = GENERATE(1, 20000, 20001, 300000);
  const auto echoes = MakeLasEchoes(count);
  Scatter(echoes, 200.0);
  writing.Write("a.copc.laz", echoes);
  CHECK(writing.Log->Errors.empty());
  CheckOctree(writing.Folder / "a.copc.laz", echoes);
  const std::string bytes = writing.Bytes("a.copc.laz");
  CHECK((ReadNodes(bytes).size() == 1) == (count <= Few));
  CHECK(writing.Writer->GetNumberOfBytes() == static_cast<vtkIdType>(bytes.size()));
  CHECK(writing.Writer->GetFileSize() == static_cast<vtkIdType>(bytes.size()));
  CHECK(writing.Writer->GetNumberOfRecords() == count);
  CHECK_FALSE(fs::exists(writing.Folder / "a.copc.laz.part"));
}

TEST_CASE("COPCWriter: the head is that of COPC 1.0", "[COPCWriter]")
{
  Writing writing;
  const auto echoes = MakeLasEchoes(100);
  helios::SetCrs(echoes, "EPSG:25832");
  writing.Write("a.copc.laz", echoes);
  const std::string bytes = writing.Bytes("a.copc.laz");
  CHECK(bytes.substr(377, 16).c_str() == std::string("copc")); // the first record
  CHECK(GetNumber<std::uint16_t>(bytes, 393) == 1);
  CHECK(GetNumber<std::uint16_t>(bytes, 395) == 160);
  const double half = GetNumber<double>(bytes, AtInfo + 24);
  CHECK(half == Approx(0.5 * 99.0).margin(1e-3)); // y has the largest extent
  CHECK(GetNumber<double>(bytes, AtInfo + 32) == Approx(2.0 * half / 128.0));
  CHECK(GetNumber<double>(bytes, AtInfo + 56) == 604799.5);
  CHECK(GetNumber<double>(bytes, AtInfo + 64) == Approx(604799.5 + 99e-5).epsilon(1e-12));
  CHECK(bytes.substr(AtInfo + 72, 88) == std::string(88, '\0'));
  const auto extended = GetNumber<std::uint64_t>(bytes, 235);
  CHECK(GetNumber<std::uint32_t>(bytes, 243) == 1);
  CHECK(bytes.substr(extended + 2, 16).c_str() == std::string("copc"));
  CHECK(GetNumber<std::uint16_t>(bytes, extended + 18) == 1000);
  CHECK(GetNumber<std::uint64_t>(bytes, extended + 20) == 32);
  CHECK(GetNumber<std::uint64_t>(bytes, AtInfo + 40) == extended + 60);
  CHECK(GetNumber<std::uint8_t>(bytes, 104) == (0x80 | 6));
  LasReading reading(writing.Folder / "a.copc.laz");
  REQUIRE(reading.Read());
  auto* crs =
    vtkStringArray::SafeDownCast(reading.Cloud()->GetFieldData()->GetAbstractArray(names::CRS));
  CHECK((crs && crs->GetValue(0).find("25832") != std::string::npos));
}

TEST_CASE("COPCWriter: points at one place are in the deepest node", "[COPCWriter]")
{
  Writing writing;
  const auto echoes = MakeLasEchoes(50000);
  for (vtkIdType i = 0; i < 49999; ++i)
  {
    echoes->GetPoints()->SetPoint(i, 10.0, 20.0, 30.0);
  }
  echoes->GetPoints()->SetPoint(49999, 110.0, 20.0, 30.0);
  writing.Write("a.copc.laz", echoes);
  CheckOctree(writing.Folder / "a.copc.laz", echoes);
  const auto nodes = ReadNodes(writing.Bytes("a.copc.laz"));
  CHECK(nodes.size() == 15);
  const auto deepest = std::max_element(
    nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.Key[0] < b.Key[0]; });
  CHECK(deepest->Key[0] == 14);
  CHECK(deepest->Points == 49999 - 14);
}

TEST_CASE("COPCWriter: byte-identical for any number of threads and blocks, and a scratch file",
  "[COPCWriter]")
{
  Writing writing;
  const auto echoes = MakeLasEchoes(120000);
  Scatter(echoes, 50.0);
  writing.Write("one.copc.laz", echoes);
  const std::string expected = writing.Bytes("one.copc.laz");
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  SECTION("threads")
  {
    for (const int other : { 1, 4 })
    {
      vtkSMPTools::Initialize(other);
      writing.Write("two.copc.laz", echoes);
      CHECK(writing.Bytes("two.copc.laz") == expected);
    }
    vtkSMPTools::Initialize(threads);
  }
  SECTION("blocks, the last of them resumed")
  {
    writing.Open("two.copc.laz");
    REQUIRE((writing.Writer->Write(echoes) && writing.Writer->EndBlock()));
    const vtkIdType size = writing.Writer->GetFileSize();
    REQUIRE((writing.Writer->Write(MakeLasEchoes(700)) && writing.Writer->Abandon()));
    REQUIRE(writing.Writer->Reopen(size, 120000, size));
    REQUIRE(writing.Writer->Close());
    CHECK(writing.Bytes("two.copc.laz") == expected);
  }
  SECTION("a scratch file of sorted runs")
  {
    writing.Writer->LeavesPartOn();
    writing.Write("two.copc.laz", echoes);
    helios::CopcFile file({}, 1 << 20); // some 8,000 points
    const std::string path = writing.Folder / "three.copc.laz";
    const helios::Status status = file.Write(writing.Folder / "two.copc.laz.part", path);
    INFO(status.Message());
    REQUIRE(status.IsOk());
    CHECK(writing.Bytes("three.copc.laz.part") == expected);
  }
}

TEST_CASE("COPCWriter: stopped, the points stay and are resumed", "[COPCWriter]")
{
  Writing writing;
  const auto echoes = MakeLasEchoes(60000);
  writing.Write("one.copc.laz", echoes);
  writing.Open("two.copc.laz");
  REQUIRE((writing.Writer->Write(echoes) && writing.Writer->EndBlock()));
  const vtkIdType size = writing.Writer->GetFileSize();
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* writer, unsigned long, void*, void*)
    { static_cast<vtkHeliosCOPCWriter*>(writer)->Abort(); });
  const unsigned long tag = writing.Writer->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK_FALSE(writing.Writer->Close());
  writing.Writer->RemoveObserver(tag);
  CHECK(writing.Writer->GetWasAborted());
  CHECK(writing.Log->Errors.empty());
  CHECK_FALSE(writing.Writer->IsOpen());
  CHECK_FALSE(fs::exists(writing.Folder / "two.copc.laz"));
  CHECK_FALSE(fs::exists(writing.Folder / "two.copc.laz.octree.part"));
  REQUIRE(writing.Writer->Reopen(size, 60000, size));
  double last = 0.0;
  writing.Writer->SetOnProgress(
    [&last](double share)
    {
      CHECK((share >= last && share <= 1.0));
      last = share;
      return true;
    });
  REQUIRE(writing.Writer->Close());
  CHECK(last == 1.0);
  CHECK(writing.Bytes("two.copc.laz") == writing.Bytes("one.copc.laz"));
}

TEST_CASE("COPCWriter: the points stay until they are removed, on request", "[COPCWriter]")
{
  Writing writing;
  writing.Writer->LeavesPartOn();
  writing.Open("a.copc.laz");
  REQUIRE((writing.Writer->Write(MakeLasEchoes(1000)) && writing.Writer->EndBlock()));
  const vtkIdType size = writing.Writer->GetFileSize();
  REQUIRE(writing.Writer->Close());
  const std::string expected = writing.Bytes("a.copc.laz");
  REQUIRE(fs::exists(writing.Folder / "a.copc.laz.part"));
  REQUIRE(writing.Writer->Reopen(size, 1000, size)); // the journal did not get to know it
  REQUIRE(writing.Writer->Close());
  CHECK(writing.Bytes("a.copc.laz") == expected);
  writing.Writer->RemovePart();
  CHECK_FALSE(fs::exists(writing.Folder / "a.copc.laz.part"));
  // never the only copy
  fs::rename(writing.Folder / "a.copc.laz", writing.Folder / "a.copc.laz.part");
  writing.Writer->RemovePart();
  CHECK(fs::exists(writing.Folder / "a.copc.laz.part"));
}

TEST_CASE("COPCWriter: a file without points, and count only", "[COPCWriter]")
{
  Writing writing;
  writing.Open("a.copc.laz");
  REQUIRE(writing.Writer->Close());
  const auto nodes = ReadNodes(writing.Bytes("a.copc.laz"));
  REQUIRE(nodes.size() == 1);
  CHECK((nodes[0].Points == 0 && nodes[0].Bytes == 0 && nodes[0].Key[0] == 0));
  LasReading reading(writing.Folder / "a.copc.laz");
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 0);
  writing.Writer->CountOnlyOn();
  writing.Open("b.copc.laz");
  REQUIRE((writing.Writer->Write(MakeLasEchoes(70000)) && writing.Writer->Close()));
  CHECK(writing.Writer->GetNumberOfBytes() > 70000);
  CHECK_FALSE(
    (fs::exists(writing.Folder / "b.copc.laz") || fs::exists(writing.Folder / "b.copc.laz.part")));
}

TEST_CASE("COPCWriter: errors", "[COPCWriter]")
{
  Writing writing;
  writing.Writer->SetFileName((writing.Folder / "a.copc.laz").c_str());
  writing.Writer->WriteWaveformsOn();
  CHECK_FALSE(writing.Writer->Open());
  CHECK(writing.Log->HasError(
    "a.copc.laz: COPC has no waveforms; switch WriteWaveforms off, or write LAZ"));
  writing.Writer->WriteWaveformsOff();
  writing.Writer->WriteCompressedOff();
  CHECK_FALSE(writing.Writer->Open());
  CHECK(writing.Log->HasError(
    "a.copc.laz: COPC has compressed points only; switch WriteCompressed on, or write LAS"));
  writing.Writer->WriteCompressedOn();
  writing.Log->Clear();
  // points that were damaged before Close()
  REQUIRE((writing.Writer->Open() && writing.Writer->Write(MakeLasEchoes(60000)) &&
    writing.Writer->EndBlock()));
  fs::resize_file(writing.Folder / "a.copc.laz.part", 3000);
  CHECK_FALSE(writing.Writer->Close());
  CHECK(writing.Log->HasError("a.copc.laz.part: "));
  CHECK_FALSE(fs::exists(writing.Folder / "a.copc.laz"));
  // other files
  helios::CopcFile file({});
  const std::string path = writing.Folder / "b.copc.laz";
  CHECK(file.Write(writing.Folder / "missing.laz", path).Message().find("missing.laz") !=
    std::string::npos);
  std::ofstream(writing.Folder / "old.las", std::ios::binary) << helios::MakeOld(2, 3, 5, 34);
  CHECK(file.Write(writing.Folder / "old.las", path).Message() ==
    (writing.Folder / "old.las") + ": is not LAZ 1.4 of point format 6, 7 or 8, which COPC needs");
  CHECK_FALSE(fs::exists(path + ".part"));
}

TEST_CASE("COPCWriter: a full disk keeps the points", "[COPCWriter]")
{
  const helios::TempFolder folder;
  const helios::SmallDisk disk(folder / "disk", 600);
  if (!disk.IsMounted())
  {
    WARN("no small disk can be mounted here: not tested");
    return;
  }
  vtkNew<vtkHeliosCOPCWriter> writer;
  const auto log = helios::WatchErrors(writer);
  const std::string path = folder / "disk/points.copc.laz";
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(MakeLasEchoes(8000)) && writer->EndBlock()));
  const vtkIdType size = writer->GetFileSize();
  REQUIRE((size > 330000 && size < 500000));
  CHECK_FALSE(writer->Close());
  CHECK(log->HasError("points.copc.laz.octree.part cannot be written: No space left on device"));
  CHECK_FALSE(fs::exists(path));
  CHECK_FALSE(fs::exists(path + ".octree.part"));
  LasReading reading(path + ".part");
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 8000);
}
