// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters of heights for tests.

#ifndef heliosTestRasters_h
#define heliosTestRasters_h

#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace helios
{

using GeoTransform = std::array<double, 6>;

/// North up; mirrored; rotated; rotated and sheared, in UTM; sheared and mirrored.
inline const std::vector<GeoTransform> TestTransforms = { { 100, 0.5, 0, 200, 0, -0.5 },
  { 0, 1, 0, 0, 0, 1 }, { -3, 0.6, 0.8, 7, 0.8, -0.6 },
  { 500000.3, 0.7, 0.2, 5500000.1, 0.35, -0.9 }, { 4e5, 0.3, -0.4, 5e6, 0.5, 0.9 } };

/// Heights row by row; the values of an image with its arrays.
struct HeightRaster
{
  int Columns;
  int Rows;
  GeoTransform Transform;
  std::vector<double> Values;

  HeightRaster(int columns, int rows, const GeoTransform& transform = TestTransforms[0])
    : Columns(columns)
    , Rows(rows)
    , Transform(transform)
    , Values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
  {
  }

  double& At(int column, int row)
  {
    return this->Values[static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Columns) +
      static_cast<std::size_t>(column)];
  }

  /// Hills, with white noise; rounded to floats.
  void AddHills(double height, double noise)
  {
    std::uint64_t state = 1;
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const double random = static_cast<double>(state >> 40) * 0x1p-24;
        this->At(column, row) += static_cast<float>(
          height * std::sin(0.11 * column) * std::cos(0.07 * row) + noise * random);
      }
    }
  }

  /// Pixels without height: some, a disc, and the frame of the raster.
  void AddHoles()
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t state = 7;
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const double x = column - 0.6 * this->Columns;
        const double y = row - 0.4 * this->Rows;
        const bool isFrame = column == 0 || row + 1 == this->Rows;
        if (state >> 59 == 0 || x * x + y * y < 0.01 * this->Columns * this->Rows || isFrame)
        {
          this->At(column, row) = none;
        }
      }
    }
  }

  template <typename ArrayT>
  vtkSmartPointer<vtkImageData> MakeImage() const
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(this->Columns, this->Rows, 1);
    vtkNew<ArrayT> heights;
    heights->SetName(vtkHeliosArrayNames::Heights);
    for (const double value : this->Values)
    {
      heights->InsertNextValue(static_cast<typename ArrayT::ValueType>(value));
    }
    image->GetPointData()->SetScalars(heights);
    vtkNew<vtkDoubleArray> transform;
    transform->SetName(vtkHeliosArrayNames::GeoTransform);
    for (const double value : this->Transform)
    {
      transform->InsertNextValue(value);
    }
    image->GetFieldData()->AddArray(transform);
    return image;
  }
};

} // namespace helios

#endif
