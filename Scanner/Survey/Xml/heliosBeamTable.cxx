// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamTable.h"

#include "heliosMessages.h"
#include "heliosTextFile.h"
#include "heliosXmlRules.h"
#include "heliosXmlValue.h"

#include <string_view>

namespace helios
{

namespace
{

/// The texts between commas, without surrounding blanks.
std::vector<std::string> SplitRow(std::string_view line)
{
  std::vector<std::string> cells;
  while (true)
  {
    const std::size_t comma = line.find(',');
    cells.emplace_back(TextWords(line.substr(0, comma)).Rest());
    if (comma == std::string_view::npos)
    {
      return cells;
    }
    line.remove_prefix(comma + 1);
  }
}

class BeamTable
{
public:
  explicit BeamTable(Messages& log)
    : Log(log)
  {
  }

  void Read(const std::string& path, std::vector<BeamData>& beams);

private:
  bool IsRow(std::string_view line) const { return TextWords(line).HasMore(); }
  bool ReadRow(std::string_view line, std::vector<BeamData>& beams);
  bool ReadHeader(const std::vector<std::string>& names);
  bool ReadBeam(const std::vector<std::string>& cells, std::vector<BeamData>& beams);

  /// An error at the line.
  bool Fail(const std::string& message)
  {
    this->Log.Error(this->File.GetPlace() + message);
    return false;
  }

  Messages& Log;
  TextFile File;
  std::vector<const XmlValueRule*> Columns;
};

//------------------------------------------------------------------------------
void BeamTable::Read(const std::string& path, std::vector<BeamData>& beams)
{
  const Status opened = this->File.Open(path);
  if (!opened.IsOk())
  {
    this->Log.Error(opened.Message());
    return;
  }
  std::string_view line;
  while (this->File.NextLine(line))
  {
    if (this->IsRow(line) && !this->ReadRow(line, beams))
    {
      return;
    }
  }
  if (!this->File.GetError().empty())
  {
    this->Log.Error(this->File.GetError());
  }
  else if (beams.empty())
  {
    this->Log.Error(path +
      ": has no beams; give a line with the names of columns, such as "
      "elevation_deg,azimuth_deg, and a line per beam");
  }
}

//------------------------------------------------------------------------------
bool BeamTable::ReadRow(std::string_view line, std::vector<BeamData>& beams)
{
  const std::vector<std::string> cells = SplitRow(line);
  return this->Columns.empty() ? this->ReadHeader(cells) : this->ReadBeam(cells, beams);
}

//------------------------------------------------------------------------------
bool BeamTable::ReadHeader(const std::vector<std::string>& names)
{
  const XmlElementRule* rule = FindXmlRule("beam");
  bool hasElevation = false;
  for (const std::string& name : names)
  {
    const XmlValueRule* value = rule->FindValue(name);
    if (!value)
    {
      const std::string nearest = rule->FindNearestValue(name);
      std::vector<std::string> known;
      for (const XmlValueRule& one : rule->Values)
      {
        known.emplace_back(one.Name);
      }
      return this->Fail("column " + Quote(name) + " is unknown; " +
        (nearest.empty() ? "the columns are " + Enumerate(known)
                         : "did you mean " + nearest + "?"));
    }
    hasElevation = hasElevation || name == "elevation_deg";
    this->Columns.push_back(value);
  }
  return hasElevation || this->Fail("there is no column elevation_deg; add it [deg]");
}

//------------------------------------------------------------------------------
bool BeamTable::ReadBeam(const std::vector<std::string>& cells, std::vector<BeamData>& beams)
{
  if (cells.size() != this->Columns.size())
  {
    return this->Fail("a row of " + std::to_string(cells.size()) + " columns, and the first has " +
      std::to_string(this->Columns.size()) + " names; correct one of them");
  }
  if (beams.size() == MostBeams)
  {
    return this->Fail("more than " + std::to_string(MostBeams) + " beams; remove some");
  }
  BeamData beam;
  const std::string place = this->File.GetPlace();
  const std::string where = place.substr(0, place.rfind(':'));
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    const XmlValueRule& rule = *this->Columns[k];
    if (!ParseStored({ rule.Name, cells[k], where }, rule, this->Log, rule.Store.Find(&beam)))
    {
      return false;
    }
  }
  beams.push_back(beam);
  return true;
}

} // namespace

//------------------------------------------------------------------------------
void ReadBeamTable(const std::string& path, std::vector<BeamData>& beams, Messages& log)
{
  BeamTable(log).Read(path, beams);
}

} // namespace helios
