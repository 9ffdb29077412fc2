// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Vegetation grids from .vox files: valid files and errors.
#include "heliosVoxTesting.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace names = vtkHeliosArrayNames;
using namespace helios::vox;

TEST_CASE("VoxelReader: positions and values of voxels", "[VoxelReader]")
{
  Reading reading(Head + Columns + Rows);
  REQUIRE(reading.Read());
  vtkImageData* grid = reading.Grid();
  REQUIRE(grid->GetNumberOfCells() == 24);
  const double bounds[6] = { -1.5, 0.5, 2, 3.5, 100.25, 101.25 };
  for (int i = 0; i < 6; ++i)
  {
    CHECK(grid->GetBounds()[i] == bounds[i]);
  }
  CHECK(reading.Get(names::PAD, 0) == 0.5);
  CHECK(std::isnan(reading.Get(names::PAD, 1)));
  CHECK(reading.Get(names::PAD, 12 + 4 + 2) == 2.25);
  CHECK(reading.Get(names::PAD, 23) == 0.1);
  CHECK(reading.Get(names::PAD, 2) == 0.0); // missing in the file
  CHECK(reading.Get(names::Transmittance, 0) == 0.75);
  CHECK(std::isnan(reading.Get(names::Transmittance, 1)));
  CHECK(reading.Get(names::Transmittance, 2) == 1.0);
  CHECK(reading.Get(names::Transmittance, 18) == 0.0);
  CHECK(grid->GetFieldData()->GetArray(names::MaximumPAD)->GetTuple1(0) == 3.5);
  CHECK_FALSE(grid->GetFieldData()->GetArray(names::LeafProjection));
}

TEST_CASE("VoxelReader: other orders of header lines and columns", "[VoxelReader]")
{
  SECTION("columns by name")
  {
    Reading reading("#split: 2 1 1\n#res: 2 #min_corner: 0 0 0\nmy forest\n"
                    "Transmittance K x J i DENSITY\n0.5 0 oak 0 1 7 more\n");
    reading.Reader->SetPADColumn("density");
    REQUIRE(reading.Read());
    CHECK(reading.Get(names::PAD, 1) == 7.0);
    CHECK(reading.Get(names::Transmittance, 1) == 0.5);
    CHECK_FALSE(reading.Grid()->GetFieldData()->GetArray(names::MaximumPAD));
  }
  SECTION("no names: the usual columns")
  {
    Reading reading(Head + Rows);
    REQUIRE(reading.Read());
    CHECK(reading.Get(names::PAD, 18) == 2.25);
    CHECK(reading.Get(names::Transmittance, 0) == 0.75);
  }
  SECTION("the upper corner of a grid that was larger by some cells")
  {
    Reading reading("#min_corner: 0 0 0\n#max_corner: 1 1 10.25\n#split: 2 2 18\n#res: 0.5\n"
                    "i j k PadBVTotal\n1 1 17 3\n");
    CHECK_FALSE(reading.Read()); // 2.5 of 18 cells
    Reading cut("#min_corner: 0 0 0\n#max_corner: 1 1 9.4\n#split: 2 2 18\n#res: 0.5\n"
                "i j k PadBVTotal\n1 1 17 3\n");
    REQUIRE(cut.Read());
    CHECK(cut.Grid()->GetBounds()[5] == 9.0);
  }
  SECTION("a size from the corners, and no transmittance")
  {
    Reading reading(
      "#min_corner: 0 0 0\n#max_corner: 1 4 9\n#split: 2 4 3\ni j k PadBVTotal\n0 0 0 1\n");
    REQUIRE(reading.Read());
    CHECK(reading.Grid()->GetSpacing()[0] == 0.5);
    CHECK(reading.Grid()->GetSpacing()[2] == 3.0);
    CHECK_FALSE(reading.Grid()->GetCellData()->GetArray(names::Transmittance));
  }
}

TEST_CASE("VoxelReader: leaf angle table", "[VoxelReader]")
{
  Reading reading(Head + Columns + Rows);
  reading.Write("lad.txt", "x,y,z,G\n# planophile\n0,0,1,0.85\n1,0,0,0.4\n\n0.5; 0; 0.5; 0.6\n");
  reading.Reader->SetLeafTableFileName((reading.Folder / "lad.txt").c_str());
  REQUIRE(reading.Read());
  vtkDataArray* table = reading.Grid()->GetFieldData()->GetArray(names::LeafProjection);
  REQUIRE(table);
  REQUIRE(table->GetNumberOfTuples() == 3);
  CHECK(table->GetComponent(0, 3) == 0.85);
  CHECK(table->GetComponent(2, 0) == 0.5);
  for (const char* text : { "0,0,1\n", "0,0,0,1\n", "0,0,1,-1\n", "0,0,1,0.5,7\n", "0,0,1,nan\n" })
  {
    reading.Write("lad.txt", text);
    reading.Reader->Modified();
    reading.Log->Clear();
    CHECK_FALSE(reading.Read());
    CHECK(reading.Log->HasError("lad.txt:1: "));
    CHECK(reading.Log->HasError("is not a row of a leaf-angle table; write x,y,z,G"));
  }
  reading.Write("lad.txt", "# nothing\n");
  reading.Reader->Modified();
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("lad.txt: has no rows x,y,z,G"));
}

TEST_CASE("VoxelReader: damaged files are errors", "[VoxelReader]")
{
  struct Wrong
  {
    std::string Text;
    std::string Message;
  };
  const std::string small =
    "#min_corner: 0 0 0\n#split: 2 2 2\n#res: 1\ni j k PadBVTotal transmittance\n";
  const std::vector<Wrong> cases = {
    { "", "a.vox: has no cells" },
    { Head + Columns, "a.vox: has no cells" },
    { "#split: 2 2 2\n#res: 1\n0 0 0 1\n", "a.vox:3: the cells come before #min_corner" },
    { "#min_corner: 0 0 0\n#res: 1\n0 0 0 1\n", "a.vox:3: the cells come before #split" },
    { "#min_corner: 0 0 0\n#split: 2 2 2\n0 0 0 1\n", "a.vox:3: cells have no size" },
    { "#min_corner: 0 0\n", "a.vox:1: #min_corner: \" 0 0\" is not valid: expected three numbers" },
    { "#min_corner: 0 0 x\n", "is not valid" },
    { "#min_corner: 0 0 0 0\n", "is not valid" },
    { "#min_corner: 0 0 nan\n", "is not valid" },
    { "#split: 2 2 0\n", "#split: \" 2 2 0\" is not valid" },
    { "#split: 2 2 1.5\n", "a.vox:1: #split has a number that is not whole" },
    { "#res: 0,5\n", "#res: \" 0,5\" is not valid: expected a number greater than 0" },
    { "#res: -1\n", "is not valid" },
    { "#max_pad: much\n", "#max_pad: \" much\" is not valid" },
    { "#min_corner: 0 0 0\n#split: 99999 99999 99999\n#res: 1\n0 0 0 1\n",
      "a.vox:4: #split makes 99999 x 99999 x 99999 cells" },
    { "#min_corner: 0 0 0\n#max_corner: 1 2 2\n#split: 2 2 2\n#res: 1\n0 0 0 1\n",
      "#max_corner is not where #min_corner, #split and #res end along axis 0" },
    { "#min_corner: 0 0 0\n#split: 2 2 2\n#res: 1\ni j k density\n",
      "a.vox:4: no column is called PadBVTotal" },
    { small + "0 0 0 1 1\n0 0 2 1 1\n", "a.vox:6: k is 2, but #split has 2 cells" },
    { small + "0 -1 0 1 1\n", "j is -1" },
    { small + "0.5 0 0 1 1\n", "\"0.5\" in column i is not a whole number" },
    { small + "0 0 0 1,5 1\n", "\"1,5\" in column PadBVTotal is not a number" },
    { small + "0 0 0 -1 1\n", "a.vox:5: PadBVTotal is -1.000000; give 0 or more" },
    { small + "0 0 0 inf 1\n", "PadBVTotal is inf" },
    { small + "0 0 0 1 1.5\n", "transmittance is 1.5" },
    { small + "0 0 0 1\n", "\"\" in column transmittance is not a number" },
    { small + "0 0 0 1 1\n1 0 0 1 1\n0 0 0 2 1\n", "a.vox:7: cell 0 0 0 comes a second time" },
    { Head + "i j k PadBVTotal a transmittance\n0 0 0 1\n",
      "the row ends before its column transmittance" },
  };
  for (const Wrong& wrong : cases)
  {
    Reading reading(wrong.Text);
    INFO(wrong.Text);
    CHECK_FALSE(reading.Read());
    INFO(reading.Log->Errors);
    CHECK(reading.Log->HasError(wrong.Message));
  }
  Reading reading(Head + Columns + Rows);
  reading.Reader->SetMaximumNumberOfCells(23);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("has 24 cells, more than MaximumNumberOfCells (23)"));
  reading.Reader->SetFileName((reading.Folder / "none.vox").c_str());
  reading.Reader->Update();
  CHECK(reading.Log->HasError("none.vox: cannot be read"));
  reading.Reader->SetFileName(nullptr);
  reading.Reader->Update();
  CHECK(reading.Log->HasError("FileName is not set"));
}

TEST_CASE("VoxelReader: a million voxels, and an abort", "[VoxelReader]")
{
  std::string text = "#min_corner: 0 0 0\n#split: 100 100 100\n#res: 0.1\ni j k PadBVTotal\n";
  for (int cell = 0; cell < 1000000; ++cell)
  {
    text += std::to_string(cell % 100) + ' ' + std::to_string(cell / 100 % 100) + ' ' +
      std::to_string(cell / 10000) + ' ' + std::to_string(cell % 7) + '\n';
  }
  Reading reading(text);
  REQUIRE(reading.Read());
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < 1000000; ++cell)
  {
    sum += std::abs(reading.Get(names::PAD, cell) - static_cast<double>(cell % 7));
  }
  CHECK(sum == 0.0);
  vtkNew<helios::ErrorObserver> unused;
  reading.Reader->Modified();
  struct Abort : public vtkCommand
  {
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  };
  auto abort = vtkSmartPointer<Abort>::Take(new Abort);
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("reading was aborted here; update again to read it"));
}
