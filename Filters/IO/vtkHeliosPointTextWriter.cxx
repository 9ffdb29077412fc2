// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointTextWriter.h"

#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

vtkStandardNewMacro(vtkHeliosPointTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double NanowattsPerWatt = 1e9;

/// A column of a block; fast where it has the type that the scanner gives.
template <typename ArrayT>
class Column
{
public:
  explicit Column(vtkDataArray* array)
    : Array(array)
    , Values(ArrayT::FastDownCast(array) ? ArrayT::FastDownCast(array)->GetPointer(0) : nullptr)
  {
  }
  double operator[](vtkIdType row) const
  {
    return this->Values ? static_cast<double>(this->Values[row])
                        : this->Array->GetComponent(row, 0);
  }

private:
  vtkDataArray* Array;
  const typename ArrayT::ValueType* Values;
};

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPointTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
bool vtkHeliosPointTextWriter::Write(vtkDataObject* block)
{
  if (!this->CheckOpen())
  {
    return false;
  }
  auto* echoes = vtkPolyData::SafeDownCast(block);
  if (!echoes)
  {
    vtkErrorMacro(<< this->FileName << ": a block is not vtkPolyData");
    return false;
  }
  vtkPointData* data = echoes->GetPointData();
  vtkDataArray* arrays[8];
  int next = 0;
  for (const char* name :
    { names::Amplitude, names::EchoWidth, names::ReturnNumber, names::NumberOfReturns,
      names::PulseIds, names::PartIds, names::ClassificationIds, names::GpsTime })
  {
    arrays[next] = this->GetArray(data, name, 1);
    if (!arrays[next++])
    {
      return false;
    }
  }
  if (echoes->GetNumberOfPoints() == 0)
  {
    return true;
  }
  const Column<vtkDoubleArray> amplitudes(arrays[0]), widths(arrays[1]), times(arrays[7]);
  vtkPoints* points = echoes->GetPoints();
  vtkDataArray* const* a = arrays;
  auto* parts =
    vtkStringArray::SafeDownCast(echoes->GetFieldData()->GetAbstractArray(names::PartName));
  const auto whole = [a](int column, vtkIdType row)
  { return static_cast<std::int64_t>(a[column]->GetComponent(row, 0)); };

  return this->WriteRows(echoes->GetNumberOfPoints(),
    [points, parts, whole, &amplitudes, &widths, &times](vtkIdType row, helios::TextBuffer& text)
    {
      double p[3];
      points->GetPoint(row, p);
      for (const double coordinate : p)
      {
        text.AppendFixed<4>(coordinate);
        text.Append(' ');
      }
      text.AppendFixed<4>(NanowattsPerWatt * amplitudes[row]);
      text.Append(' ');
      text.AppendFixed<4>(widths[row]);
      for (const int column : { 2, 3, 4 })
      {
        text.Append(' ');
        text.AppendInteger(whole(column, row));
      }
      text.Append(' ');
      const std::int64_t part = whole(5, row);
      if (parts && part >= 0 && part < parts->GetNumberOfValues())
      {
        text.Append(std::string_view(parts->GetValue(part)));
      }
      else
      {
        text.AppendInteger(part);
      }
      text.Append(' ');
      text.AppendInteger(whole(6, row));
      text.Append(' ');
      text.AppendFixed<9>(times[row]);
      text.Append('\n');
    });
}
