// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids written as .vox files, and read back.
#include "heliosVoxTesting.h"
#include "vtkHeliosFoliageArrayNames.h"
#include "vtkHeliosVoxelWriter.h"

#include <vtkDoubleArray.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace
{

void AddColumn(vtkImageData* grid, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  for (const double value : values)
  {
    column->InsertNextValue(value);
  }
  grid->GetCellData()->AddArray(column);
}

/// Two by one by two cells of a quarter of a metre.
vtkSmartPointer<vtkImageData> MakeGrid()
{
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->SetExtent(2, 4, 0, 1, 0, 2);
  grid->SetOrigin(10, 20, 30);
  grid->SetSpacing(0.25, 0.25, 0.25);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  AddColumn(grid, names::PAD, { 0.1, nan, 1.0 / 3.0, 0.0 });
  return grid;
}

struct Writing
{
  Writing() { this->Log->Watch(this->Writer); }

  bool Write(vtkImageData* grid)
  {
    this->Writer->SetInputData(grid);
    this->Writer->SetFileName((this->Folder / "a.vox").c_str());
    return this->Writer->Write() == 1;
  }

  std::string GetText()
  {
    std::ifstream file(this->Folder / "a.vox");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  helios::TempFolder Folder;
  vtkNew<vtkHeliosVoxelWriter> Writer;
  vtkNew<helios::ErrorObserver> Log;
};

} // namespace

TEST_CASE("VoxelWriter: the reader reads the same grid back", "[VoxelWriter]")
{
  const auto grid = MakeGrid();
  Writing writing;
  REQUIRE(writing.Write(grid));
  helios::vox::Reading reading(writing.GetText());
  REQUIRE(reading.Read());
  for (int i = 0; i < 6; ++i)
  {
    CHECK(reading.Grid()->GetBounds()[i] == grid->GetBounds()[i]);
  }
  CHECK(reading.Get(names::PAD, 0) == 0.1);
  CHECK(std::isnan(reading.Get(names::PAD, 1)));
  CHECK(reading.Get(names::PAD, 2) == 1.0 / 3.0);
  CHECK(reading.Get(names::PAD, 3) == 0.0);
  CHECK(reading.Grid()->GetFieldData()->GetArray(names::MaximumPAD)->GetTuple1(0) == 1.0 / 3.0);
}

TEST_CASE("VoxelWriter: columns of AMAPVox from the sums of beams", "[VoxelWriter]")
{
  const auto grid = MakeGrid();
  AddColumn(grid, foliage::EnteringEnergy, { 4, 0, 0, 0 });
  AddColumn(grid, foliage::InterceptedEnergy, { 1, 0, 0, 0 });
  AddColumn(grid, foliage::NumberOfBeams, { 5, 0, 0, 0 });
  AddColumn(grid, foliage::NumberOfShadowedBeams, { 2, 3, 0, 0 });
  AddColumn(grid, foliage::PathLength, { 0.5, 0, 0, 0 });
  AddColumn(grid, foliage::GroundDistance, { 7.5, 0, 0, 0 });
  AddColumn(grid, names::Transmittance, { 0.75, 0, 0, 0 });
  Writing writing;
  REQUIRE(writing.Write(grid));
  const std::string text = writing.GetText();
  CHECK(text.find("VOXEL SPACE\n#min_corner: 10.5 20 30\n#max_corner: 11 20.25 30.5\n"
                  "#split: 2 1 2\n#res: 0.25 #max_pad: 0.333") == 0);
  CHECK(text.find("\n0 0 0 0.1 nan 4 1 7 7.5 0.125 0.5 0 5 0.75 2 nan\n") != std::string::npos);
  CHECK(text.find("\n1 0 0 nan nan 0 0 3 0 nan 0 0 0 0 nan nan\n") != std::string::npos);
}

TEST_CASE("VoxelWriter: what cannot be written is an error", "[VoxelWriter]")
{
  Writing writing;
  CHECK(writing.Writer->Write() == 0);
  CHECK(writing.Log->HasError("FileName is not set"));
  writing.Writer->SetFileName("a.vox");
  CHECK(writing.Writer->Write() == 0);
  CHECK(writing.Log->HasError("no grid to write"));
  const auto grid = MakeGrid();
  grid->SetSpacing(0.25, 0.25, 0.5);
  CHECK_FALSE(writing.Write(grid));
  CHECK(writing.Log->HasError("its cells are not cubes"));
  grid->SetSpacing(0.25, 0.25, 0.25);
  grid->GetCellData()->RemoveArray(names::PAD);
  CHECK_FALSE(writing.Write(grid));
  CHECK(writing.Log->HasError("no cell array PAD"));
  writing.Log->Clear();
  writing.Writer->SetInputData(MakeGrid());
  writing.Writer->SetFileName((writing.Folder / "no/such/a.vox").c_str());
  CHECK(writing.Writer->Write() == 0);
  CHECK(writing.Log->HasError("no/such/a.vox"));
}
