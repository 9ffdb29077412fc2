// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosDialect.h"

#include "heliosInputFile.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFile.h"
#include "heliosXmlFilter.h"
#include "heliosXmlRules.h"
#include "heliosXmlSchema.h"
#include "heliosXmlText.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

vtkStandardNewMacro(vtkHeliosDialect);

namespace
{

constexpr std::size_t MaximumHeaderBytes = 65536; // bytes that are searched for faces

/// Returns " <element name>" if it has no note.
std::string Miss(const std::string& element, const std::string& name, const char* note)
{
  return *note ? std::string() : " <" + element + (name.empty() ? "" : " " + name) + ">";
}

/// Returns whether the header of a PLY file has faces; files without are clouds.
bool HasFaces(const std::string& fileName)
{
  std::string head(MaximumHeaderBytes, '\0');
  std::ifstream file(
    helios::CheckInputFile(fileName).IsOk() ? fileName : std::string(), std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  head.resize(std::min(head.find("\nend_header"), head.size()));
  const std::string key = "\nelement face ";
  const std::size_t found = head.find(key);
  return found != std::string::npos &&
    head.find_first_of("123456789", found + key.size()) < head.find('\n', found + 1);
}

bool IsWritten(const helios::Status& status, helios::Messages& log)
{
  status.IsOk() ? void() : log.Error(status.Message());
  return status.IsOk();
}

} // namespace

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::GetSchema()
{
  return helios::MakeXmlSchema();
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::GetTables()
{
  return helios::MakeXmlTables();
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::FindLoader(const std::string& fileName)
{
  const std::optional<helios::Loader> loader = helios::FindLoader(fileName);
  return loader ? helios::GetLoaderName(*loader) : "";
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::GetMeshEndings()
{
  return helios::GetMeshEndings();
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::GetDocumentEndings()
{
  return ".xml, .yaml, .yml";
}

//------------------------------------------------------------------------------
bool vtkHeliosDialect::IsDocument(const std::string& fileName)
{
  return helios::IsDocument(fileName);
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::ReadXml(const std::string& fileName)
{
  helios::Messages log(this);
  const auto document = helios::XmlDocument::Load(fileName, log);
  return document && !log.HasError() ? helios::ToXmlText(document->GetTree()) : std::string();
}

//------------------------------------------------------------------------------
bool vtkHeliosDialect::WriteXml(const std::string& fileName, const std::string& xml)
{
  helios::Messages log(this);
  const auto document = helios::XmlDocument::Make(fileName, xml, log);
  return document && !log.HasError() &&
    IsWritten(helios::WriteTree(document->GetTree(), fileName), log);
}

//------------------------------------------------------------------------------
bool vtkHeliosDialect::Convert(const std::string& from, const std::string& to)
{
  helios::Messages log(this);
  const auto document = helios::XmlDocument::Load(from, log);
  if (!document || log.HasError())
  {
    return false;
  }
  helios::Messages silent(nullptr); // a file that does not exist keeps its name
  helios::Assets files(silent, {});
  return IsWritten(helios::WriteDocument(*document, files, to), log);
}

//------------------------------------------------------------------------------
bool vtkHeliosDialect::MayHaveSurvey(const std::string& fileName)
{
  return helios::MayHaveSurvey(fileName);
}

//------------------------------------------------------------------------------
bool vtkHeliosDialect::IsMesh(const std::string& fileName)
{
  const std::optional<helios::Loader> loader = helios::FindLoader(fileName);
  return loader && (*loader != helios::Loader::Ply || HasFaces(fileName));
}

//------------------------------------------------------------------------------
std::string vtkHeliosDialect::FindUndescribed()
{
  std::string missed;
  for (const helios::XmlElementRule& rule : helios::GetXmlRules())
  {
    missed += Miss(rule.Name, "", rule.Note);
    for (const helios::XmlValueRule& value : rule.Values)
    {
      missed += Miss(rule.Name, value.Name, value.Note);
    }
    for (const helios::XmlChildRule& child : rule.Children)
    {
      const helios::XmlElementRule* element = helios::FindXmlRule(child.Name);
      missed += Miss(child.Name, "", element ? element->Note : child.Note);
    }
  }
  return missed;
}
