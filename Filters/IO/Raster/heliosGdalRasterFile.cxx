// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGdal.h"
#include "heliosGdalDrivers.h"
#include "heliosGdalExport.h"
#include "heliosGdalFiles.h"
#include "heliosGdalMessages.h"
#include "heliosInputFile.h"
#include "heliosRasterFile.h"
#include "heliosRasterUnits.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace helios
{

namespace
{

constexpr std::int64_t SmallBlock = std::int64_t(4) << 20;  // bytes
constexpr std::int64_t LargeBlock = std::int64_t(64) << 20; // bytes
constexpr double HighestHeight = 9000.0;                    // [m], highest on Earth

std::string ToText(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.10g", std::isnan(value) ? std::abs(value) : value);
  return text;
}

// Returns the no-data value; NaN: not set.
double GetNoData(GDALRasterBandH band)
{
  int isGiven = 0;
  double value = 0.0;
  switch (GDALGetRasterDataType(band))
  {
    case GDT_Int64:
      value = static_cast<double>(GDALGetRasterNoDataValueAsInt64(band, &isGiven));
      break;
    case GDT_UInt64:
      value = static_cast<double>(GDALGetRasterNoDataValueAsUInt64(band, &isGiven));
      break;
    default:
      value = GDALGetRasterNoDataValue(band, &isGiven);
  }
  return isGiven ? value : std::numeric_limits<double>::quiet_NaN();
}

/// A band of a GeoTIFF file.
class GdalRasterFile final : public RasterFile
{
public:
  GdalRasterFile() = default;
  ~GdalRasterFile() override;

  Status Open(const std::string& path, const RasterOptions& options) override;
  const std::string& GetPath() const override { return this->Path; }
  std::int64_t GetNumberOfColumns() const override { return this->Columns; }
  std::int64_t GetNumberOfRows() const override { return this->Rows; }
  const double* GetTransform() const override { return this->Transform; }
  const std::string& GetCrs() const override { return this->Crs; }
  double CountPixels() const override;
  std::int64_t GetRowsPerBlock() const override;
  Status Read(std::int64_t firstRow, std::int64_t count, double* heights) override;
  void CheckHeights(double lowest, double highest) override;
  std::vector<std::string> GetWarnings() const override;

private:
  Status OpenDataset(const GdalMessages& messages);
  Status FindBand(int number);
  Status CheckSize() const;
  Status FindTransform();
  void FindNoData(double noData);
  Status FindScale();
  Status FindCrs(double heightUnit);
  bool ReadMask(std::int64_t firstRow, std::int64_t count);
  bool HasGap(std::int64_t column, std::int64_t row, std::int64_t columns, std::int64_t rows) const;
  void EmptyGaps(std::int64_t firstRow, std::int64_t count, double* heights) const;
  double GetHeight(double value) const { return (value * this->Scale + this->Offset) * this->Unit; }
  Status Convert(std::int64_t firstRow, std::int64_t count, double* values) const;
  void Warn(const std::string& text) { this->Warnings.push_back(this->Path + ": " + text); }
  void AddMessages(const GdalMessages& messages);

  GdalDataset Dataset;
  GDALRasterBandH Band = nullptr;
  GDALRasterBandH Mask = nullptr; // mask of the dataset, or its alpha band
  std::string Path;
  std::int64_t Columns = 0;
  std::int64_t Rows = 0;
  double Transform[6];
  std::string Crs;
  double NoData = std::numeric_limits<double>::quiet_NaN(); // in the type of the band
  bool IsSignedByte = false;
  double Scale = 1.0;
  double Offset = 0.0;
  double Unit = 1.0; // [m]
  std::vector<unsigned char> MaskRows;
  std::vector<std::string> Warnings;
  std::string FirstMessage; // first warning of GDAL
  std::int64_t NumberOfMessages = 0;
};

} // namespace

void GdalRasterFile::AddMessages(const GdalMessages& messages)
{
  if (this->NumberOfMessages == 0 && !messages.Warnings.empty())
  {
    this->FirstMessage = messages.Warnings.front();
  }
  this->NumberOfMessages += static_cast<std::int64_t>(messages.Warnings.size());
}

Status GdalRasterFile::OpenDataset(const GdalMessages& messages)
{
  if (const Status status = CheckInputFile(this->Path); !status.IsOk())
  {
    return status;
  }
  this->Dataset = OpenGdalDataset(this->Path, GDAL_OF_VERBOSE_ERROR);
  if (!this->Dataset)
  {
    return Status::Error("cannot be read as GeoTIFF or VRT: " + messages.Error +
      "; check the file (gdal_translate -of GTiff turns other formats into GeoTIFF)");
  }
  this->Columns = GDALGetRasterXSize(this->Dataset.get());
  this->Rows = GDALGetRasterYSize(this->Dataset.get());
  return InputWatch::IsOn() ? CheckGdalFiles(this->Path, this->Dataset.get()) : Status();
}

Status GdalRasterFile::FindBand(int number)
{
  const int count = GDALGetRasterCount(this->Dataset.get());
  if (number < 1 || number > count)
  {
    return Status::Error("Band " + std::to_string(number) +
      " is not in the file, whose bands are 1 to " + std::to_string(count) +
      "; set Band to one of them");
  }
  this->Band = GDALGetRasterBand(this->Dataset.get(), number);
  const GDALDataType type = GDALGetRasterDataType(this->Band);
  if (GDALDataTypeIsComplex(type))
  {
    return Status::Error("band " + std::to_string(number) + " has complex numbers (" +
      GDALGetDataTypeName(type) + "), which are not heights; choose another with Band");
  }
  const char* pixelType = GDALGetMetadataItem(this->Band, "PIXELTYPE", "IMAGE_STRUCTURE");
  this->IsSignedByte = type == GDT_Byte && pixelType && EQUAL(pixelType, "SIGNEDBYTE");
  const int flags = GDALGetMaskFlags(this->Band);
  const bool hasMask = flags != GMF_ALL_VALID && flags != GMF_NODATA;
  this->Mask = hasMask ? GDALGetMaskBand(this->Band) : nullptr;
  return {};
}

// Checks sizes. A file cannot contain more blocks than index entries (four bytes each for offset
// and size), nor a block larger than the compression ratio allows. GDAL would allocate it. A VRT
// has other files.
Status GdalRasterFile::CheckSize() const
{
  VSIStatBufL file;
  const std::string driver = GDALGetDriverShortName(GDALGetDatasetDriver(this->Dataset.get()));
  if (driver != "GTiff" || VSIStatL(this->Path.c_str(), &file) != 0)
  {
    return {};
  }
  const double size = static_cast<double>(file.st_size);
  int width = 0;
  int height = 0;
  GDALGetBlockSize(this->Band, &width, &height);
  const std::int64_t blocks =
    ((this->Columns + width - 1) / width) * ((this->Rows + height - 1) / height);
  const double blockSize = static_cast<double>(width) * height *
    GDALGetDataTypeSizeBytes(GDALGetRasterDataType(this->Band));
  const bool isCompressed =
    GDALGetMetadataItem(this->Dataset.get(), "COMPRESSION", "IMAGE_STRUCTURE") != nullptr;
  if (4.0 * static_cast<double>(blocks) > size || blockSize > (isCompressed ? 1e5 : 1.0) * size)
  {
    return Status::Error("is damaged: " + std::to_string(this->Columns) + " x " +
      std::to_string(this->Rows) + " pixels in " + std::to_string(blocks) +
      " blocks do not fit into a file of " + std::to_string(file.st_size) + " bytes; get it again");
  }
  return {};
}

Status GdalRasterFile::FindTransform()
{
  double* t = this->Transform;
  if (GDALGetGeoTransform(this->Dataset.get(), t) != CE_None)
  {
    return GDALGetGCPCount(this->Dataset.get()) > 0
      ? Status::Error(
          "has ground control points only, which do not place its pixels exactly; rectify it with "
          "gdalwarp")
      : Status::Error("is not georeferenced; give it corners with gdal_edit.py -a_ullr");
  }
  const double columns = static_cast<double>(this->Columns);
  const double rows = static_cast<double>(this->Rows);
  const double reach[2] = { std::abs(t[0]) + std::abs(t[1]) * columns + std::abs(t[2]) * rows,
    std::abs(t[3]) + std::abs(t[4]) * columns + std::abs(t[5]) * rows };
  const double column = std::hypot(t[1], t[4]);
  const double row = std::hypot(t[2], t[5]);
  const double area = std::abs(t[1] * t[5] - t[2] * t[4]);
  const double reached = reach[0] + reach[1];
  constexpr double coarsest = 1e-14; // relative to the coordinates; double has 2e-16
  if (!std::isfinite(reached) || !(std::min(column, row) > coarsest * reached) ||
    !(area > 1e-9 * column * row))
  {
    std::string numbers;
    for (int i = 0; i < 6; ++i)
    {
      numbers += (i ? ", " : "") + ToText(t[i]);
    }
    return Status::Error("has the geotransform " + numbers +
      ", in which pixels have no area; correct it with gdal_edit.py -a_ullr");
  }
  return {};
}

// Finds the no-data value, rounded to the type of the band.
void GdalRasterFile::FindNoData(double noData)
{
  const double value = std::isnan(noData) ? GetNoData(this->Band) : noData;
  constexpr double largest = std::numeric_limits<float>::max();
  const bool isFloat =
    GDALGetRasterDataType(this->Band) == GDT_Float32 && std::abs(value) <= largest;
  this->NoData = isFloat ? static_cast<double>(static_cast<float>(value)) : value;
}

Status GdalRasterFile::FindScale()
{
  this->Scale = GDALGetRasterScale(this->Band, nullptr);
  this->Offset = GDALGetRasterOffset(this->Band, nullptr);
  if (!std::isfinite(this->Scale) || this->Scale == 0.0 || !std::isfinite(this->Offset))
  {
    return Status::Error("has heights with scale " + ToText(this->Scale) + " and offset " +
      ToText(this->Offset) + "; correct them with gdal_edit.py -scale 1 -offset 0");
  }
  return {};
}

Status GdalRasterFile::FindCrs(double heightUnit)
{
  const OGRSpatialReferenceH system = GDALGetSpatialRef(this->Dataset.get());
  if (system && !OSRIsLocal(system))
  {
    this->Crs = ToWkt(system);
  }
  else if (system && !EQUAL(OSRGetName(system), "unnamed")) // else only area or point is stated
  {
    this->Warn("its coordinate system \"" + std::string(OSRGetName(system)) +
      "\" is not tied to the Earth and is ignored; to replace it, use gdal_edit.py -a_srs");
  }
  const std::string unit = GDALGetRasterUnitType(this->Band);
  this->Unit = heightUnit > 0.0 ? heightUnit : unit.empty() ? 1.0 : GetUnitInMetres(unit);
  if (this->Unit == 0.0)
  {
    return Status::Error("has heights in \"" + unit +
      "\", which is not a known unit; give its length in metres with HeightUnit");
  }
  if (this->Crs.empty())
  {
    return {};
  }
  if (heightUnit == 0.0 && unit.empty() && OSRIsProjected(system) &&
    OSRGetLinearUnits(system, nullptr) != 1.0)
  {
    this->Warn("does not give the unit of its heights, which are read as metres although its map "
               "is not in metres; set HeightUnit (metres: 1)");
  }
  this->Crs = MakeHeightsMetric(this->Crs);
  if (this->Crs.empty())
  {
    return Status::Error(
      "has a coordinate system with heights in feet that cannot be converted to metres; "
      "transform it with gdalwarp -t_srs");
  }
  return {};
}

bool GdalRasterFile::ReadMask(std::int64_t firstRow, std::int64_t count)
{
  this->MaskRows.resize(static_cast<std::size_t>(this->Columns * count));
  const int columns = static_cast<int>(this->Columns);
  const int rows = static_cast<int>(count);
  return GDALRasterIO(this->Mask, GF_Read, 0, static_cast<int>(firstRow), columns, rows,
           this->MaskRows.data(), columns, rows, GDT_Byte, 0, 0) == CE_None;
}

// Returns whether blocks of some pixels are missing in the file ("sparse").
bool GdalRasterFile::HasGap(
  std::int64_t column, std::int64_t row, std::int64_t columns, std::int64_t rows) const
{
  return GDALGetDataCoverageStatus(this->Band, static_cast<int>(column), static_cast<int>(row),
           static_cast<int>(columns), static_cast<int>(rows), GDAL_DATA_COVERAGE_STATUS_EMPTY,
           nullptr) &
    GDAL_DATA_COVERAGE_STATUS_EMPTY;
}

// Empties missing blocks, for which GDAL returns height 0.
void GdalRasterFile::EmptyGaps(std::int64_t firstRow, std::int64_t count, double* heights) const
{
  int width = 0;
  int height = 0;
  GDALGetBlockSize(this->Band, &width, &height);
  std::int64_t rows = 0;
  for (std::int64_t row = 0; row < count; row += rows)
  {
    rows = std::min(count - row, height - (firstRow + row) % height);
    for (std::int64_t column = 0; column < this->Columns; column += width)
    {
      const std::int64_t columns = std::min<std::int64_t>(this->Columns - column, width);
      const bool hasGap = this->HasGap(column, firstRow + row, columns, rows);
      for (std::int64_t i = row; hasGap && i < row + rows; ++i)
      {
        std::fill_n(
          heights + i * this->Columns + column, columns, std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
}

// Converts values to heights, NaN if missing.
Status GdalRasterFile::Convert(std::int64_t firstRow, std::int64_t count, double* values) const
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::int64_t size = this->Columns * count;
  double sum = 0.0; // NaN if a height is infinite
  for (std::int64_t i = 0; i < size; ++i)
  {
    const double value = values[i] - (this->IsSignedByte && values[i] > 127.0 ? 256.0 : 0.0);
    const bool isHole = value == this->NoData || value != value;
    const double height = this->GetHeight(value);
    sum += isHole ? 0.0 : 0.0 * height;
    values[i] = isHole ? none : height;
  }
  if (this->Mask)
  {
    for (std::int64_t i = 0; i < size; ++i)
    {
      values[i] = this->MaskRows[i] ? values[i] : none;
    }
  }
  if (sum == 0.0)
  {
    return {};
  }
  const auto* infinite =
    std::find_if(values, values + size, [](double v) { return std::isinf(v); });
  if (infinite == values + size)
  {
    return {}; // masked
  }
  return Status::Error("the height at row " +
    std::to_string(firstRow + (infinite - values) / this->Columns) + ", column " +
    std::to_string((infinite - values) % this->Columns) +
    " (from 0) is infinite; correct it, or make it the no-data value with gdal_edit.py -a_nodata");
}

GdalRasterFile::~GdalRasterFile()
{
  const GdalMessages quiet;
  this->Dataset.reset();
}

Status GdalRasterFile::Open(const std::string& path, const RasterOptions& options)
{
  this->Path = path;
  GdalMessages messages;
  RegisterGdalDrivers();
  Status status = this->OpenDataset(messages);
  if (status.IsOk())
    status = this->FindBand(options.Band);
  if (status.IsOk())
    status = this->CheckSize();
  if (status.IsOk())
    status = this->FindTransform();
  if (status.IsOk())
    status = this->FindScale();
  if (status.IsOk())
    status = this->FindCrs(options.HeightUnit);
  if (status.IsOk() && !messages.Error.empty())
    status = Status::Error(
      "is damaged: " + messages.Error + "; create it again, or repair it with gdal_edit.py");
  if (!status.IsOk())
  {
    return Status::Error(path + ": " + status.Message());
  }
  this->FindNoData(options.NoData);
  this->AddMessages(messages);
  return {};
}

Status GdalRasterFile::Read(std::int64_t firstRow, std::int64_t count, double* heights)
{
  GdalMessages messages;
  const int columns = static_cast<int>(this->Columns);
  const int rows = static_cast<int>(count);
  const bool isRead = GDALRasterIO(this->Band, GF_Read, 0, static_cast<int>(firstRow), columns,
                        rows, heights, columns, rows, GDT_Float64, 0, 0) == CE_None &&
    (!this->Mask || this->ReadMask(firstRow, count));
  if (!isRead || !messages.Error.empty())
  {
    return Status::Error(this->Path + ": rows " + std::to_string(firstRow) + " to " +
      std::to_string(firstRow + count - 1) + " (from 0) cannot be read: " + messages.Error +
      "; the file is damaged, get it again");
  }
  this->AddMessages(messages);
  const Status status = this->Convert(firstRow, count, heights);
  if (this->HasGap(0, firstRow, this->Columns, count))
  {
    this->EmptyGaps(firstRow, count, heights);
  }
  return status.IsOk() ? status : Status::Error(this->Path + ": " + status.Message());
}

std::int64_t GdalRasterFile::GetRowsPerBlock() const
{
  int width = 0;
  int height = 0;
  GDALGetBlockSize(this->Band, &width, &height);
  const std::int64_t rowSize = this->Columns * static_cast<std::int64_t>(sizeof(double));
  const std::int64_t blockSize = rowSize * height;
  const std::int64_t rows = blockSize > LargeBlock
    ? std::max<std::int64_t>(1, LargeBlock / rowSize)
    : height * std::max<std::int64_t>(1, SmallBlock / blockSize);
  return std::min(rows, this->Rows);
}

double GdalRasterFile::CountPixels() const
{
  double percent = 100.0;
  const GdalMessages quiet;
  const int status = GDALGetDataCoverageStatus(
    this->Band, 0, 0, static_cast<int>(this->Columns), static_cast<int>(this->Rows), 0, &percent);
  const double all = static_cast<double>(this->Columns) * static_cast<double>(this->Rows);
  const bool isKnown = (status & GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED) == 0 && percent >= 0.0;
  const double minimum = (status & GDAL_DATA_COVERAGE_STATUS_DATA) != 0 ? 1.0 : 0.0;
  return isKnown ? std::max(minimum, std::round(0.01 * percent * all)) : all;
}

void GdalRasterFile::CheckHeights(double lowest, double highest)
{
  if (lowest < -HighestHeight || highest > HighestHeight)
  {
    std::ostringstream text;
    text << "heights range from " << lowest << " to " << highest
         << " m; if these include pixels without height, set their value with NoDataValue";
    this->Warn(text.str());
  }
}

std::vector<std::string> GdalRasterFile::GetWarnings() const
{
  std::vector<std::string> warnings = this->Warnings;
  if (this->NumberOfMessages > 0)
  {
    warnings.push_back(this->Path + ": " + this->FirstMessage + " (" +
      std::to_string(this->NumberOfMessages) + " warnings of GDAL)");
  }
  return warnings;
}

} // namespace helios

/// Returns the function that heliosRasterFile.cxx finds by its name.
extern "C" HELIOSGDAL_EXPORT helios::RasterFile* heliosMakeRasterFile()
{
  return new helios::GdalRasterFile;
}
