// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlScene.h"

#include "heliosEpochs.h"
#include "heliosMessages.h"
#include "heliosPartTable.h"
#include "heliosRowTable.h"
#include "heliosXmlFilter.h"
#include "heliosXmlMotion.h"
#include "heliosXmlPart.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace helios
{

namespace
{

/// Adds a part; as one part per file if it has several files and no id.
void AddPart(PartData part, std::vector<PartData>& parts)
{
  if (!part.Name.empty())
  {
    parts.push_back(part);
    return;
  }
  if (part.Frames.IsGiven())
  {
    part.Name = std::to_string(parts.size());
    parts.push_back(part);
    return;
  }
  const std::vector<std::string> files = std::move(part.Files);
  for (const std::string& file : files)
  {
    part.Name = std::to_string(parts.size());
    part.Files = { file };
    parts.push_back(part);
  }
}

/// Reads a <partTable>.
class TableReader
{
public:
  TableReader(const XmlElement& element, Assets& assets)
    : Element(element)
    , Files(assets)
    , Log(element.GetMessages())
  {
  }

  PartTableData Read();

private:
  void CheckRanges();
  void ReadModel(const XmlElement& model);
  void ReadRows();
  void ReadRowElements();
  void ReadRowFile();
  void AddFileModels();
  void AddFileModel(const TableRow& row);

  const XmlElement& Element;
  Assets& Files;
  Messages& Log;
  PartTableData Table;
  const XmlDocument* RowDocument = nullptr; ///< document that rows name files from
};

//------------------------------------------------------------------------------
PartTableData TableReader::Read()
{
  this->Element.CheckNames();
  this->Table.Where = this->Element.Where();
  this->RowDocument = &this->Element.GetDocument();
  this->Element.ReadStored(this->Table);
  this->CheckRanges();
  for (const XmlElement& model : this->Element.GetChildren("model"))
  {
    this->ReadModel(model);
  }
  this->ReadRows();
  this->AddFileModels();
  return this->Table;
}

//------------------------------------------------------------------------------
void TableReader::CheckRanges()
{
  const auto check = [this](const char* low, const char* high, double lowest, double highest)
  {
    if (lowest > highest)
    {
      MessageBuilder text;
      text << this->Table.Where << ": " << low << "=\"" << lowest << "\" is above " << high << "=\""
           << highest << "\"; exchange them";
      this->Log.Error(text.str());
    }
  };
  check("yawMin_deg", "yawMax_deg", this->Table.YawMin, this->Table.YawMax);
  check("scaleMin", "scaleMax", this->Table.ScaleMin, this->Table.ScaleMax);
}

//------------------------------------------------------------------------------
void TableReader::ReadModel(const XmlElement& element)
{
  TableModel model;
  model.Part = ReadPart(element, XmlElement(), this->Files);
  element.ReadStored(model);
  const std::string& name = model.Part.Name;
  const auto isSame = [&name](const TableModel& other) { return other.Part.Name == name; };
  if (name.empty())
  {
    this->Log.Error(element.Where() + ": <model> has no id; give the name that rows have for it");
  }
  else if (std::any_of(this->Table.Models.begin(), this->Table.Models.end(), isSame))
  {
    this->Log.Error(element.Where() + ": a second <model id=\"" + name +
      "\"> in one <partTable>; give each an id of its own");
  }
  this->Table.Models.push_back(model);
}

//------------------------------------------------------------------------------
void TableReader::ReadRows()
{
  const bool hasFile = this->Element.Has("file");
  if (hasFile && this->Element.GetChild("row"))
  {
    this->Log.Error(
      this->Table.Where + ": <partTable> has a file and <row> children; give one of them");
    return;
  }
  hasFile ? this->ReadRowFile() : this->ReadRowElements();
  if (this->Table.Rows.empty() && !this->Log.HasError())
  {
    this->Log.Error((hasFile ? this->Table.File : this->Table.Where) +
      ": the table has no rows; give a file with a line of the names of columns, such as "
      "model,x,y, and a line per part, or <row> children");
  }
}

//------------------------------------------------------------------------------
void TableReader::ReadRowElements()
{
  for (const XmlElement& element : this->Element.GetChildren("row"))
  {
    element.CheckNames();
    TableRow row;
    row.Where = element.Where();
    element.ReadStored(row);
    for (const char* name : { "x", "y" })
    {
      if (!element.Has(name))
      {
        this->Log.Error(row.Where + ": <row> has no " + name + "; give the place of the part [m]");
      }
    }
    this->Table.Rows.push_back(row);
  }
}

//------------------------------------------------------------------------------
void TableReader::ReadRowFile()
{
  this->Table.File = this->Files.FindFile(
    { "file", this->Element.GetText("file"), this->Table.Where }, *this->RowDocument);
  if (this->Table.File.empty())
  {
    return;
  }
  // Rows name files from the folder of the table, which is a document of the survey, too.
  this->RowDocument =
    this->Files.Add(XmlDocument::Make(this->Table.File, "<document/>", this->Log));
  RowTable table("row", this->Log);
  table.AddRequired("x", "the place of the part [m]");
  table.AddRequired("y", "the place of the part [m]");
  table.SetSkipsUnknown(true);
  table.ReadFile(this->Table.File,
    [this](const std::string& where) -> void*
    {
      this->Table.Rows.emplace_back().Where = where;
      return &this->Table.Rows.back();
    });
}

//------------------------------------------------------------------------------
/// Adds a model for each file that rows name.
void TableReader::AddFileModels()
{
  std::set<std::string> known = { "" };
  for (const TableModel& model : this->Table.Models)
  {
    known.insert(model.Part.Name);
  }
  for (const TableRow& row : this->Table.Rows)
  {
    if (known.insert(row.Model).second)
    {
      this->AddFileModel(row);
    }
  }
}

//------------------------------------------------------------------------------
void TableReader::AddFileModel(const TableRow& row)
{
  const std::string file = this->Files.FindPath(row.Model, *this->RowDocument);
  const std::string path = file.empty() ? file : std::filesystem::absolute(file).string();
  const std::string text = MakeMeshDocument(path, row.Model);
  if (!text.empty())
  {
    const auto document = XmlDocument::MakeOf(row.Where, text, this->Log);
    const XmlElement part = document->GetRoot().GetChild("scene").GetChild("part");
    TableModel model;
    model.Part = ReadPart(part, XmlElement(), this->Files);
    model.Part.Files = { file };
    model.Share = 0.0;
    this->Table.Models.push_back(model);
    return;
  }
  std::vector<std::string> names;
  for (const TableModel& model : this->Table.Models)
  {
    names.push_back(model.Part.Name);
  }
  this->Log.Error(row.Where + ": model=\"" + Shorten(row.Model) +
    "\" is neither a <model> of the " + "table nor a file with a mesh; " +
    (names.empty() ? "add a <model>, or give the name of a file"
                   : "the models are " + JoinChoices(names)));
}

/// Adds the parts of a <partTable>.
void ReadPartTable(const XmlElement& element, Assets& assets, std::vector<PartData>& parts)
{
  Messages& log = element.GetMessages();
  const int before = log.GetNumberOfErrors();
  const PartTableData table = TableReader(element, assets).Read();
  if (log.GetNumberOfErrors() == before)
  {
    AddTableParts(table, parts, log);
  }
}

/// Checks that every epoch has a part to scan.
void CheckEpochs(const SceneData& scene, Messages& log)
{
  for (int epoch = 1; epoch < CountEpochs(scene); ++epoch)
  {
    const auto isThere = [epoch](const PartData& part) { return FindPart(part, epoch) != nullptr; };
    if (std::none_of(scene.Parts.begin(), scene.Parts.end(), isThere))
    {
      const std::string place = scene.Where.empty() ? "" : scene.Where + ": ";
      const std::string name = scene.Id.empty() ? "the scene" : "scene " + scene.Id;
      log.Error(place + name + " has no part in epoch " + std::to_string(epoch) +
        " (the first is 0): each <swap> has force_null; keep one part");
      return;
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
SceneData ReadScene(const XmlElement& element, Assets& assets, std::vector<XmlElement>* elements)
{
  SceneData scene;
  scene.Where = element.Where();
  scene.File = element.GetDocument().GetPath();
  element.ReadStored(scene);
  scene.Name = element.Has("name") ? scene.Name : scene.Id;
  scene.SpectraFolders = FindSpectraFolders(element.GetDocument(), assets);
  element.CheckNames();
  const std::vector<XmlElement> parts = element.GetChildren("part");
  for (const XmlElement& part : parts)
  {
    AddPart(ReadPart(part, element, assets), scene.Parts);
    elements ? elements->resize(scene.Parts.size(), part) : void();
  }
  const std::vector<XmlElement> tables = element.GetChildren("partTable");
  for (const XmlElement& table : tables)
  {
    ReadPartTable(table, assets, scene.Parts);
  }
  if (parts.empty() && tables.empty() && assets.Scene == AssetNeed::Required)
  {
    element.GetMessages().Error(scene.Where + ": scene " + scene.Id +
      " has no <part>; add one with a loader: " + JoinChoices(GetLoaders()));
  }
  CheckEpochs(scene, element.GetMessages());
  CheckMounts(scene.Parts, element.GetMessages());
  return scene;
}

//------------------------------------------------------------------------------
std::vector<std::string> FindSpectraFolders(const XmlDocument& document, const Assets& assets)
{
  std::vector<std::string> spectra;
  for (const std::string& folder : assets.GetFolders(document))
  {
    spectra.push_back((std::filesystem::path(folder) / "spectra").lexically_normal().string());
  }
  return spectra;
}

} // namespace helios
