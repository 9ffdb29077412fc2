// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObjScene.h"

#include "heliosMtlFile.h"

#include <vtkIntArray.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

bool IsFile(const fs::path& path)
{
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

// Returns the file named by the whole mtllib line, or else by each of its words.
std::vector<fs::path> FindLibraries(const fs::path& folder, const std::string& names)
{
  std::vector<fs::path> paths{ folder / names };
  if (IsFile(paths[0]))
  {
    return paths;
  }
  std::vector<fs::path> words;
  TextWords text(names);
  for (std::string_view word = text.NextName(); !word.empty(); word = text.NextName())
  {
    words.push_back(folder / word);
  }
  return std::any_of(words.begin(), words.end(), IsFile) ? words : paths;
}

} // namespace

ObjScene::ObjScene(ObjParser& parser, TextReport& report)
  : Parser(parser)
  , Report(report)
{
}

bool ObjScene::ReadMaterials(bool withColors)
{
  MaterialTable& materials = this->Parser.Mesh.Materials;
  MtlFile reader(materials, this->Report);
  reader.SetReadsColors(withColors);
  for (const ObjParser::Statement& library : this->Parser.Libraries)
  {
    if (!this->ReadLibrary(library, reader))
    {
      return false;
    }
  }

  std::vector<int> rows; // per name used
  std::vector<const ObjParser::Statement*> unknown;
  for (const ObjParser::Statement& use : this->Parser.Uses)
  {
    const int row = reader.Find(use.Text);
    rows.push_back(row >= 0 ? row : static_cast<int>(materials.size()));
    if (row < 0)
    {
      materials.emplace_back();
    }
    if (row < 0 && !use.Text.empty())
    {
      materials.back().Name = use.Text;
      unknown.push_back(&use);
    }
  }
  if (!unknown.empty())
  {
    this->Report.Warn(Place(this->Parser.File.GetPath(), unknown[0]->Line) + "unknown material " +
      Quote(unknown[0]->Text) + ", default properties are used (" + std::to_string(unknown.size()) +
      " such names in this file); define it in a mtllib");
  }
  GrowingArray<vtkIntArray>& ids = this->Parser.Mesh.MaterialIds;
  std::for_each(
    ids.GetValues(), ids.GetValues() + ids.GetSize(), [&rows](int& id) { id = rows[id]; });
  this->Cutouts = reader.GetCutouts();
  return true;
}

bool ObjScene::ReadLibrary(const ObjParser::Statement& library, MtlFile& reader)
{
  const fs::path folder = fs::path(this->Parser.File.GetPath()).parent_path();
  for (const fs::path& path : FindLibraries(folder, library.Text))
  {
    if (!IsFile(path))
    {
      this->Report.Warn(Place(this->Parser.File.GetPath(), library.Line) + "material library " +
        path.string() + " does not exist; its materials get default properties");
    }
    else if (!reader.Read(path.string()))
    {
      return false;
    }
  }
  return true;
}

// Counts lines again: line numbers of vertices are not stored.
std::string ObjScene::FindVertexPlace(vtkIdType vertex) const
{
  TextFile file;
  if (!file.Open(this->Parser.File.GetPath()).IsOk())
  {
    return Place(this->Parser.File.GetPath(), 0); // the file was removed in the meantime
  }
  std::string_view line;
  for (vtkIdType count = -1; count < vertex && file.NextLine(line);)
  {
    count += TextWords(line).Next() == "v" ? 1 : 0;
  }
  return file.GetPlace();
}

} // namespace helios
