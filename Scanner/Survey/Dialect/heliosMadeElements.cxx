// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMadeElements.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosXmlOptics.h"
#include "heliosXmlPart.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"

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
  for (std::size_t i = 0; i < survey.Scene.Parts.size(); ++i)
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
  CheckEpochs(survey.Scene, log);
}

} // namespace helios
