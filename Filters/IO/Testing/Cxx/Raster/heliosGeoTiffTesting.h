// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// GeoTIFF files for tests, written by GDAL or byte by byte, and a reader for them.

#ifndef heliosGeoTiffTesting_h
#define heliosGeoTiffTesting_h

#include "heliosErrorObserver.h"
#include "heliosStatus.h"
#include "heliosTempFolder.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosGeoTiffSceneReader.h"

#include <cpl_string.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace helios
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A raster of heights, row by row from the top; the corner of its first pixel is (100, 200).
struct TestRaster
{
  int Columns = 4;
  int Rows = 3;
  int Bands = 1; // band b has the values + 1000 (b - 1)
  GDALDataType Type = GDT_Float64;
  std::vector<double> Values;
  std::vector<double> Transform = { 100.0, 0.5, 0.0, 200.0, 0.0, -0.5 }; // empty: none
  std::string Crs;                                                       // any GDAL definition
  std::string Unit;
  double NoData = NaN;
  bool HasNoData = false;
  double Scale = 1.0;
  double Offset = 0.0;
  std::vector<unsigned char> Mask;  // one value per pixel, 0 is a hole
  std::vector<std::string> Options; // creation options, "TILED=YES"
  int NumberOfGroundPoints = 0;

  TestRaster(int columns, int rows)
    : Columns(columns)
    , Rows(rows)
    , Values(static_cast<std::size_t>(columns) * rows)
  {
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      this->Values[i] = static_cast<double>(i);
    }
  }

  double& At(int column, int row) { return this->Values[row * this->Columns + column]; }

  void Write(const std::string& path) const
  {
    GDALRegister_GTiff();
    std::vector<const char*> options;
    for (const std::string& option : this->Options)
    {
      options.push_back(option.c_str());
    }
    options.push_back(nullptr);
    GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), this->Columns,
      this->Rows, this->Bands, this->Type, const_cast<char**>(options.data()));
    this->WritePlace(file);
    for (int band = 1; band <= this->Bands; ++band)
    {
      this->WriteBand(GDALGetRasterBand(file, band), 1000.0 * (band - 1));
    }
    if (!this->Mask.empty())
    {
      CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
      GDALCreateDatasetMaskBand(file, GMF_PER_DATASET);
      this->WriteValues(GDALGetMaskBand(GDALGetRasterBand(file, 1)), this->Mask, GDT_Byte);
    }
    GDALClose(file);
  }

private:
  template <typename T>
  void WriteValues(GDALRasterBandH band, std::vector<T> values, GDALDataType type) const
  {
    if (GDALRasterIO(band, GF_Write, 0, 0, this->Columns, this->Rows, values.data(), this->Columns,
          this->Rows, type, 0, 0) != CE_None)
    {
      throw std::runtime_error("the test's raster cannot be written");
    }
  }

  void WritePlace(GDALDatasetH file) const
  {
    OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
    OSRSetFromUserInput(crs, this->Crs.c_str());
    if (!this->Crs.empty())
    {
      GDALSetSpatialRef(file, crs);
    }
    if (!this->Transform.empty())
    {
      GDALSetGeoTransform(file, const_cast<double*>(this->Transform.data()));
    }
    std::string none;
    std::vector<GDAL_GCP> points(static_cast<std::size_t>(this->NumberOfGroundPoints));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double x = static_cast<double>(i % 2);
      const double y = static_cast<double>(i / 2);
      points[i] = { none.data(), none.data(), x, y, 7.0 + x, 50.0 - x * y, 0.0 };
    }
    if (!points.empty())
    {
      GDALSetGCPs2(file, this->NumberOfGroundPoints, points.data(), crs);
    }
    OSRDestroySpatialReference(crs);
  }

  void WriteBand(GDALRasterBandH band, double shift) const
  {
    std::vector<double> values = this->Values;
    for (double& value : values)
    {
      value += shift;
    }
    if (this->HasNoData && this->Type == GDT_Int64)
    {
      GDALSetRasterNoDataValueAsInt64(band, static_cast<std::int64_t>(this->NoData));
    }
    else if (this->HasNoData && this->Type == GDT_UInt64)
    {
      GDALSetRasterNoDataValueAsUInt64(band, static_cast<std::uint64_t>(this->NoData));
    }
    else if (this->HasNoData)
    {
      GDALSetRasterNoDataValue(band, this->NoData);
    }
    if (!this->Unit.empty())
    {
      GDALSetRasterUnitType(band, this->Unit.c_str());
    }
    if (this->Scale != 1.0 || this->Offset != 0.0)
    {
      GDALSetRasterScale(band, this->Scale);
      GDALSetRasterOffset(band, this->Offset);
    }
    this->WriteValues(band, values, GDT_Float64);
  }
};

/**
 * The bytes of a GeoTIFF of doubles in one strip, without GDAL: the tie point (0, 0) is at
 * (100, 200), the pixel size is 0.5, and GTRasterTypeGeoKey is 1 (area) or 2 (point).
 */
inline std::string MakeGeoTiffBytes(
  int columns, int rows, const std::vector<double>& values, std::uint16_t rasterType)
{
  const auto append = [](std::string& to, const auto& value)
  { to.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  constexpr std::uint16_t shortType = 3, longType = 4, doubleType = 12;
  const std::uint32_t scaleAt = 8 + 2 + 14 * 12 + 4;
  const std::uint32_t tieAt = scaleAt + 3 * 8;
  const std::uint32_t keysAt = tieAt + 6 * 8;
  const std::uint32_t valuesAt = keysAt + 12 * 2;
  const auto size = static_cast<std::uint32_t>(values.size() * 8);
  struct Entry
  {
    std::uint16_t Tag, Type;
    std::uint32_t Count, Value;
  };
  const Entry entries[14] = { { 256, longType, 1, static_cast<std::uint32_t>(columns) },
    { 257, longType, 1, static_cast<std::uint32_t>(rows) }, { 258, shortType, 1, 64 },
    { 259, shortType, 1, 1 }, { 262, shortType, 1, 1 }, { 273, longType, 1, valuesAt },
    { 277, shortType, 1, 1 }, { 278, longType, 1, static_cast<std::uint32_t>(rows) },
    { 279, longType, 1, size }, { 284, shortType, 1, 1 }, { 339, shortType, 1, 3 },
    { 33550, doubleType, 3, scaleAt }, { 33922, doubleType, 6, tieAt },
    { 34735, shortType, 12, keysAt } };
  std::string bytes("II*\0\x08\0\0\0", 8);
  append(bytes, std::uint16_t(14));
  for (const Entry& entry : entries)
  {
    append(bytes, entry.Tag);
    append(bytes, entry.Type);
    append(bytes, entry.Count);
    append(bytes, entry.Value);
  }
  append(bytes, std::uint32_t(0));
  append(bytes, std::array<double, 3>{ 0.5, 0.5, 0.0 });
  append(bytes, std::array<double, 6>{ 0.0, 0.0, 0.0, 100.0, 200.0, 0.0 });
  append(bytes, std::array<std::uint16_t, 12>{ 1, 1, 0, 2, 1024, 0, 1, 1, 1025, 0, 1, rasterType });
  for (const double value : values)
  {
    append(bytes, value);
  }
  return bytes;
}

/// A reader with recorded messages, and its output.
struct GeoTiffReading
{
  vtkNew<vtkHeliosGeoTiffSceneReader> Reader;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit GeoTiffReading(const std::string& path)
  {
    this->Log->Watch(this->Reader);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
    this->Reader->SetFileName(path.c_str());
  }
  GeoTiffReading(const TempFolder& folder, const TestRaster& raster)
    : GeoTiffReading(folder / "a.tif")
  {
    raster.Write(folder / "a.tif");
  }

  /// True if there was no error.
  bool Read()
  {
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  vtkPolyData* Scene() { return this->Reader->GetOutput(); }
  vtkIdType PointCount() { return this->Scene()->GetNumberOfPoints(); }
  vtkIdType TriangleCount() { return this->Scene()->GetNumberOfPolys(); }
  double Height(vtkIdType point) { return this->Scene()->GetPoint(point)[2]; }

  /// Why the mesh is not valid or does not face up; empty if it is and does.
  std::string FindFault()
  {
    TriangleMesh mesh;
    const Status status = mesh.Set(this->Scene());
    if (!status.IsOk())
    {
      return status.Message();
    }
    for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
    {
      const double *a = mesh.GetCorner(i, 0), *b = mesh.GetCorner(i, 1), *c = mesh.GetCorner(i, 2);
      if (!((b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1])))
      {
        return "triangle " + std::to_string(i) + " looks down";
      }
    }
    return {};
  }

private:
  // The executive repeats every error with its own message.
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
};

inline void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace helios

#endif
