// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPLYPointReader.h"

#include "heliosPlyHeader.h"
#include "heliosPlySource.h"
#include "heliosSceneCrs.h"
#include "heliosTextFile.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <new>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosPLYPointReader);

namespace
{

constexpr vtkIdType RowsPerBlock = 1 << 14;
constexpr double LargestWhole = 9007199254740992.0; // 2^53: doubles hold whole numbers below

constexpr int VtkTypes[] = { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
  VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE };

/// The integers that vtkhelios stores as floats.
constexpr struct
{
  const char* Name;
  int VtkType;
} WholeTypes[] = { { "int64", VTK_TYPE_INT64 }, { "uint64", VTK_TYPE_UINT64 },
  { "uint16", VTK_TYPE_UINT16 } };

/// A property as an array, or as a coordinate.
struct Column
{
  std::string Name;
  int Axis = -1; // axis of a coordinate
  int VtkType = VTK_DOUBLE;
  const char* TypeName = "";
  double Low = 0.0; // range of the values of the type
  double High = 0.0;
  std::vector<double> Values; // values of the rows read last
  vtkSmartPointer<vtkDataArray> Array;

  bool IsReal() const { return this->VtkType == VTK_FLOAT || this->VtkType == VTK_DOUBLE; }

  void SetRange()
  {
    this->High = this->VtkType == VTK_FLOAT ? std::numeric_limits<float>::max()
      : this->IsReal()                      ? std::numeric_limits<double>::max()
                       : std::min(vtkDataArray::GetDataTypeMax(this->VtkType), LargestWhole);
    this->Low = this->IsReal()
      ? -this->High
      : std::max(vtkDataArray::GetDataTypeMin(this->VtkType), -LargestWhole);
  }

  /// Returns whether a value is one of the type.
  bool Accepts(double value) const
  {
    return value >= this->Low && value <= this->High ? this->IsReal() || std::floor(value) == value
                                                     : this->IsReal() && !std::isfinite(value);
  }

  std::string DescribeWrong(double value) const
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.10g", value);
    return this->Name + " is " + text + ", not of type " + this->TypeName + "; correct it";
  }
};

template <typename T>
void Copy(const std::vector<double>& values, T* to)
{
  std::transform(
    values.begin(), values.end(), to, [](double value) { return static_cast<T>(value); });
}

} // namespace

/// The vertices of a file, read in their order.
class vtkHeliosPLYPointReader::Vertices
{
public:
  explicit Vertices(const std::string& path)
    : Path(path)
  {
  }

  helios::Status Open()
  {
    const helios::Status status = this->Header.Read(this->Path, helios::PlyContent::Points);
    if (!status.IsOk())
    {
      return status;
    }
    std::string error;
    this->Source = helios::OpenPlySource(this->Path, this->Header, error);
    for (const helios::PlyProperty& property : this->Header.Find("vertex")->Properties)
    {
      this->AddColumn(property);
    }
    return error.empty() ? this->ReadEpoch() : helios::Status::Error(error);
  }

  const std::string& GetPath() const { return this->Path; }
  helios::PlyStorage GetStorage() const { return this->Header.Storage; }
  vtkIdType GetSize() const { return this->Header.Find("vertex")->Count; }
  vtkIdType GetNext() const { return this->Next; }

  /// Reads the rows up to a number; without a cloud they are skipped.
  helios::Status Read(vtkIdType end, vtkPolyData* cloud)
  {
    const vtkIdType begin = this->Next;
    if (cloud)
    {
      this->MakeArrays(end - begin, cloud);
    }
    while (this->Next < end)
    {
      const vtkIdType at = this->Next - begin;
      const helios::Status status = this->ReadBlock(std::min(RowsPerBlock, end - this->Next));
      if (!status.IsOk())
      {
        return status;
      }
      if (cloud)
      {
        this->StoreBlock(at);
      }
    }
    return {};
  }

private:
  void AddColumn(const helios::PlyProperty& property)
  {
    const int* axes = this->Header.Axes;
    const auto axis = std::find(axes, axes + 3, static_cast<int>(this->Columns.size())) - axes;
    Column column;
    column.Name = property.Name;
    column.Axis = axis < 3 ? static_cast<int>(axis) : -1;
    column.VtkType = axis < 3 ? VTK_DOUBLE : VtkTypes[static_cast<int>(property.Type)];
    column.TypeName = helios::GetName(property.Type);
    const auto mark = this->Header.Marks.find("type:" + property.Name);
    for (const auto& whole : WholeTypes)
    {
      if (mark != this->Header.Marks.end() && mark->second == whole.Name && axis == 3)
      {
        column.VtkType = whole.VtkType;
        column.TypeName = whole.Name;
      }
    }
    column.SetRange();
    this->Columns.push_back(column);
    this->Types.push_back(property.Type);
    this->Row.push_back(0.0);
  }

  helios::Status ReadEpoch()
  {
    const std::string& text = this->Header.Marks["epoch"];
    helios::TextWords words(text);
    const bool isNumber = words.Next(this->Epoch) == helios::TextWords::Number::Good;
    return text.empty() || (isNumber && std::isfinite(this->Epoch) && !words.HasMore())
      ? helios::Status()
      : helios::Status::Error(this->Path + ": gives " + helios::Quote(text) +
          " as the origin of its times, which is not a number; correct it");
  }

  /// Adds the names by number, in marks of the form name:ARRAY:NUMBER, from 0 without a gap.
  void AddNames(vtkFieldData* fields) const
  {
    for (const char* array :
      { vtkHeliosFoliageArrayNames::SpeciesName, vtkHeliosFoliageArrayNames::OrganName })
    {
      vtkNew<vtkStringArray> names;
      names->SetName(array);
      const std::string key = std::string("name:") + array + ":";
      auto mark = this->Header.Marks.find(key + "0");
      while (mark != this->Header.Marks.end())
      {
        names->InsertNextValue(mark->second);
        mark = this->Header.Marks.find(key + std::to_string(names->GetNumberOfValues()));
      }
      names->GetNumberOfValues() > 0 ? fields->AddArray(names) : 0;
    }
  }

  void MakeArrays(vtkIdType rows, vtkPolyData* cloud)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(rows);
    cloud->SetPoints(points);
    for (Column& column : this->Columns)
    {
      if (column.Axis >= 0)
      {
        column.Array = points->GetData();
        continue;
      }
      column.Array =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(column.VtkType));
      column.Array->SetName(column.Name.c_str());
      column.Array->SetNumberOfValues(rows);
      cloud->GetPointData()->AddArray(column.Array);
    }
    helios::SetCRS(cloud, this->Header.Marks["crs"]);
    this->AddNames(cloud->GetFieldData());
    if (this->Epoch != 0.0)
    {
      vtkNew<vtkDoubleArray> epoch;
      epoch->SetName(vtkHeliosArrayNames::GpsEpoch);
      epoch->InsertNextValue(this->Epoch);
      cloud->GetFieldData()->AddArray(epoch);
    }
  }

  helios::Status ReadBlock(vtkIdType rows)
  {
    for (Column& column : this->Columns)
    {
      column.Values.resize(static_cast<std::size_t>(rows));
    }
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row, ++this->Next)
    {
      helios::Status status = this->ReadRow(row);
      if (!status.IsOk())
      {
        return helios::Status::Error(
          this->Source->GetPlace("vertex", this->Next) + status.Message());
      }
    }
    return {};
  }

  helios::Status ReadRow(std::size_t row)
  {
    if (!this->Source->StartRow() || !this->Source->ReadAll(this->Types, this->Row.data()) ||
      !this->Source->EndRow())
    {
      return helios::Status::Error(this->Source->GetError());
    }
    const double* value = this->Row.data();
    for (Column& column : this->Columns)
    {
      if (!column.Accepts(*value))
      {
        return helios::Status::Error(column.DescribeWrong(*value));
      }
      column.Values[row] = *value++;
    }
    return {};
  }

  void StoreBlock(vtkIdType at)
  {
    for (const Column& column : this->Columns)
    {
      if (column.Axis >= 0)
      {
        double* to = static_cast<double*>(column.Array->GetVoidPointer(3 * at)) + column.Axis;
        for (const double value : column.Values)
        {
          *to = value;
          to += 3;
        }
        continue;
      }
      switch (column.VtkType)
      {
        vtkTemplateMacro(
          Copy(column.Values, static_cast<VTK_TT*>(column.Array->GetVoidPointer(at))));
      }
    }
  }

  std::string Path;
  helios::PlyHeader Header;
  std::unique_ptr<helios::PlySource> Source;
  std::vector<Column> Columns;
  std::vector<helios::PlyType> Types; // types of the columns
  std::vector<double> Row;            // values of a row of the file
  double Epoch = 0.0;
  vtkIdType Next = 0; // the row that is read next
};

//------------------------------------------------------------------------------
vtkHeliosPLYPointReader::vtkHeliosPLYPointReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosPLYPointReader::~vtkHeliosPLYPointReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosPLYPointReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "NumberOfVertices: " << this->NumberOfVertices << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPLYPointReader::GetFormat() const
{
  return this->File ? helios::GetName(this->File->GetStorage()) : "";
}

//------------------------------------------------------------------------------
int vtkHeliosPLYPointReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
/// Opens the file, unless the piece follows those that were read from it.
helios::Status vtkHeliosPLYPointReader::ReadPiece(int piece, int pieces, vtkPolyData* cloud)
{
  const auto getRow = [this, pieces](int i)
  { return this->NumberOfVertices / pieces * i + this->NumberOfVertices % pieces * i / pieces; };
  helios::Status status;
  if (piece == 0 || !this->File || this->File->GetPath() != this->FileName ||
    this->File->GetNext() > getRow(piece))
  {
    this->File = std::make_unique<Vertices>(this->FileName);
    status = this->File->Open();
    this->NumberOfVertices = status.IsOk() ? this->File->GetSize() : 0;
  }
  status = status.IsOk() ? this->File->Read(getRow(piece), nullptr) : status;
  return status.IsOk() ? this->File->Read(getRow(piece + 1), cloud) : status;
}

//------------------------------------------------------------------------------
int vtkHeliosPLYPointReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "FileName is not set; give the PLY file with SetFileName");
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* wanted = outputVector->GetInformationObject(0);
  const int pieces = std::max(1, wanted->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  const int piece = wanted->Get(Pipeline::UPDATE_PIECE_NUMBER());
  if (piece < 0 || piece >= pieces)
  {
    return 1; // no part of the file
  }
  helios::Status status;
  vtkPolyData* cloud = vtkPolyData::GetData(outputVector);
  try
  {
    status = this->ReadPiece(piece, pieces, cloud);
  }
  catch (const std::bad_alloc&)
  {
    status = helios::Status::Error(
      std::string(this->FileName) + ": not enough memory for its points; request it in pieces");
  }
  if (!status.IsOk())
  {
    this->File.reset();
    cloud->Initialize();
    vtkErrorMacro(<< status.Message());
  }
  return status.IsOk() ? 1 : 0;
}
