// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosDialect.h"

#include "heliosXmlRules.h"
#include "heliosXmlSchema.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosDialect);

namespace
{

/// " <element name>" if it has no note.
std::string Miss(const std::string& element, const std::string& name, const char* note)
{
  return *note ? std::string() : " <" + element + (name.empty() ? "" : " " + name) + ">";
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
