// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAssets.h"

#include "heliosFilePattern.h"
#include "heliosMessages.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <filesystem>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

std::string Join(const std::vector<std::string>& texts)
{
  std::string joined;
  for (const std::string& text : texts)
  {
    joined += (joined.empty() ? "" : ", ") + text;
  }
  return joined;
}

/// Returns the candidate paths of a name, in folder order; an absolute name is the only one.
std::vector<std::string> MakeCandidates(
  const std::string& name, const std::vector<std::string>& folders)
{
  if (fs::path(name).is_absolute())
  {
    return { name };
  }
  std::vector<std::string> candidates;
  for (const std::string& folder : folders)
  {
    const std::string candidate = (fs::path(folder) / name).lexically_normal().string();
    if (std::find(candidates.begin(), candidates.end(), candidate) == candidates.end())
    {
      candidates.push_back(candidate);
    }
  }
  return candidates;
}

bool IsFile(const std::string& path)
{
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

bool IsFolder(const std::string& path)
{
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

} // namespace

//------------------------------------------------------------------------------
Assets::Assets(Messages& messages, std::vector<std::string> directories)
  : Log(messages)
  , Directories(std::move(directories))
{
}

//------------------------------------------------------------------------------
const XmlDocument* Assets::Load(const std::string& path)
{
  const auto found = this->Documents.find(path);
  if (found != this->Documents.end())
  {
    return found->second.get();
  }
  this->Documents[path] = nullptr; // an unreadable file is tried only once
  return this->Add(XmlDocument::Load(path, this->Log));
}

//------------------------------------------------------------------------------
const XmlDocument* Assets::Add(std::shared_ptr<XmlDocument> document)
{
  if (!document)
  {
    return nullptr;
  }
  document->GetRoot().CheckNames();
  auto& place = this->Documents[document->GetPath()];
  place = std::move(document);
  return place.get();
}

//------------------------------------------------------------------------------
std::vector<std::string> Assets::GetDocumentPaths() const
{
  std::vector<std::string> paths;
  for (const auto& document : this->Documents)
  {
    paths.push_back(document.first);
  }
  return paths;
}

//------------------------------------------------------------------------------
std::vector<std::string> Assets::GetFolders(const XmlDocument& from) const
{
  std::vector<std::string> folders;
  for (const std::string& directory : this->Directories)
  {
    folders.push_back(directory);
    folders.push_back((fs::path(directory) / "data").string());
  }
  const std::string own = fs::path(from.GetPath()).parent_path().string();
  folders.push_back(own.empty() ? "." : own);
  folders.emplace_back(".");
  return folders;
}

//------------------------------------------------------------------------------
std::string Assets::FindFile(const XmlValue& name, const XmlDocument& from) const
{
  const std::vector<std::string> candidates = MakeCandidates(
    name.Text, name.Text.empty() ? std::vector<std::string>() : this->GetFolders(from));
  const auto found = std::find_if(candidates.begin(), candidates.end(), IsFile);
  if (found != candidates.end())
  {
    return *found;
  }
  this->Log.Error(name.Where + ": " + name.Name + "=\"" + name.Text +
    "\": no such file; looked for " + (candidates.empty() ? "nothing" : Join(candidates)) +
    ". Correct the name, or add its folder to the asset directories");
  return {};
}

//------------------------------------------------------------------------------
std::string Assets::FindPath(const std::string& name, const XmlDocument& from) const
{
  const std::vector<std::string> candidates =
    MakeCandidates(name, name.empty() ? std::vector<std::string>() : this->GetFolders(from));
  const auto found = std::find_if(candidates.begin(), candidates.end(), IsFile);
  return found != candidates.end() ? *found : std::string();
}

//------------------------------------------------------------------------------
std::vector<std::string> Assets::FindFiles(const XmlValue& pattern, const XmlDocument& from)
{
  const std::string where =
    pattern.Where + ": " + pattern.Name + "=\"" + Shorten(pattern.Text) + "\"";
  const FilePattern expression(pattern.Text);
  if (!expression.GetFault().empty())
  {
    this->Log.Error(where + " is not a valid regular expression: " + expression.GetFault() +
      "; give a folder and an expression for the file name, as in trees/oak_.*[.]obj");
    return {};
  }
  const std::vector<std::string> candidates =
    MakeCandidates(expression.GetFolder(), this->GetFolders(from));
  for (const std::string& candidate : candidates)
  {
    std::vector<std::string> files;
    if (IsFolder(candidate) && !expression.FindFiles(candidate, files))
    {
      this->Log.Error(where + ": " + candidate + " holds more than " +
        std::to_string(FilePattern::MaximumFilesInFolder) +
        " files; put those of the part into a " + "folder of their own");
      return {};
    }
    if (!files.empty())
    {
      return files;
    }
  }
  this->Log.Error(where + ": no file matches; looked in " + Join(candidates) +
    ". Correct the expression, or add the folder to the asset directories");
  return {};
}

//------------------------------------------------------------------------------
XmlElement Assets::FindElement(const char* tag, const XmlElement& from, const char* attribute)
{
  return this->FindElement(
    tag, { attribute, from.GetText(attribute), from.Where(attribute) }, from.GetDocument());
}

//------------------------------------------------------------------------------
XmlElement Assets::FindElement(const char* tag, const XmlValue& reference, const XmlDocument& from)
{
  const std::string& text = reference.Text;
  const std::string where = reference.Where + ": " + reference.Name + "=\"" + text + "\"";
  const std::size_t hash = text.rfind('#');
  const std::string file = hash == std::string::npos ? "" : text.substr(0, hash);
  const std::string id = hash == std::string::npos ? text : text.substr(hash + 1);
  if (file.empty())
  {
    return this->FindElementById(tag, id, from, where);
  }
  const std::string path = this->FindFile({ reference.Name, file, reference.Where }, from);
  const XmlDocument* document = path.empty() ? nullptr : this->Load(path);
  return document ? this->FindElementById(tag, id, *document, where) : XmlElement();
}

//------------------------------------------------------------------------------
XmlElement Assets::FindElementById(
  const char* tag, const std::string& id, const XmlDocument& document, const std::string& where)
{
  std::vector<std::string> ids;
  for (const XmlElement& element : document.GetRoot().GetChildren(tag))
  {
    if (element.Has("id") && element.GetText("id") == id)
    {
      return element;
    }
    if (element.Has("id"))
    {
      ids.push_back(element.GetText("id"));
    }
  }
  const std::string nearest = FindNearestName(id, ids);
  this->Log.Error(where + ": " + document.GetPath() + " has no <" + tag + "> with the id \"" + id +
    "\"; " + (nearest.empty() ? "" : "did you mean " + nearest + "? ") +
    (ids.empty() ? "It has none; refer to another file with file.xml#id"
                 : "Its ids are " + Join(ids)));
  return {};
}

} // namespace helios
