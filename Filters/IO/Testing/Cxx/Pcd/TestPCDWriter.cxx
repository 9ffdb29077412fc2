// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PCD files of echoes: written data are read back, block by block.
#include "heliosLasTesting.h"
#include "heliosPcdTesting.h"
#include "vtkHeliosPCDWriter.h"

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

struct Writing
{
  helios::TempFolder Folder;
  std::string Path = this->Folder / "a.pcd";
  vtkNew<vtkHeliosPCDWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(this->Writer);

  Writing() { this->Writer->SetFileName(this->Path.c_str()); }

  bool Write(vtkPolyData* echoes)
  {
    return this->Writer->Open() && this->Writer->Write(echoes) && this->Writer->Close();
  }
};

void AddNormals(vtkPolyData* echoes)
{
  vtkNew<vtkFloatArray> normals;
  helios::AddVectors(echoes, normals, names::Normals, 0.5);
  echoes->GetPointData()->SetNormals(normals);
}

/// Counts coordinates that differ by more than a tolerance.
vtkIdType CountMoved(vtkPolyData* a, vtkPolyData* b, double tolerance)
{
  return helios::CountWrong(a->GetPoints()->GetData(), b->GetPoints()->GetData(), 0, tolerance);
}

} // namespace

TEST_CASE("PCDWriter: Double restores all bits", "[PCDWriter]")
{
  const int storage = GENERATE(0, 1);
  const auto echoes = helios::MakeLasEchoes(20000);
  AddNormals(echoes);
  helios::SetCrs(echoes, "EPSG:25832");
  helios::SetEpoch(echoes, 1e9);
  Writing writing;
  writing.Writer->SetStorage(storage);
  writing.Writer->SetPrecision(vtkHeliosPCDWriter::Double);
  REQUIRE(writing.Write(echoes));
  CHECK(writing.Writer->GetNumberOfRecords() == 20000);
  CHECK(writing.Writer->GetNumberOfBytes() ==
    static_cast<vtkIdType>(helios::ReadText(writing.Path).size()));

  helios::PcdReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  REQUIRE(reading.CountPoints() == 20000);
  CHECK(CountMoved(reading.Cloud(), echoes, 0.0) == 0);
  vtkPointData* written = echoes->GetPointData();
  REQUIRE(reading.Cloud()->GetPointData()->GetNumberOfArrays() == written->GetNumberOfArrays());
  for (int i = 0; i < written->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = written->GetArray(i);
    INFO(array->GetName());
    vtkDataArray* read = reading.Get(array->GetName());
    REQUIRE(read);
    CHECK(helios::CountWrong(read, array) == 0);
    CHECK(read->GetDataTypeSize() == array->GetDataTypeSize());
  }
  CHECK(reading.Get(names::PulseIds)->GetVariantValue(3).ToTypeInt64() == 5000000003);
  CHECK(reading.Cloud()->GetFieldData()->GetArray(names::GpsEpoch)->GetTuple1(0) == 1e9);
  CHECK(reading.Cloud()->GetFieldData()->GetAbstractArray(names::CRS)->GetVariantValue(0) ==
    vtkVariant("EPSG:25832"));
}

TEST_CASE("PCDWriter: Float keeps UTM coordinates by the origin", "[PCDWriter]")
{
  const int storage = GENERATE(0, 1);
  const auto echoes = helios::MakeLasEchoes(2000); // 2 km along y
  Writing writing;
  writing.Writer->SetStorage(storage);
  REQUIRE(writing.Write(echoes));
  const std::string text = helios::ReadText(writing.Path);
  CHECK(text.find("\n# vtkHelios origin: 500200 5499000 0\n") != std::string::npos);
  CHECK(text.find("\nFIELDS x y z ") != std::string::npos);
  helios::PcdReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(CountMoved(reading.Cloud(), echoes, 1e-4) == 0);
  CHECK(CountMoved(reading.Cloud(), echoes, 0.0) > 0);
  CHECK(helios::CountWrong(
          reading.Get(names::GpsTime), echoes->GetPointData()->GetArray(names::GpsTime)) == 0);
  CHECK(reading.Get(names::Amplitude)->GetDataType() == VTK_FLOAT);
  CHECK(helios::CountWrong(reading.Get(names::Amplitude),
          echoes->GetPointData()->GetArray(names::Amplitude), 0, 1e-13) == 0);

  writing.Writer->SetOrigin(500000, 5000000, 0);
  writing.Writer->UseOriginOn();
  REQUIRE(writing.Write(echoes));
  CHECK(helios::ReadText(writing.Path).find("# vtkHelios origin: 5e+05 5e+06 0\n") !=
    std::string::npos);
  CHECK(
    writing.Log->HasWarning("mm off; set Precision to Double, or an Origin nearer to the points"));
  REQUIRE(reading.Read());
  CHECK(CountMoved(reading.Cloud(), echoes, 0.02) == 0);
}

TEST_CASE("PCDWriter: the part is valid after each block", "[PCDWriter]")
{
  const int storage = GENERATE(0, 1);
  const auto echoes = helios::MakeLasEchoes(1000);
  Writing writing;
  writing.Writer->SetStorage(storage);
  REQUIRE(writing.Writer->Open());
  vtkNew<vtkPolyData> nothing;
  REQUIRE(writing.Writer->Write(nothing));
  for (int block = 1; block <= 3; ++block)
  {
    REQUIRE(writing.Writer->Write(echoes));
    REQUIRE(writing.Writer->Flush());
    helios::PcdReading part(writing.Path + ".part");
    REQUIRE(part.Read());
    CHECK(part.CountPoints() == 1000 * block);
  }
  const vtkIdType size = writing.Writer->GetFileSize();
  const vtkIdType bytes = writing.Writer->GetNumberOfBytes();
  REQUIRE(writing.Writer->Write(echoes));
  REQUIRE(writing.Writer->Abandon());

  // resumed after the third block
  vtkNew<vtkHeliosPCDWriter> again;
  again->SetFileName(writing.Path.c_str());
  REQUIRE(again->Reopen(size, 3000, bytes));
  REQUIRE(again->Write(echoes));
  REQUIRE(again->Close());
  helios::PcdReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 4000);
  CHECK(again->GetNumberOfRecords() == 4000);
  for (vtkIdType block = 0; block < 4; ++block)
  {
    CHECK(helios::CountWrong(reading.Get(names::GpsTime),
            echoes->GetPointData()->GetArray(names::GpsTime), 1000 * block) == 0);
  }

  vtkNew<vtkHeliosPCDWriter> count;
  count->SetFileName((writing.Folder / "none.pcd").c_str());
  count->SetStorage(storage);
  count->CountOnlyOn();
  REQUIRE((count->Open() && count->Write(echoes) && count->Write(echoes) && count->Write(echoes) &&
    count->Write(echoes) && count->Close()));
  CHECK(count->GetNumberOfBytes() == again->GetNumberOfBytes());
  CHECK_FALSE(std::filesystem::exists(writing.Folder / "none.pcd"));
}

TEST_CASE("PCDWriter: no points, and points that are not finite", "[PCDWriter]")
{
  Writing writing;
  REQUIRE((writing.Writer->Open() && writing.Writer->Close()));
  helios::PcdReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 0);

  const auto echoes = helios::MakeEchoes(10);
  echoes->GetPoints()->SetPoint(4, 1.0, std::numeric_limits<double>::infinity(), 2.0);
  REQUIRE(writing.Write(echoes));
  CHECK(writing.Log->HasWarning("a.pcd: 1 of 10 points of a block are not finite: left out"));
  CHECK(writing.Writer->GetNumberOfRecords() == 9);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 9);
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE("PCDWriter: data that cannot be written are errors", "[PCDWriter]")
{
  Writing writing;
  REQUIRE(writing.Writer->Open());
  const auto echoes = helios::MakeEchoes(10);
  REQUIRE(writing.Writer->Write(echoes));
  const auto other = helios::MakeEchoes(10);
  other->GetPointData()->RemoveArray(names::PulseIds);
  CHECK_FALSE(writing.Writer->Write(other));
  CHECK(
    writing.Log->HasError("a block has other point arrays than the first one, or of other types; "
                          "write it to another file"));
  helios::AddColumn<vtkIntArray>(other->GetPointData(), "Own", 9, [](vtkIdType) { return 0; });
  CHECK_FALSE(writing.Writer->Write(other));
  CHECK(writing.Log->HasError("the point array Own of a block has 9 tuples for 10 points"));
  CHECK_FALSE(writing.Writer->Write(nullptr));
  REQUIRE(writing.Writer->Close()); // with the first block
  helios::PcdReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 10);

  Writing twice;
  REQUIRE(twice.Writer->Open());
  const auto same = helios::MakeEchoes(5);
  for (const char* name : { "a b", "a_b" })
  {
    helios::AddColumn<vtkIntArray>(same->GetPointData(), name, 5, [](vtkIdType) { return 0; });
  }
  CHECK_FALSE(twice.Writer->Write(same));
  CHECK(twice.Log->HasError("two point arrays of a block make the field a_b; rename one of them"));
  twice.Writer->Abandon();
  twice.Writer->SetOrigin(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  CHECK_FALSE(twice.Writer->Open());
  CHECK(twice.Log->HasError("Origin is (0, nan, 0); set finite numbers"));
  std::ostringstream text;
  twice.Writer->Print(text);
  CHECK(text.str().find("Precision: Float") != std::string::npos);
}

TEST_CASE("PCDWriter: a part without its header cannot be resumed", "[PCDWriter]")
{
  Writing writing;
  helios::WriteFile(writing.Path + ".part", std::string(100, 'x'));
  CHECK_FALSE(writing.Writer->Reopen(100, 1, 100));
  CHECK(writing.Log->HasError("a.pcd.part:1: unknown entry"));
}
