// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMadeElements.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosXmlOptics.h"
#include "heliosXmlPart.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace helios
{

namespace
{

bool HasName(const std::set<std::string>& names, const std::string& path)
{
  return names.count(ElementTree::GetFirstName(path)) > 0;
}

/// The rotation of an element of a tree; without the element: none.
void ReadOrientation(
  const ElementTree& tree, const XmlElement& root, const char* name, Quaternion& orientation)
{
  if (tree.HasSet(name))
  {
    const XmlElement element = root.GetChild(name);
    orientation = element ? element.ReadRotation() : Quaternion(1.0, 0.0, 0.0, 0.0);
  }
}

std::string NameTable(std::size_t table)
{
  return "part table " + std::to_string(table);
}

constexpr const char* TableTag = "partTable";

} // namespace

//------------------------------------------------------------------------------
bool MadeElements::Keeps(const ScannerData&, const std::string& path)
{
  return HasName({ "headRotateAxis", "incidentBeam", "beams", "beamOrigin" }, path);
}

//------------------------------------------------------------------------------
bool MadeElements::Keeps(const PlatformData&, const std::string& path)
{
  return HasName({ "scannerMount" }, path);
}

//------------------------------------------------------------------------------
bool MadeElements::Keeps(const PartData&, const std::string& path)
{
  return HasName({ "crs", "repair", "swap", "dmotion", "dynStep", "dynTimeStep", "kdtDynStep",
                   "kdtDynTimeStep" },
    path);
}

//------------------------------------------------------------------------------
bool MadeElements::Keeps(const SceneData&, const std::string& path)
{
  return HasName({ "dynStep", "dynTimeStep" }, path);
}

//------------------------------------------------------------------------------
const ElementTree* MadeElements::Find(const std::string& where) const
{
  const auto found = this->Trees.find(where);
  return found == this->Trees.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
bool MadeElements::Set(const char* tag, const XmlValue& value, Messages& log)
{
  return this->Trees.emplace(value.Where, ElementTree(tag)).first->second.Set(value, log);
}

//------------------------------------------------------------------------------
std::string MadeElements::Get(const char* tag, const XmlValue& value, Messages& log) const
{
  const ElementTree* tree = this->Find(value.Where);
  return tree ? tree->Get(value, log) : ElementTree(tag).Get(value, log);
}

//------------------------------------------------------------------------------
void MadeElements::RemoveParts()
{
  for (auto tree = this->Trees.begin(); tree != this->Trees.end();)
  {
    tree = tree->first.compare(0, 5, "part ") == 0 ? this->Trees.erase(tree) : std::next(tree);
  }
  this->TableRows.clear();
  this->NumberOfTableParts = 0;
  this->AreTablesRead = true;
}

//------------------------------------------------------------------------------
int MadeElements::AddTable(const std::string& file)
{
  const std::string where = NameTable(this->TableRows.size());
  Messages silent(nullptr);
  this->TableRows.emplace_back();
  this->AreTablesRead = false;
  this->Set(TableTag, { "file", file, where }, silent);
  return static_cast<int>(this->TableRows.size()) - 1;
}

//------------------------------------------------------------------------------
bool MadeElements::CheckTable(int table, Messages& log) const
{
  const bool exists = table >= 0 && table < static_cast<int>(this->TableRows.size());
  if (!exists)
  {
    log.Error("part table " + std::to_string(table) + " does not exist; there are " +
      std::to_string(this->TableRows.size()) + ", counted from 0");
  }
  return exists;
}

//------------------------------------------------------------------------------
bool MadeElements::SetTable(
  int table, const std::string& name, const std::string& value, Messages& log)
{
  const bool isGood = this->CheckTable(table, log) &&
    this->Set(TableTag, { name, value, NameTable(static_cast<std::size_t>(table)) }, log);
  this->AreTablesRead = this->AreTablesRead && !isGood;
  return isGood;
}

//------------------------------------------------------------------------------
std::string MadeElements::GetTable(int table, const std::string& name, Messages& log) const
{
  return this->CheckTable(table, log)
    ? this->Get(TableTag, { name, "", NameTable(static_cast<std::size_t>(table)) }, log)
    : std::string();
}

//------------------------------------------------------------------------------
bool MadeElements::SetTableRows(int table, const std::string& text, Messages& log)
{
  const bool isGood = this->CheckTable(table, log);
  if (isGood)
  {
    this->TableRows[static_cast<std::size_t>(table)] = text;
    this->AreTablesRead = false;
  }
  return isGood;
}

//------------------------------------------------------------------------------
void MadeElements::RemoveTableParts(std::vector<PartData>& parts)
{
  this->AreTablesRead = this->AreTablesRead && this->NumberOfTableParts == 0;
  parts.resize(parts.size() - std::min(parts.size(), this->NumberOfTableParts));
  this->NumberOfTableParts = 0;
}

//------------------------------------------------------------------------------
/// Makes the parts of tables after all others; those of tables that were read are unchanged.
void MadeElements::ApplyTables(SurveyData& survey, Assets& assets, Messages& log)
{
  if (this->AreTablesRead)
  {
    return;
  }
  const int before = log.GetNumberOfErrors();
  std::vector<PartData>& parts = survey.Scene.Parts;
  this->RemoveTableParts(parts);
  const std::size_t others = parts.size();
  for (std::size_t i = 0; i < this->TableRows.size(); ++i)
  {
    const auto document = this->Find(NameTable(i))->MakeDocument(NameTable(i), log);
    ReadPartTable(document->GetRoot().GetChild(TableTag), assets, this->TableRows[i], parts);
  }
  this->NumberOfTableParts = parts.size() - others;
  this->AreTablesRead = log.GetNumberOfErrors() == before;
  for (const std::string& path : assets.GetDocumentPaths())
  {
    std::vector<std::string>& all = survey.Documents;
    const auto place = std::lower_bound(all.begin(), all.end(), path);
    place == all.end() || *place != path ? void(all.insert(place, path)) : void();
  }
}

//------------------------------------------------------------------------------
void MadeElements::Apply(
  ScannerData& scanner, const std::string& where, const Assets& assets, Messages& log) const
{
  const ElementTree* tree = this->Find(where);
  if (!tree)
  {
    return;
  }
  const auto document = tree->MakeDocument(where, log);
  const XmlElement root = document->GetRoot().GetChild("scanner");
  if (tree->HasSet("headRotateAxis"))
  {
    scanner.HeadRotateAxis = ScannerData().HeadRotateAxis;
    ReadHeadRotateAxis(root.GetChild("headRotateAxis"), scanner.HeadRotateAxis);
  }
  if (tree->HasSet("incidentBeam"))
  {
    scanner.IncidentBeam = ScannerData().IncidentBeam;
    ReadIncidentBeam(root, scanner);
  }
  if (tree->HasSet("beams"))
  {
    scanner.Beams.clear();
    scanner.BeamFile.clear();
    ReadBeams(root, assets, scanner);
  }
  ReadOrientation(*tree, root, "beamOrigin", scanner.Beam.Orientation);
}

//------------------------------------------------------------------------------
void MadeElements::Apply(PlatformData& platform, const std::string& where, Messages& log) const
{
  if (const ElementTree* tree = this->Find(where))
  {
    const auto document = tree->MakeDocument(where, log);
    ReadOrientation(
      *tree, document->GetRoot().GetChild("platform"), "scannerMount", platform.Mount.Orientation);
  }
}

//------------------------------------------------------------------------------
void MadeElements::Apply(
  SurveyData& survey, const std::vector<std::string>& assetDirectories, Messages& log)
{
  if (this->Trees.empty())
  {
    return;
  }
  Assets assets(log, assetDirectories);
  const auto number = [](const char* what, std::size_t index)
  { return what + std::to_string(index); };
  for (std::size_t i = 0; i < survey.Scanners.size(); ++i)
  {
    const std::string where = number("scanner ", i);
    this->Apply(survey.Scanners[i], where, assets, log);
    for (std::size_t k = 0; k < survey.Scanners[i].OtherChannels.size(); ++k)
    {
      this->Apply(
        survey.Scanners[i].OtherChannels[k], where + number(", channel ", k + 1), assets, log);
    }
  }
  for (std::size_t i = 0; i < survey.Platforms.size(); ++i)
  {
    this->Apply(survey.Platforms[i], number("platform ", i), log);
  }
  const ElementTree* steps = this->Find("scene");
  const auto scene = (steps ? *steps : ElementTree("scene")).MakeDocument("scene", log);
  for (std::size_t i = 0; i < survey.Scene.Parts.size() - this->NumberOfTableParts; ++i)
  {
    const std::string where = number("part ", i);
    if (const ElementTree* tree = this->Find(where))
    {
      const auto document = tree->MakeDocument(where, log);
      ReadMadePart(
        document->GetRoot().GetChild("part"), scene->GetRoot().GetChild("scene"),
        [tree](const char* name) { return tree->HasSet(name); }, assets, survey.Scene.Parts[i]);
    }
  }
  this->ApplyTables(survey, assets, log);
  CheckEpochs(survey.Scene, log);
}

} // namespace helios
