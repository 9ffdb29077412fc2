// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVtkXmlFile.h"

#include "heliosInputFile.h"
#include "heliosStatus.h"
#include "heliosVtkXmlParser.h"

#include <vtkNew.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

constexpr double SmallestLimit = 5e8; // [bytes]
constexpr double LimitShare = 10.0;   // multiple of the file size

/// A validation error; ends the check.
struct Fault
{
  std::string Words;
};

[[noreturn]] void Fail(const std::string& words)
{
  throw Fault{ words };
}

std::string Quote(const char* name, const std::string& value)
{
  return std::string(name) + "=\"" + value.substr(0, 40) + "\"";
}

bool HasName(vtkXMLDataElement* element, const char* name)
{
  return element->GetName() && std::strcmp(element->GetName(), name) == 0;
}

std::string GetText(vtkXMLDataElement* element, const char* name)
{
  const char* value = element->GetAttribute(name);
  return value ? value : "";
}

/// Reads an integer attribute in [0, most].
vtkTypeInt64 ReadCount(
  vtkXMLDataElement* element, const char* name, vtkTypeInt64 missing, vtkTypeInt64 maximum)
{
  const char* text = element->GetAttribute(name);
  if (!text)
  {
    return missing;
  }
  vtkTypeInt64 value = -1;
  const std::string words = text;
  const std::size_t first = std::min(words.find_first_not_of(" \n\r\t"), words.size());
  const std::size_t last = words.find_last_not_of(" \n\r\t") + 1;
  const auto [end, error] =
    std::from_chars(words.data() + first, words.data() + std::max(first, last), value);
  if (error != std::errc() || end != words.data() + last || value < 0 || value > maximum)
  {
    Fail(Quote(name, words) + " of " + element->GetName() + " is not valid: expected 0 to " +
      std::to_string(maximum) + "; write the file again");
  }
  return value;
}

/// Type of an array, its size [bytes] and number of components; Size 0: string.
struct ArrayForm
{
  int Type = VTK_VOID;
  int Components = 1;
  std::string Name;

  bool operator==(const ArrayForm& other) const
  {
    return Type == other.Type && Components == other.Components && Name == other.Name;
  }
};

constexpr struct
{
  const char* Name;
  int Type;
  int Size;
} Types[] = { { "Int8", VTK_TYPE_INT8, 1 }, { "UInt8", VTK_TYPE_UINT8, 1 },
  { "Int16", VTK_TYPE_INT16, 2 }, { "UInt16", VTK_TYPE_UINT16, 2 }, { "Int32", VTK_TYPE_INT32, 4 },
  { "UInt32", VTK_TYPE_UINT32, 4 }, { "Int64", VTK_TYPE_INT64, 8 },
  { "UInt64", VTK_TYPE_UINT64, 8 }, { "Float32", VTK_TYPE_FLOAT32, 4 },
  { "Float64", VTK_TYPE_FLOAT64, 8 }, { "String", VTK_STRING, 0 }, { "Bit", VTK_BIT, 0 } };

double GetSize(int type)
{
  const auto* found = std::find_if(
    std::begin(Types), std::end(Types), [type](const auto& each) { return each.Type == type; });
  return found->Size > 0 ? found->Size : 1.0; // at most one byte per bit in memory
}

bool IsInteger(int type)
{
  return type != VTK_STRING && type != VTK_BIT && type != VTK_TYPE_FLOAT32 &&
    type != VTK_TYPE_FLOAT64;
}

/// Traverses the elements of a file.
class Check
{
public:
  Check(VtkXmlParser* parser, double size)
    : Parser(parser)
    , Size(size)
    , Limit(GetVtkXmlMemoryLimit(size))
  {
  }

  vtkIdType Run(vtkXMLDataElement* grid)
  {
    vtkIdType records = 0;
    for (int i = 0; i < grid->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* element = grid->GetNestedElement(i);
      if (HasName(element, "FieldData"))
      {
        this->CheckFieldData(element);
      }
      else if (HasName(element, "Piece"))
      {
        records += this->CheckPiece(element);
      }
    }
    return records;
  }

private:
  using Forms = std::vector<ArrayForm>;

  vtkTypeInt64 CountOf(vtkXMLDataElement* element, const char* name)
  {
    return ReadCount(element, name, 0, static_cast<vtkTypeInt64>(this->Limit));
  }

  vtkIdType CheckPiece(vtkXMLDataElement* piece)
  {
    const vtkTypeInt64 rows = this->CountOf(piece, "NumberOfRows");
    const vtkTypeInt64 points = this->CountOf(piece, "NumberOfPoints");
    vtkTypeInt64 cells = 0;
    for (const char* kind : { "Verts", "Lines", "Strips", "Polys" })
    {
      const vtkTypeInt64 count = this->CountOf(piece, (std::string("NumberOf") + kind).c_str());
      vtkXMLDataElement* element = piece->FindNestedElementWithName(kind);
      if (element)
      {
        this->CheckCells(element, count);
      }
      else if (count > 0)
      {
        Fail(std::string("has a piece without the element ") + kind + "; write the file again");
      }
      cells += count;
    }
    this->CheckOnce(piece);
    this->CheckAttributes(piece, "PointData", points, this->PointForms);
    this->CheckAttributes(piece, "CellData", cells, this->CellForms);
    this->CheckAttributes(piece, "RowData", rows, this->RowForms);
    vtkXMLDataElement* place = piece->FindNestedElementWithName("Points");
    if (points > 0 && (!place || place->GetNumberOfNestedElements() < 1))
    {
      Fail("has a piece of points without the element Points; write the file again");
    }
    for (int i = 0; place && i < place->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* array = place->GetNestedElement(i);
      const ArrayForm form = this->CheckArray(array, points);
      if (points > 0 && (form.Components != 3 || form.Type == VTK_STRING || form.Type == VTK_BIT))
      {
        Fail("has points that are not three numbers each; write the file again");
      }
    }
    return points + rows;
  }

  /// Checks that an element is there once: VTK readers keep the last of several elements with the
  /// same name, and count the others.
  void CheckOnce(vtkXMLDataElement* piece)
  {
    std::set<std::string> names;
    for (int i = 0; i < piece->GetNumberOfNestedElements(); ++i)
    {
      const char* name = piece->GetNestedElement(i)->GetName();
      if (!names.insert(name).second)
      {
        Fail(std::string("has a piece with the element ") + name + " twice; write the file again");
      }
    }
  }

  void CheckAttributes(
    vtkXMLDataElement* piece, const char* kind, vtkTypeInt64 tuples, Forms& expected)
  {
    Forms forms;
    std::set<std::string> names;
    vtkXMLDataElement* data = piece->FindNestedElementWithName(kind);
    for (int i = 0; data && i < data->GetNumberOfNestedElements(); ++i)
    {
      forms.push_back(this->CheckArray(data->GetNestedElement(i), tuples));
      const std::string& name = forms.back().Name;
      if (name.empty() || !names.insert(name).second)
      {
        Fail(std::string("has an array of ") + kind +
          (name.empty() ? " without a name" : " named twice: " + name) + "; write the file again");
      }
    }
    if (tuples == 0)
    {
      return;
    }
    if (this->FirstOf.insert(kind).second)
    {
      expected = forms;
    }
    else if (!(forms == expected))
    {
      Fail(std::string("has pieces with other arrays of ") + kind + "; write the file again");
    }
  }

  void CheckFieldData(vtkXMLDataElement* data)
  {
    for (int i = 0; i < data->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* array = data->GetNestedElement(i);
      const vtkTypeInt64 tuples = this->CountOf(array, "NumberOfTuples");
      const ArrayForm form = this->CheckArray(array, tuples);
      double number = 0.0; // the VTK reader treats any number as a time, and reads it immediately
      if (tuples == 1 && form.Components == 1 && form.Type != VTK_STRING && form.Type != VTK_BIT &&
        !this->Parser->ReadNumber(array, 0, form.Type, number))
      {
        Fail("the array " + form.Name + " cannot be read; copy or write the file again");
      }
    }
  }

  void CheckCells(vtkXMLDataElement* cells, vtkTypeInt64 count)
  {
    vtkXMLDataElement* offsets = nullptr;
    vtkXMLDataElement* points = nullptr;
    for (int i = 0; i < cells->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* array = cells->GetNestedElement(i);
      const std::string name = GetText(array, "Name");
      vtkXMLDataElement*& place = name == "offsets" ? offsets : points;
      if ((name != "offsets" && name != "connectivity") || place)
      {
        Fail(std::string("has ") + cells->GetName() +
          " with arrays other than connectivity and offsets; write the file again");
      }
      place = array;
    }
    if (count == 0)
    {
      return; // not read
    }
    if (!offsets || !points)
    {
      Fail(std::string("has ") + cells->GetName() +
        " without connectivity and offsets; write the file again");
    }
    const ArrayForm form = this->CheckArray(offsets, count);
    if (!IsInteger(form.Type) || form.Components != 1)
    {
      Fail("has cells with offsets that are not whole numbers; write the file again");
    }
    double last = 0.0;
    if (!this->Parser->ReadNumber(offsets, count - 1, form.Type, last) || last < 0.0 ||
      last > this->Limit)
    {
      Fail("has cells whose last offset is not valid; write the file again");
    }
    const ArrayForm ids = this->CheckArray(points, static_cast<vtkTypeInt64>(last));
    if (!IsInteger(ids.Type) || ids.Components != 1)
    {
      Fail("has cells with connectivity that is not whole numbers; write the file again");
    }
  }

  ArrayForm CheckArray(vtkXMLDataElement* array, vtkTypeInt64 tuples)
  {
    ArrayForm form;
    form.Name = GetText(array, "Name");
    const std::string type = GetText(array, "type");
    const auto* found = std::find_if(
      std::begin(Types), std::end(Types), [&type](const auto& each) { return type == each.Name; });
    if ((!HasName(array, "DataArray") && !HasName(array, "Array")) || found == std::end(Types))
    {
      Fail("the array " + form.Name + " is a " + array->GetName() + " with " + Quote("type", type) +
        ", which is not known; write the file again");
    }
    form.Type = found->Type;
    form.Components = static_cast<int>(ReadCount(array, "NumberOfComponents", 1, 1 << 20));
    if (form.Components == 0)
    {
      Fail("the array " + form.Name + " has no components; write the file again");
    }
    this->CheckKeys(array);
    const double values = static_cast<double>(tuples) * form.Components;
    const double bytes = values * GetSize(form.Type);
    this->Memory += form.Type == VTK_STRING ? values * sizeof(std::string) : bytes;
    if (this->Memory > this->Limit)
    {
      Fail("its arrays need more than " + std::to_string(static_cast<long>(this->Limit / 1e6)) +
        " MB of memory, too much for a file of " + std::to_string(static_cast<long>(this->Size)) +
        " bytes; write it again, without compression");
    }
    const double stored = form.Type == VTK_BIT ? (values + 7.0) / 8.0 : bytes;
    const Status status = this->Parser->CheckData(array, values, std::floor(stored), this->Limit);
    if (!status.IsOk())
    {
      Fail("the array " + form.Name + " " + status.Message() + "; copy or write the file again");
    }
    if (form.Type == VTK_STRING && !this->Parser->HasTexts(array, values))
    {
      Fail("the array " + form.Name + " does not have the " +
        std::to_string(static_cast<long>(values)) + " strings of its counts; write the file again");
    }
    return form;
  }

  /// Checks information keys: they have a length attribute, which VTK trusts.
  void CheckKeys(vtkXMLDataElement* array)
  {
    for (int i = 0; i < array->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* key = array->GetNestedElement(i);
      ReadCount(key, "length", 0, key->GetNumberOfNestedElements());
    }
  }

  VtkXmlParser* Parser;
  double Size;
  double Limit;
  double Memory = 0.0;
  Forms PointForms;
  Forms CellForms;
  Forms RowForms;
  std::set<std::string> FirstOf;
};

std::vector<std::string> ReadPieces(vtkXMLDataElement* index, const fs::path& folder)
{
  std::vector<std::string> pieces;
  for (int i = 0; i < index->GetNumberOfNestedElements(); ++i)
  {
    const char* source = index->GetNestedElement(i)->GetAttribute("Source");
    if (source)
    {
      pieces.push_back((folder / source).string());
    }
  }
  return pieces;
}

} // namespace

double GetVtkXmlMemoryLimit(double fileSize)
{
  return SmallestLimit + LimitShare * fileSize;
}

bool VtkXmlFile::Open(const std::string& path, const std::string& type)
{
  *this = VtkXmlFile();
  this->Problem = CheckInputFile(path).Message();
  std::ifstream file(this->Problem.empty() ? path : "", std::ios::binary);
  if (!file)
  {
    this->Problem =
      this->Problem.empty() ? "is not a file that can be read; check its name" : this->Problem;
    return false;
  }
  std::error_code problem;
  const auto size = static_cast<double>(fs::file_size(path, problem));
  try
  {
    vtkNew<VtkXmlParser> parser;
    parser->SetStream(&file);
    vtkXMLDataElement* root = parser->ParseFile(size);
    if (!root || !HasName(root, "VTKFile"))
    {
      Fail(parser->GetProblem().empty() ? "is not a VTK XML file; check its name"
                                        : parser->GetProblem() + "; copy or write the file again");
    }
    const std::string found = GetText(root, "type");
    vtkXMLDataElement* content = root->FindNestedElementWithName(found.c_str());
    if ((found != type && found != "P" + type) || !content)
    {
      Fail("has " + Quote("type", found) + ", not " + type + "; give a file of that type");
    }
    this->FileKind = found == type ? Kind::Single : Kind::Index;
    if (this->FileKind == Kind::Index)
    {
      this->Pieces = ReadPieces(content, fs::path(path).parent_path());
      return true;
    }
    if (!parser->SetCompressorOf(root))
    {
      Fail("has " + Quote("compressor", GetText(root, "compressor")) +
        ", which is not known; write it with zlib, LZ4, LZMA or uncompressed");
    }
    this->NumberOfRecords = Check(parser, size).Run(content);
  }
  catch (const Fault& fault)
  {
    this->Problem = fault.Words;
  }
  catch (const std::exception& error)
  {
    this->Problem = std::string("cannot be read: ") + error.what() + "; write it again";
  }
  return this->Problem.empty();
}

} // namespace helios
