// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPcdHeader.h"

#include "heliosAsciiText.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <string_view>

namespace helios
{

namespace
{

constexpr std::string_view OriginMark = "# vtkHelios origin:";
constexpr std::string_view EpochMark = "# vtkHelios GpsEpoch:";
constexpr std::string_view CrsMark = "# vtkHelios CRS:";
constexpr std::string_view AmplitudeMark = "# vtkHelios intensity: Amplitude";
constexpr std::string_view WholeMark = "# vtkHelios intensity: Intensity, 16 bits";
constexpr std::uint64_t MaximumPoints = std::uint64_t(1) << 40;
constexpr int LargestCount = 100000;
constexpr std::size_t LongestLine = 1 << 20;

using Words = std::vector<std::string_view>;

Words Split(std::string_view line)
{
  Words words;
  TextWords rest(line);
  for (std::string_view word = rest.NextName(); !word.empty(); word = rest.NextName())
  {
    words.push_back(word);
  }
  return words;
}

template <typename T>
bool ToNumber(std::string_view word, T& value)
{
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

std::string FormatNumber(double value)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

bool IsSizeOfType(char type, int size)
{
  return type == 'F'
    ? size == 4 || size == 8
    : (type == 'I' || type == 'U') && (size == 1 || size == 2 || size == 4 || size == 8);
}

/// Parses the header lines one by one.
class HeaderParser
{
public:
  explicit HeaderParser(PcdHeader& header)
    : Header(header)
  {
  }

  /// Parses a line.
  Status ReadLine(std::string_view line)
  {
    if (!line.empty() && line[0] == '#')
    {
      return this->ReadComment(line);
    }
    Words words = Split(line);
    if (words.empty())
    {
      return {};
    }
    const std::string key(words[0] == "COLUMNS" ? "FIELDS" : words[0]);
    words.erase(words.begin());
    if (std::find(this->Seen.begin(), this->Seen.end(), key) != this->Seen.end())
    {
      return Status::Error(key + " is given twice; remove one");
    }
    Status status = this->ReadEntry(key, words);
    this->Seen.push_back(key);
    return status;
  }

  bool IsAtData() const { return this->Has("DATA"); }

  /// Checks the complete header.
  Status Finish()
  {
    for (const char* key : { "FIELDS", "SIZE", "TYPE" })
    {
      if (!this->Has(key))
      {
        return Status::Error(
          std::string("the header has no line ") + key + "; it must describe a point");
      }
    }
    if (!this->Has("WIDTH") && !this->Has("POINTS"))
    {
      return Status::Error(
        "the header has neither WIDTH nor POINTS; it must give the number of points");
    }
    PcdHeader& header = this->Header;
    header.Width = this->Has("WIDTH") ? header.Width : this->Points;
    if (header.Height > 0 && header.Width > MaximumPoints / header.Height)
    {
      return Status::Error("WIDTH " + std::to_string(header.Width) + " times HEIGHT " +
        std::to_string(header.Height) + " gives too many points; correct them");
    }
    if (this->Has("POINTS") && this->Points != header.GetNumberOfPoints())
    {
      return Status::Error("POINTS is " + std::to_string(this->Points) +
        ", but WIDTH times HEIGHT is " + std::to_string(header.GetNumberOfPoints()) +
        "; correct one of them");
    }
    for (const char* name : { "x", "y", "z" })
    {
      const int field = header.FindPcl(name);
      if (field < 0)
      {
        return Status::Error(std::string("FIELDS has no ") + name + "; points need x, y and z");
      }
      const PcdField& column = header.Fields[static_cast<std::size_t>(field)];
      if (column.Count != 1 || column.Type != 'F')
      {
        return Status::Error(std::string(name) + " has TYPE " + column.Type + " and COUNT " +
          std::to_string(column.Count) + "; x, y and z are one number of type F each");
      }
    }
    return {};
  }

private:
  bool Has(const std::string& key) const
  {
    return std::find(this->Seen.begin(), this->Seen.end(), key) != this->Seen.end();
  }

  static bool StartsWith(std::string_view line, std::string_view mark)
  {
    return line.substr(0, mark.size()) == mark;
  }

  Status ReadComment(std::string_view line)
  {
    PcdHeader& header = this->Header;
    if (StartsWith(line, OriginMark))
    {
      const Words words = Split(line.substr(OriginMark.size()));
      if (words.size() != 3 || !this->ToFinite(words, header.Origin))
      {
        return Status::Error(
          "the origin is not three numbers; correct it: points are relative to it");
      }
    }
    else if (StartsWith(line, EpochMark))
    {
      const Words words = Split(line.substr(EpochMark.size()));
      header.HasEpoch = words.size() == 1 && this->ToFinite(words, &header.Epoch);
      return header.HasEpoch ? Status()
                             : Status::Error("the GpsEpoch is not a number; correct or remove it");
    }
    else if (StartsWith(line, CrsMark))
    {
      const Words words = Split(line.substr(CrsMark.size()));
      if (!words.empty())
      {
        const char* end = words.back().data() + words.back().size();
        header.Crs = UnescapeText(
          std::string(words.front().data(), static_cast<std::size_t>(end - words.front().data())));
      }
    }
    header.HasAmplitude = header.HasAmplitude || StartsWith(line, AmplitudeMark);
    header.HasWholeIntensity = header.HasWholeIntensity || StartsWith(line, WholeMark);
    return {};
  }

  bool ToFinite(const Words& words, double* values) const
  {
    for (const std::string_view word : words)
    {
      if (!ToNumber(word, *values) || !std::isfinite(*values))
      {
        return false;
      }
      ++values;
    }
    return true;
  }

  Status ReadEntry(const std::string& key, const Words& words)
  {
    if (key == "VERSION")
    {
      return this->ReadVersion(words);
    }
    if (key == "FIELDS")
    {
      return this->ReadFields(words);
    }
    if (key == "SIZE" || key == "TYPE" || key == "COUNT")
    {
      return this->ReadColumn(key, words);
    }
    if (key == "WIDTH" || key == "HEIGHT" || key == "POINTS")
    {
      std::uint64_t& number = key == "WIDTH" ? this->Header.Width
        : key == "HEIGHT"                    ? this->Header.Height
                                             : this->Points;
      return words.size() == 1 && ToNumber(words[0], number) && number <= MaximumPoints
        ? Status()
        : Status::Error(key + " is not one whole number of at most 2^40; correct it");
    }
    if (key == "VIEWPOINT")
    {
      return words.size() == 7 && this->ToFinite(words, this->Header.Viewpoint)
        ? Status()
        : Status::Error("VIEWPOINT is not seven numbers; without one write 0 0 0 1 0 0 0");
    }
    if (key == "DATA")
    {
      return this->ReadStorage(words);
    }
    return Status::Error("unknown entry " + Quote(key) +
      "; a PCD header has VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS, "
      "DATA");
  }

  Status ReadVersion(const Words& words) const
  {
    double version = 0.0;
    const bool isKnown = words.size() == 1 && ToNumber(words[0], version) &&
      (version == 0.7 || version == 0.6 || version == 0.5);
    return isKnown ? Status()
                   : Status::Error("VERSION is not 0.7, 0.6 or 0.5; save the file as PCD 0.7");
  }

  Status ReadFields(const Words& words)
  {
    for (const std::string_view word : words)
    {
      PcdField field;
      field.Name = UnescapeText(std::string(word));
      if (field.Name != "_" && this->Header.Find(field.Name) >= 0)
      {
        return Status::Error("FIELDS has " + Quote(word) + " twice; rename one");
      }
      this->Header.Fields.push_back(field);
    }
    return words.empty() ? Status::Error("FIELDS is empty; points need x, y and z") : Status();
  }

  Status ReadColumn(const std::string& key, const Words& words)
  {
    std::vector<PcdField>& fields = this->Header.Fields;
    if (words.size() != fields.size())
    {
      return Status::Error(key + " has " + std::to_string(words.size()) + " entries for " +
        std::to_string(fields.size()) + " FIELDS; give one for each, below FIELDS");
    }
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      PcdField& field = fields[i];
      bool isGood = true;
      if (key == "TYPE")
      {
        field.Type = words[i].size() == 1 ? words[i][0] : '?';
        isGood = field.Type == 'F' || field.Type == 'I' || field.Type == 'U';
      }
      else
      {
        int& number = key == "SIZE" ? field.Size : field.Count;
        isGood = ToNumber(words[i], number) && number > 0 && number <= LargestCount;
      }
      if (!isGood)
      {
        return Status::Error(key + " of the field " + Quote(field.Name) + " is " + Quote(words[i]) +
          (key == "TYPE" ? "; types are F, I and U" : "; give a whole number above 0"));
      }
    }
    return this->CheckSizes(key);
  }

  Status CheckSizes(const std::string& key) const
  {
    const bool isWhole =
      (key == "TYPE" && this->Has("SIZE")) || (key == "SIZE" && this->Has("TYPE"));
    for (const PcdField& field : this->Header.Fields)
    {
      if (isWhole && !IsSizeOfType(field.Type, field.Size))
      {
        return Status::Error("the field " + Quote(field.Name) + " is of type " + field.Type +
          " and size " + std::to_string(field.Size) +
          "; sizes are 4 and 8 for F, and 1, 2, 4, 8 for I and U");
      }
    }
    return {};
  }

  Status ReadStorage(const Words& words)
  {
    const std::string_view word = words.size() == 1 ? words[0] : std::string_view();
    if (word != "ascii" && word != "binary" && word != "binary_compressed")
    {
      return Status::Error(
        "DATA is " + Quote(word) + "; expected one of ascii, binary, binary_compressed");
    }
    this->Header.Storage = word == "ascii" ? PcdStorage::Ascii
      : word == "binary"                   ? PcdStorage::Binary
                                           : PcdStorage::Compressed;
    return {};
  }

  PcdHeader& Header;
  std::vector<std::string> Seen;
  std::uint64_t Points = 0;
};

/// Reads a line without its end (LF, CR LF or, of old Macintosh files, CR), truncated to the maximum
/// length of a header line; adds its bytes to a position.
bool GetLine(std::istream& file, std::string& line, std::uint64_t& position)
{
  line.clear();
  for (int c = file.get(); c != std::char_traits<char>::eof(); c = file.get())
  {
    ++position;
    if (c == '\r' && file.peek() == '\n')
    {
      continue;
    }
    if (c == '\n' || c == '\r')
    {
      return true;
    }
    line += static_cast<char>(c);
    if (line.size() > LongestLine)
    {
      return true;
    }
  }
  return !line.empty();
}

} // namespace

bool PcdHeader::IsPlainViewpoint() const
{
  const double plain[7] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };
  return std::equal(plain, plain + 7, this->Viewpoint);
}

std::size_t PcdHeader::GetRowSize() const
{
  std::size_t bytes = 0;
  for (const PcdField& field : this->Fields)
  {
    bytes += field.GetBytes();
  }
  return bytes;
}

std::int64_t PcdHeader::GetNumberOfColumns() const
{
  std::int64_t columns = 0;
  for (const PcdField& field : this->Fields)
  {
    columns += field.Count;
  }
  return columns;
}

int PcdHeader::Find(const std::string& name) const
{
  for (std::size_t i = 0; i < this->Fields.size(); ++i)
  {
    if (this->Fields[i].Name == name)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::string ToLowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return text;
}

int PcdHeader::FindPcl(const std::string& name) const
{
  const int exact = this->Find(name);
  for (std::size_t i = 0; exact < 0 && i < this->Fields.size(); ++i)
  {
    if (ToLowerCase(this->Fields[i].Name) == name)
    {
      return static_cast<int>(i);
    }
  }
  return exact;
}

Status PcdHeader::Read(const std::string& path, std::istream& file)
{
  char head[4] = {};
  file.read(head, sizeof(head));
  const auto known = static_cast<std::size_t>(file.gcount());
  file.clear();
  file.seekg(0);
  if (const Status encoding = CheckEncoding({ head, known }); !encoding.IsOk())
  {
    return Status::Error(path + ": " + encoding.Message());
  }
  HeaderParser parser(*this);
  std::string line;
  std::int64_t number = 0;
  while (!parser.IsAtData() && GetLine(file, line, this->DataBegin))
  {
    const Status status = parser.ReadLine(line);
    ++number;
    if (!status.IsOk())
    {
      return Status::Error(Place(path, number) + status.Message());
    }
  }
  this->DataLine = number + 1;
  if (!parser.IsAtData())
  {
    return Status::Error(Place(path, number) +
      "the file ends before the line DATA; it is not a PCD file, or is cut off");
  }
  const Status status = parser.Finish();
  return status.IsOk() ? status : Status::Error(Place(path, number) + status.Message());
}

std::string PcdHeader::Format() const
{
  std::string names = "FIELDS";
  std::string sizes = "SIZE";
  std::string types = "TYPE";
  std::string counts = "COUNT";
  for (const PcdField& field : this->Fields)
  {
    names += ' ' + EscapeText(field.Name);
    sizes += ' ' + std::to_string(field.Size);
    types += std::string(" ") + field.Type;
    counts += ' ' + std::to_string(field.Count);
  }
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
  if (this->Origin[0] != 0.0 || this->Origin[1] != 0.0 || this->Origin[2] != 0.0)
  {
    text += std::string(OriginMark) + ' ' + FormatNumber(this->Origin[0]) + ' ' +
      FormatNumber(this->Origin[1]) + ' ' + FormatNumber(this->Origin[2]) + '\n';
  }
  text += this->HasEpoch ? std::string(EpochMark) + ' ' + FormatNumber(this->Epoch) + '\n' : "";
  text += this->Crs.empty() ? "" : std::string(CrsMark) + ' ' + EscapeText(this->Crs) + '\n';
  text += this->HasAmplitude  ? std::string(AmplitudeMark) + " [W]\n"
    : this->HasWholeIntensity ? std::string(WholeMark) + '\n'
                              : "";
  std::string number = std::to_string(this->GetNumberOfPoints());
  number.resize(std::max<std::size_t>(number.size(), 15), ' ');
  const char* storage = this->Storage == PcdStorage::Ascii ? "ascii" : "binary";
  return text + "VERSION 0.7\n" + names + '\n' + sizes + '\n' + types + '\n' + counts + "\nWIDTH " +
    number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA " + storage + '\n';
}

} // namespace helios
